// Walks through the air, and the suns' light there.
#ifndef AUREOLE_WALK_GLSL
#define AUREOLE_WALK_GLSL

#include "common/view_ray.glsl"
#include "medium/medium.glsl"
#include "phase/phase.glsl"

CONST(int, ALL_SUNS, -1)

// Light of a sun at the top of the air: all suns together, or of one a unit. In wavelengths, which have no colour in RGB, its brightness.
vec3 sunlight(int sun, int only) {
    vec3 irradiance = vec3(view.sun_irradiance[sun]);
    if (IN_TRIPLETS) irradiance = vec3((irradiance.x + irradiance.y + irradiance.z) / 3);
    if (only == ALL_SUNS) return irradiance;
    return vec3(only == sun ? real(1) : real(0));
}
// What the suns' light makes of light per unit of it. All together: in RGB, so that suns of several colours add up.
vec3 lit_by(int sun, int only, vec3 light) {
    if (IN_TRIPLETS && only == ALL_SUNS) return sunlit(sun, light);
    return light * sunlight(sun, only);
}

// A point in the air and a direction there.
struct Walk {
    real altitude;
    vec3 up;         // unit, from the planet's centre, world axes
    vec3 direction;  // unit, away from the camera
    real mu;         // cosine between the two
};

// The walk of a camera's ray: where it enters the air, or misses it.
struct CameraWalk {
    Walk walk;
    bool met;
};
CameraWalk camera_walk(vec3 direction, ViewDirection v) {
    CameraWalk result;
    real entry = distance_to_air(v);
    result.met = entry >= 0;
    Ray ray = air_ray(v, max(entry, real(0)), 0, real(0));
    result.walk.altitude = ray.altitude;
    result.walk.mu = ray.mu;
    result.walk.direction = direction;
    vec3 there = (bottom_radius() + view.space.x) * vec3(view.up) + max(entry, real(0)) * direction;
    result.walk.up = view.camera.w > real(0.5) ? normalize(there) : vec3(view.up);
    return result;
}

// After a distance t, with the zenith cosine that belongs to it.
Walk walk_on(Walk walk, real t, bool ground) {
    Walk next;
    next.altitude = ground ? real(0) : min(altitude_after(walk.altitude, walk.mu, t), shell_thickness());
    next.up = normalize((bottom_radius() + walk.altitude) * walk.up + t * walk.direction);
    next.direction = walk.direction;
    next.mu = dot(next.up, next.direction);
    return next;
}

// What air sends on along a direction of the light of a sun, 1/km per steradian.
vec3 scattered_to(Medium air, vec3 direction, vec3 towards) {
    real nu = dot(direction, towards);
    vec3 scattered = vec3(real(0));
    for (int c = 0; c < PHASE_COUNT; ++c) scattered += air.scattering[c] * phase_value(c, nu);
    return scattered;
}

#endif
