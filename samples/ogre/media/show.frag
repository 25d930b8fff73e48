#version 430
// The engine's own last step: exposure, a shoulder, and the curve of sRGB.
uniform sampler2D picture;
uniform float exposure;
in vec2 place;
out vec4 shown;

void main() {
    vec3 exposed = vec3(1.0) - exp(-exposure * texture(picture, place).rgb);
    vec3 dark = 12.92 * exposed, bright = 1.055 * pow(exposed, vec3(1.0 / 2.4)) - 0.055;
    shown = vec4(mix(bright, dark, lessThan(exposed, vec3(0.0031308))), 1.0);
}
