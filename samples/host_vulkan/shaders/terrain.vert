#version 450
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 albedo;
layout(location = 0) out vec3 out_offset;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_albedo;
invariant gl_Position;  // the same in the depth pass and in the picture

void main() {
    out_offset = position + frame.mesh_origin.xyz;
    out_normal = normal;
    out_albedo = albedo;
    gl_Position = frame.camera_to_clip * vec4(out_offset, 1);
}
