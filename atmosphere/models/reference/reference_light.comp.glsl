// The light of the path tracer: the integral over the directions that reference_light_paths.comp.glsl has traced.
#include "light/inputs.glsl"

#define AUREOLE_PROFILE_TABLE 10
#define AUREOLE_COLUMN_QUADRATURE quadrature
#define AUREOLE_COLUMN_NODES RAY_NODES
SAMPLER_2D(3, traced_light)
UNIFORMS(11, QuadratureBlock, quadrature)
SPEC_INT(8, RAY_NODES, 16)

#include "models/reference/light_paths.glsl"
#include "transmittance/by_quadrature.glsl"

vec3 traced_radiance(int sun, int index) {
    vec3 sum = vec3(real(0));
    for (int part = 0; part < LIGHT_PARTS; ++part) sum += vec3(texelFetch(traced_light, ivec2(index, sun * LIGHT_PARTS + part), 0));
    return in_rgb(sum);
}
#define AUREOLE_LIGHT_RADIANCE(sun, index, at) traced_radiance(sun, index)

#include "light/light.glsl"
