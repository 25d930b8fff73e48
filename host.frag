#version 450
#extension GL_GOOGLE_include_directive : require
#define AUREOLE_OPENGL
#define AUREOLE_DEFINED_CONSTANTS
#define AUREOLE_SPEC_0 3
#define AUREOLE_SPEC_1 16
#define AUREOLE_SPEC_2 4
#define AUREOLE_SPEC_3 2
#define AUREOLE_SPEC_4 64
#define AUREOLE_SPEC_5 2
#define AUREOLE_SPEC_6 1
#define AUREOLE_SPEC_9 2
#define AUREOLE_SPEC_24 2
#define AUREOLE_SPEC_7 0
#define AUREOLE_SPEC_25 1
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

layout(location = 0) out vec4 result;
layout(location = 1) in vec3 direction;
void main() {
    AureoleAir air = aureole_aerial_perspective(0.5, 0.5, 100.0, direction);
    result.rgb = aureole_sky(direction) * aureole_sky_transmittance(direction) + air.transmittance + air.radiance;
    result.rgb += aureole_sun_transmittance(0, direction) + aureole_sun_irradiance(0, direction) + aureole_sky_irradiance(direction);
    result.a = PI;
}
