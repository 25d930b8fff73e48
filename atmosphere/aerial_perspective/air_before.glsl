// What the air before a point does to it, by whichever model.
#ifndef AUREOLE_AIR_BEFORE_GLSL
#define AUREOLE_AIR_BEFORE_GLSL

struct AerialPerspective {
    vec3 transmittance;
    vec3 radiance;  // times the suns' irradiance
};

#endif
