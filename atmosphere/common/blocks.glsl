// The uniform blocks of the module, as GLSL and C++ both see them. Lengths in km, coefficients in 1/km: floats near 1.
// Only vec4 and mat4, so that std140, std430 and C++ agree, and so that the CPU can widen them to double.
#ifndef AUREOLE_BLOCKS_GLSL
#define AUREOLE_BLOCKS_GLSL

CONST(int, MAX_TERMS, 16)
CONST(int, MAX_PHASES, 4)
CONST(int, MAX_SUNS, 4)
CONST(int, MAX_NODES, 16)

// The air and the ground.
struct AtmosphereBlock {
    vec4 radii;         // x: bottom radius, y: top radius, z: shell thickness (top - bottom), w: sqrt(top^2 - bottom^2); km
    vec4 ground_albedo; // rgb
    vec4 sun_mapping;   // multi-scatter axis of the sun cosine (multi_scatter.glsl): x: centre, y: width, z: u at -1, w: u at +1
    vec4 tables;        // x: rows of the profile table, y: highest altitude of the profile table in km; z: stretch of the
                        // tables' axis of altitude (geometry.glsl)
    // Density terms. profile: x..z parameters by kind (medium.glsl), w: row of the profile table.
    vec4 term_profile[MAX_TERMS];
    vec4 term_scattering[MAX_TERMS];  // rgb, 1/km
    vec4 term_extinction[MAX_TERMS];  // rgb, 1/km
    // Distinct phase functions: parameters by kind (phase.glsl).
    vec4 phase_parameters[MAX_PHASES];
    // Legendre moments: p_l of phase c is component l % 4 of phase_moments[3 * c + l / 4]; l = 0 .. 11.
    vec4 phase_moments[3 * MAX_PHASES];
};

// Gauss-Legendre rule of N <= 16 nodes on (0, 1) for the integral over u, with the matrix of its running integrals.
struct QuadratureBlock {
    vec4 node[MAX_NODES];    // x: u_j, y: weight w_j
    vec4 running[64];        // M(k, j) = integral from 0 to u_k of the j-th Lagrange polynomial: component j % 4 of [4 k + j / 4]
};

// A shadow map (shadows.h).
struct ShadowBlock {
    vec4 world_to_map[16];  // row r of cascade i: [4 i + r]; from km relative to the camera, world axes
    vec4 depth;             // x: 1, or -1 if depth falls with the distance from the sun; y: bias; z, w: unused
};

// Three of N wavelengths (triplet.glsl): column c of their matrix to linear Rec.709 per unit of the sun's own colour. w: of the first
// 1 if they are the first three, of the second 1 if they are the last, else 0.
struct TripletBlock {
    vec4 to_rgb[3];
};

// A camera, its suns, and what follows from them in double precision on the host.
struct ViewBlock {
    vec4 camera;        // x: altitude in the air, km (0 .. shell thickness); y, z: unused; w: 1 if the camera is above the
                        // atmosphere, else 0
    vec4 space;         // the camera above the atmosphere: x: its altitude, km; y: dip of the atmosphere's top seen from there,
                        // rad; z: dip of the ground's horizon seen from there, rad; w: unused. Inside: x as camera.x, y: -pi/2.
    vec4 horizon;       // x, y: cosine and sine of the dip of the ground's horizon (space.z); z, w: 1 / chord of the angle that the
                        // sky-view table spans above and below it (sky_view.glsl)
    vec4 up;            // unit vector from the planet's centre to the camera, world axes
    vec4 east;          // a horizontal unit vector, world axes: stands in where a direction has no azimuth
    // Rays of the target's point (x, y), each in [0, 1], from the first row's first corner; world axes, by kind:
    //   matrix: direction = ray_origin + x ray_x + y ray_y. Perspective: not normalized, its component along the view axis is 1,
    //     so that distance = view depth * length. Orthographic: the same unit vector everywhere.
    //   panorama, with a = (2 x - 1) pi and e = (1/2 - y) pi:
    //     direction = cos(e) (cos(a) ray_origin + sin(a) ray_x) + sin(e) ray_y.
    //   fisheye, with (p, q) in the inscribed unit circle, p along rows, q towards the first row, z = |(p, q)| pi/2:
    //     direction = sin(z) (p ray_x + q ray_origin) / |(p, q)| + cos(z) ray_y. Not mirrored: the sky as seen from below.
    //   The host has turned the vectors for either order of rows.
    vec4 ray_origin, ray_x, ray_y;  // ray_origin.w: kind: 0 matrix, 1 panorama, 2 fisheye
    vec4 depth;         // view depth along the view axis, km = (x * d + y) / (z * d + w), d in [0, 1]; +infinity where d tells nothing
    vec4 froxels;       // x: distance of the last slice, km; y: 1 / x; z: 1 / distance of the last slice of shadows; w: their sun
    // By sun: what its layers of the tables are multiplied by so that twilight does not vanish in half floats, and the inverse.
    vec4 table_exposure, table_exposure_inverse;
    vec4 composite;     // x: exposure; y: mean cosine of the suns' lobe; z: stored depth of the far end, 0 or 1: where nothing was drawn; w: unused
    // Suns. direction: world axes, w: cosine of the zenith angle at the camera (mu_s).
    vec4 sun_direction[MAX_SUNS];
    vec4 sun_azimuth[MAX_SUNS];     // unit horizontal vector towards the sun, world axes; w: sine of the zenith angle
    vec4 sun_irradiance[MAX_SUNS];  // rgb; w: count of suns (same in all)
    // The disk, by the squared chord c = |v - sun|^2 of unit vectors (4 sin^2 of half the angle, exact in float): inside where
    // c < sun_limb.w, there radiance = irradiance * sun_disk.rgb * pow(mu, sun_limb.rgb) with mu = sqrt(1 - c * sun_disk.w). Its
    // integral over the disk is the irradiance.
    vec4 sun_disk[MAX_SUNS];        // rgb: radiance at the centre per irradiance, 1/sr; w: 1 / sun_limb.w (0: no disk)
    vec4 sun_limb[MAX_SUNS];        // rgb: exponent of limb darkening (0: none); w: squared chord of the radius (0: no disk)
};

#endif
