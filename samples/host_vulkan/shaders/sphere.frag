// Glass balls: transparents, which the composite does not know. They are lit, reflect the sky, and stand in the air by look-ups of
// Aureole's include. Shadows in the air before them are marched through the host's own map.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sunlit.glsl"
#define AUREOLE_SET 1
#define AUREOLE_SUN_VISIBILITY(offset_m) sunlit(offset_m, vec3(0))
#include "aureole.glsl"

layout(constant_id = 1000) const bool SHAFTS = false;  // the composite takes shadows from the air, so do we

layout(location = 0) in vec3 offset;
layout(location = 1) flat in vec4 sphere;
layout(location = 0) out vec4 color;  // premultiplied

const vec3 TINT = vec3(0.35, 0.62, 0.58);

vec3 surface(vec3 place, vec3 direction, vec3 n, float fresnel) {
    vec3 mirrored = reflect(direction, n);
    vec3 light = fresnel * aureole_sky(mirrored);
    vec3 frosted = aureole_sky_irradiance(n);
    for (int s = 0; s < int(frame.counts.x); ++s) {
        vec3 sun = aureole_sun_irradiance(s, place) * (s == 0 ? sunlit(place, 1.5 * n) : 1.0);
        frosted += sun * max(dot(n, frame.suns[s].xyz), 0.0);
        light += sun * fresnel * 40.0 * pow(max(dot(mirrored, frame.suns[s].xyz), 0.0), 500.0);
    }
    return light + 0.25 * (1.0 - fresnel) * TINT / radians(180.0) * frosted;
}

void main() {
    vec3 direction = normalize(offset);
    float middle = dot(sphere.xyz, direction);
    vec3 aside = sphere.xyz - middle * direction;
    float inside = sphere.w * sphere.w - dot(aside, aside);
    if (inside < 0.0) discard;
    float far = middle - sqrt(inside);
    vec3 place = far * direction, n = (place - sphere.xyz) / sphere.w;
    vec4 clip = frame.camera_to_clip * vec4(place, 1);
    gl_FragDepth = clip.z / clip.w;

    float fresnel = 0.04 + 0.96 * pow(1.0 - max(dot(-direction, n), 0.0), 5.0);
    float alpha = mix(0.45, 1.0, fresnel);
    AureoleAir air = aureole_aerial_perspective(gl_FragCoord.x * frame.counts.y, gl_FragCoord.y * frame.counts.z, far, direction);
    vec3 between = air.radiance;
    if (SHAFTS) between = max(between - aureole_march(0, direction, 0.0, far, 16, 0.5).loss, vec3(0));
    // What is behind has its air already: before the share that the ball covers stands the air before the ball.
    color = vec4(surface(place, direction, n, fresnel) * air.transmittance + between * alpha, alpha);
}
