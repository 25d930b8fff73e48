#version 450
#extension GL_GOOGLE_include_directive : require
#define AUREOLE_SET 2
#define AUREOLE_DEFINED_CONSTANTS
#include "aureole.glsl"
#include "aureole.glsl"

const float PI = 3.0, SUN_COUNT = 17.0;
struct Ray { vec2 origin; };
struct AerialPerspective { float haze; };
vec3 sky_view_layer(float x) { return vec3(x); }
float bottom_radius() { return 1.0; }
float visible_share(Ray ray) { return ray.origin.x; }
#define real(x) (2.0 * (x))
#define SAMPLE 7
#define CONST 1

layout(local_size_x = 64) in;
layout(constant_id = 5) const int COLUMNS = 7;  // ids are the host's own: the include takes none
layout(std430, set = 0, binding = 0) readonly buffer Questions { vec4 questions[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { vec4 answers[]; };

void main() {
    uint view = gl_GlobalInvocationID.x;
    if (3 * view >= questions.length()) return;
    vec4 ray = questions[3 * view], place = questions[3 * view + 1];
    vec3 atm = questions[3 * view + 2].xyz;
    int sun = int(place.z);
    AureoleAir air = aureole_aerial_perspective(place.x, place.y, ray.w, ray.xyz);
    uint at = COLUMNS * view;
    answers[at] = vec4(aureole_sky(ray.xyz), 1);
    answers[at + 1] = vec4(aureole_sky_transmittance(ray.xyz), 1);
    answers[at + 2] = vec4(air.transmittance, 1);
    answers[at + 3] = vec4(air.radiance, 1);
    answers[at + 4] = vec4(aureole_sun_transmittance(sun, atm), 1);
    answers[at + 5] = vec4(aureole_sun_irradiance(sun, atm), 1);
    answers[at + 6] = vec4(aureole_sky_irradiance(ray.xyz), 1);
}
