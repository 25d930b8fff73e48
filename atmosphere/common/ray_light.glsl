// What is gathered along a ray.
#ifndef AUREOLE_RAY_LIGHT_GLSL
#define AUREOLE_RAY_LIGHT_GLSL

struct RayLight {
    vec3 single[MAX_PHASES];  // single scattering by phase function c, without the value of the phase: 1 per irradiance
    vec3 multiple;            // light scattered twice or more, 1/sr per irradiance
    vec3 depth;               // optical depth of what has been marched
};

RayLight no_light() {
    RayLight light;
    light.multiple = vec3(real(0));
    light.depth = vec3(real(0));
    for (int c = 0; c < MAX_PHASES; ++c) light.single[c] = vec3(real(0));
    return light;
}

#endif
