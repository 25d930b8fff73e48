#version 450
#extension GL_GOOGLE_include_directive : require
#include "sunlit.glsl"
#define AUREOLE_SET 1
#include "aureole.glsl"

layout(location = 0) in vec3 offset;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 albedo;
layout(location = 0) out vec4 color;

// Light alone: the air before the land is the composite's.
void main() {
    vec3 n = normalize(normal);
    vec3 irradiance = aureole_sky_irradiance(n) * albedo.w;
    vec3 on_the_flat = aureole_sky_irradiance(frame.up.xyz);
    for (int s = 0; s < int(frame.counts.x); ++s) {
        vec3 sun = aureole_sun_irradiance(s, offset);
        float shadow = s == 0 ? softly_sunlit(offset, n) : 1.0;
        irradiance += sun * max(dot(n, frame.suns[s].xyz), 0.0) * shadow;
        on_the_flat += sun * max(dot(frame.up.xyz, frame.suns[s].xyz), 0.0);
    }
    irradiance += (1.0 - albedo.w) * albedo.rgb * on_the_flat;  // what hides the sky is lit, too
    color = vec4(albedo.rgb / radians(180.0) * irradiance, 1);
}
