#version 430
in vec4 vertex;
in vec2 uv0;
out vec2 place;

void main() {
    gl_Position = vec4(vertex.xy, 0.0, 1.0);
    place = uv0;
}
