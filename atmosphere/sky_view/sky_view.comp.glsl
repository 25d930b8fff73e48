// Fills the sky-view table (sky_view.glsl): one ray a texel, marched once for all layers.
#include "common/constants.glsl"
#include "common/blocks.glsl"
#include "common/specialization.glsl"

#define AUREOLE_PROFILE_TABLE 2
#define AUREOLE_PHASE_TABLE 7
#define AUREOLE_TRANSMITTANCE_TABLE
#define AUREOLE_MULTI_SCATTER_TABLE
UNIFORMS(0, AtmosphereBlock, atm)
UNIFORMS(1, QuadratureBlock, quadrature)
SAMPLER_2D(3, transmittance_table)
SAMPLER_2D(4, multi_scatter_table)
UNIFORMS(5, ViewBlock, view)
IMAGE_2D(6, sky_view_out)
SPEC_INT(8, RAY_NODES, 8)
CONST(bool, SINGLE_SCATTERING, true)
CONST(bool, MULTIPLE_SCATTERING, true)

#include "common/march.glsl"
#include "sky_view/sky_view.glsl"

LOCAL_SIZE(32, 2, 1)

// A ray of the camera, `angle` away from the horizon, moved to where it enters the shell if the camera is above it.
//
// With e the elevation of the ray, the tangent point's altitude p - R = r cos(e) - R is, for a ray `angle` above the horizon
// seen under the dip d (r cos d = R), r (cos(d - angle) - cos d) = 2 r sin(d - angle / 2) sin(angle / 2): no cancellation, so
// the limb is exact from any distance. On the shell's top mu^2 = 1 - (p / T)^2 = (T - p) (T + p) / T^2.
Ray camera_ray(real angle, real azimuth_cosine, int sun) {
    bool space = view.camera.w > real(0.5);
    real dip = space ? view.space.z : view.camera.z;
    real elevation = angle - dip;
    real mu = sin(elevation);
    real sine = cos(elevation);
    Ray ray;
    ray.ground = angle < 0;
    ray.mu_s = view.sun_direction[sun].w;
    ray.nu = clamp(mu * ray.mu_s + sine * view.sun_azimuth[sun].w * azimuth_cosine, real(-1), real(1));
    ray.altitude = view.camera.x;
    ray.mu = mu;
    if (space) {
        real radius = bottom_radius();
        real top = radius + shell_thickness();
        real r = radius + view.space.x;
        real lowest = 2 * r * sin(dip - real(0.5) * angle) * sin(real(0.5) * angle);
        real half_chord = sqrt(max((shell_thickness() - lowest) * (top + radius + lowest), real(0)));
        real t = max(-r * mu - half_chord, real(0));
        ray.altitude = shell_thickness();
        ray.mu = -half_chord / top;
        ray.mu_s = clamp((r * ray.mu_s + t * ray.nu) / top, real(-1), real(1));
    }
    // The horizon itself belongs to the upper side: its ray passes the ground at height 0.
    ray.end = ray.ground ? distance_to_ground(ray.altitude, ray.mu) : distance_to_top(ray.altitude, ray.mu);
    return ray;
}

COMPUTE_MAIN(id) {
    ivec2 size = imageSize(sky_view_out);
    int rows = size.y / (SUN_COUNT * sky_view_layers());
    int sun = id.y / rows;
    if (id.x >= size.x || sun >= SUN_COUNT) return;
    int row = id.y % rows;
    int half_rows = rows / 2;
    bool below = row < half_rows;
    real position = texel_to_unit(below ? row : row - half_rows, half_rows);
    real angle = sky_view_angle(position, below ? sky_view_lower_range() : sky_view_upper_range());

    Ray ray = camera_ray(below ? -angle : angle, sky_view_azimuth_cosine(texel_to_unit(id.x, size.x)), sun);
    ray.ground = below;
    if (below) ray.end = distance_to_ground(ray.altitude, ray.mu);
    RayLight light = march(ray);
    vec3 radiance = light.multiple;
    if (below) {
        real ground_mu_s = sun_mu_after(ray, ray.end, real(0));
        vec3 irradiance = max(ground_mu_s, real(0)) * transmittance_to_sun(real(0), ground_mu_s) + ground_diffuse_irradiance(ground_mu_s);
        radiance += exp(-light.depth) * (vec3(atm.ground_albedo) / PI) * irradiance;
    }
    real exposure = view.froxels.z;
    int base = sun * sky_view_layers() * rows + row;
    int layer = 1;
    for (int c = 0; c < PHASE_COUNT; ++c) {
        if (phase_is_sharp(c)) {
            imageStore(sky_view_out, ivec2(id.x, base + layer * rows), vec4(light.single[c] * exposure, real(0)));
            ++layer;
        } else {
            radiance += light.single[c] * phase_function(phase_kind(c), atm.phase_parameters[c], ray.nu);
        }
    }
    imageStore(sky_view_out, ivec2(id.x, base), vec4(radiance * exposure, real(0)));
}
