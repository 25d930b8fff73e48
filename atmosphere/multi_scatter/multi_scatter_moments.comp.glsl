// Second half of a pass: projects the rays of each node on the harmonics, writes the moments of this order of scattering (the
// source of the next pass) and adds them to the sum of all orders. In the last pass the orders that are left out are added as a
// geometric series, whose ratio is that of the last two orders at each node.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/energy.glsl"
#include "common/specialization.glsl"

UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, QuadratureBlock, zenith_quadrature)
SAMPLER_2D(2, rays)
SAMPLER_2D(3, previous_order)
SAMPLER_2D(4, previous_sum)
IMAGE_2D(5, order_out)
IMAGE_2D(6, sum_out)

struct MultiScatterPass {
    vec4 flags;  // x: 1 in the first pass (nothing came before), y: 1 in the last, z: greatest ratio of orders to extrapolate with
};
PUSH_CONSTANTS(MultiScatterPass, pass)

#include "multi_scatter/multi_scatter.glsl"
#include "multi_scatter/directions.glsl"

LOCAL_SIZE(32, 1, 1)

// The orders left out, relative to this one: r + r^2 + ... with r the ratio of the last two orders.
vec3 remaining_orders(vec3 current, vec3 before) {
    vec3 ratio = clamp(current / max(before, vec3(LEAST_RADIANCE)), vec3(real(0)), vec3(pass.flags.z));
    return ratio / (vec3(real(1)) - ratio);
}

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(sum_out);
    if (id.x >= size.x || id.y >= size.y) return;
    int rows = (size.y - 1) / moment_count();
    int layer = id.y / rows;
    int row = id.y % rows;
    bool first = pass.flags.x > real(0.5);
    bool last = pass.flags.y > real(0.5);
    bool ground = layer == moment_count();
    int l = 0;
    while (moments_up_to(l) <= layer && !ground) ++l;
    int m = ground ? 0 : layer - moment_layer(l, 0);

    real altitude = altitude_at(texel_to_unit(row, rows));
    vec3 total = vec3(real(0));    // integral of L
    vec3 moment = vec3(real(0));   // integral of L y_lm, or the irradiance of the ground
    real norm = harmonic_norm(l, m);
    for (int q = 0; q < direction_count(); ++q) {
        ScatterDirection direction = scatter_direction(q, altitude);
        vec3 radiance = vec3(texelFetch(rays, ivec2(id.x, q * rows + row), 0)) * direction.solid_angle;
        real x = direction.azimuth_cosine * sqrt(max((1 - direction.mu) * (1 + direction.mu), real(0)));
        total += radiance;
        moment += ground ? radiance * max(direction.mu, real(0)) : radiance * (norm * norm * harmonic(l, m, direction.mu, x));
    }
    vec3 least = vec3(LEAST_RADIANCE);
    vec3 mean = max(total / (4 * PI), least);
    real bound = norm * sqrt(real(2 * l + 1));  // |y_lm| <= sqrt(2 l + 1) by the addition theorem
    vec3 ratio = clamp(moment / max(total, least), vec3(-bound), vec3(bound));
    vec3 irradiance = max(moment, least);
    vec4 order = vec4(layer == 0 ? log(mean) : (ground ? log(irradiance) : ratio), real(0));
    imageStore(order_out, ivec2(id.x, id.y), order);

    // Sum of orders: means and irradiances add; ratios are weighted with their means.
    vec3 sum_mean = mean;
    vec3 value = ground ? irradiance : ratio * mean;
    if (last && !first) {
        vec3 before = exp(vec3(texelFetch(previous_order, ivec2(id.x, ground ? id.y : row), 0)));
        vec3 more = vec3(real(1)) + remaining_orders(ground ? irradiance : mean, before);
        sum_mean *= more;
        value *= more;
    }
    if (!first) {
        vec3 sum_before = exp(vec3(texelFetch(previous_sum, ivec2(id.x, row), 0)));
        vec3 value_before = vec3(texelFetch(previous_sum, ivec2(id.x, id.y), 0));
        sum_mean += sum_before;
        value += ground ? exp(value_before) : value_before * sum_before;
    }
    // What all orders add up to. Light from all of a hemisphere is pi times its radiance.
    vec3 most_mean = vec3(last ? MOST_MEAN_RADIANCE : real(1e30));
    vec3 most_irradiance = vec3(last ? PI * MOST_MEAN_RADIANCE : real(1e30));
    vec3 stored = layer == 0 ? log(min(sum_mean, most_mean)) : (ground ? log(min(value, most_irradiance)) : value / sum_mean);
    imageStore(sum_out, ivec2(id.x, id.y), vec4(stored, real(0)));
}
