#version 430
// Land: positions and normals in OGRE's world axes, albedo and the free share of the sky as coordinates.
uniform mat4 world_view_projection;
uniform mat4 world_view;
in vec4 vertex;
in vec3 normal;
in vec4 uv0;
out vec3 world_normal;
out vec4 albedo_and_open_sky;
out float view_depth;

void main() {
    gl_Position = world_view_projection * vertex;
    world_normal = normal;
    albedo_and_open_sky = uv0;
    view_depth = -(world_view * vertex).z;
}
