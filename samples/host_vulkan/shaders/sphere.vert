#version 450
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"

layout(location = 0) out vec3 out_offset;  // of a place on the square that hides the sphere
layout(location = 1) flat out vec4 out_sphere;

void main() {
    vec4 sphere = frame.spheres[gl_InstanceIndex];
    float far = length(sphere.xyz);
    vec3 forward = sphere.xyz / far;
    vec3 right = normalize(cross(forward, frame.up.xyz)), top = cross(right, forward);
    float half_side = sphere.w * far / sqrt(max(far * far - sphere.w * sphere.w, 1e-3 * far * far));
    vec2 corner = 2.0 * vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1) - 1.0;
    if (gl_VertexIndex > 2) corner = vec2(gl_VertexIndex == 4 ? -1.0 : 1.0, gl_VertexIndex == 3 ? -1.0 : 1.0);
    out_offset = sphere.xyz + half_side * (corner.x * right + corner.y * top);
    out_sphere = sphere;
    gl_Position = frame.camera_to_clip * vec4(out_offset, 1);
}
