// N wavelengths where light is computed for each pixel: a kernel runs once for every three of them, in the places of red, green and
// blue, and adds its part to what the triplets before have left. Light of three wavelengths becomes linear Rec.709, per unit of the
// sun's own colour, before anything multiplies it that is RGB: a sun's irradiance, the host's picture behind the air.
//
// Needs `view`. Where IN_TRIPLETS is false a kernel runs once, on red, green and blue, and nothing here changes any of them.
#ifndef AUREOLE_TRIPLET_GLSL
#define AUREOLE_TRIPLET_GLSL

#include "common/blocks.glsl"
#include "common/to_rec709.glsl"

UNIFORMS(15, TripletBlock, triplet)
SPEC_BOOL(52, IN_TRIPLETS, false)

bool first_triplet() { return !IN_TRIPLETS || triplet.to_rgb[0].w > 0; }
bool last_triplet() { return !IN_TRIPLETS || triplet.to_rgb[1].w > 0; }

// What the triplet adds of light that the air sends, or of the share of light that it lets through.
vec3 in_rgb(vec3 light) {
    if (!IN_TRIPLETS) return light;
    return to_rec709(light, triplet.to_rgb[0], triplet.to_rgb[1], triplet.to_rgb[2]);
}
#define AUREOLE_IN_RGB(light) in_rgb(light)

// Of light per unit of a sun's irradiance.
vec3 sunlit(int sun, vec3 light) { return vec3(view.sun_irradiance[sun]) * in_rgb(light); }

// RGB that no air has touched is not in parts: the last triplet has all of it.
vec3 whole(vec3 color) { return last_triplet() ? color : vec3(real(0)); }

#endif
