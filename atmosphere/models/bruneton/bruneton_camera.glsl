// Rays of the camera through the air.
#ifndef AUREOLE_BRUNETON_CAMERA_GLSL
#define AUREOLE_BRUNETON_CAMERA_GLSL

#include "common/view_ray.glsl"
#include "models/bruneton/bruneton_rays.glsl"

// The camera's ray through the air, from where it enters it.
Ray camera_air_ray(ViewDirection v, real entry, int sun, real nu) {
    Ray ray = air_ray(v, max(entry, real(0)), sun, clamp(nu, real(-1), real(1)));
    ray.ground = sine_above_horizon(v) < 0;
    ray.end = ray.ground ? distance_to_ground(ray.altitude, ray.mu) : distance_to_top(ray.altitude, ray.mu);
    return ray;
}

#endif
