// The host's own bindings. Offsets are metres from the camera along world axes: what Aureole's look-ups take.
#ifndef HOST_FRAME_GLSL
#define HOST_FRAME_GLSL

const int CASCADES = 3;

layout(set = 0, binding = 0, std140) uniform Frame {
    mat4 camera_to_clip;
    mat4 camera_to_map[CASCADES];  // (u, v) across each cascade, depth
    vec4 mesh_origin;              // offset of the mesh's origin
    vec4 up;                       // at the camera
    vec4 suns[4];                  // unit directions
    vec4 texel_m;                  // of each cascade
    vec4 counts;                   // suns, 1 / width, 1 / height, number of the frame
    vec4 spheres[8];               // centre, radius
} frame;
layout(set = 0, binding = 1) uniform sampler2DShadow cascades;

#endif
