// Rays of the camera through the air.
#ifndef AUREOLE_BRUNETON_CAMERA_GLSL
#define AUREOLE_BRUNETON_CAMERA_GLSL

#include "common/view_ray.glsl"
#include "models/bruneton/bruneton_rays.glsl"

#endif
