/** \file
 * A camera's view of an atmosphere: its tables, the composite, the light for a host's materials. See aureole.h. */
#ifndef AUREOLE_C_VIEW_H
#define AUREOLE_C_VIEW_H

#include <aureole/c/atmosphere.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct aureole_view aureole_view; /**< Made by aureole_create_view. */

/** What a camera's rays are. */
typedef uint32_t aureole_projection;
enum {
    AUREOLE_PROJECTION_MATRIX = 0,   /**< Perspective or orthographic, by aureole_camera::projection. */
    AUREOLE_PROJECTION_PANORAMA = 1, /**< Equirectangular. */
    AUREOLE_PROJECTION_FISHEYE = 2   /**< Equidistant, upper hemisphere. */
};
/** What a projection makes of the near and the far plane. */
typedef uint32_t aureole_depth_range;
enum { AUREOLE_DEPTH_ZERO_TO_ONE = 0, AUREOLE_DEPTH_MINUS_ONE_TO_ONE = 1 };
/** Which row of a picture is the first. */
typedef uint32_t aureole_row_order;
enum {
    AUREOLE_ROWS_TOP_FIRST = 0,   /**< Row 0 is where clip-space y is +1: Vulkan with a viewport of negative height. */
    AUREOLE_ROWS_BOTTOM_FIRST = 1 /**< Where it is -1: Vulkan with a viewport of positive height, whatever the projection. */
};
/** How radiance becomes what a display shows. */
typedef uint32_t aureole_tone_map;
enum { AUREOLE_TONE_MAP_NONE = 0, AUREOLE_TONE_MAP_ACES_FITTED = 1 };
/** How a sun's disk darkens towards its edge. */
typedef uint32_t aureole_limb_darkening;
enum { AUREOLE_LIMB_NONE = 0, AUREOLE_LIMB_NECKEL94 = 1 };

/** What a view makes. Ranges are those of aureole/atmosphere.h and aureole/shadows.h. */
typedef struct aureole_view_settings {
    uint32_t struct_size;
    aureole_projection projection;        /**< Of every camera that the view is given. Default: matrix. */
    uint32_t max_suns;                    /**< In [1, 4]. Default: 1. */
    uint32_t aerial_perspective;          /**< Boolean; default: 1. */
    double aerial_perspective_distance_m; /**< In [1e-3, 1e13]. Default: 96000. */
    uint32_t light;                       /**< Boolean; default: 1. Makes the table of aureole_get_light_table. */
    uint32_t shadow_cascades;             /**< Of the host's shadow map, in [0, 4]. Default: 0, no shadows in the air. */
    double shadow_distance_m;             /**< In [1e-3, 1e13]. Default: 8000. */
    uint32_t shadow_size[3];              /**< Of the volume of losses, each in [2, 256]. Default: 48, 48, 32. */
    uint32_t shadow_samples;              /**< In each slice, in [1, 64]. Default: 4. */
} aureole_view_settings;
AUREOLE_API aureole_result aureole_view_settings_defaults(aureole_view_settings* settings);

/** How a view shows its tables. */
typedef struct aureole_composite_settings {
    uint32_t struct_size;
    aureole_format target_format; /**< Any colour format that the device can write in this way. Default: rgba16_float. */
    uint32_t raster;              /**< Boolean: a draw, not a dispatch. Default: 0. */
    uint32_t scene_color;         /**< Boolean: the host gives its colour. Default: 0. */
    uint32_t scene_depth;         /**< Boolean: the host gives its depth. Default: 0, every pixel is sky. */
    uint32_t sun_disk;            /**< Boolean; default: 1. */
    double sun_lobe_g;            /**< In place of disks a lobe of this mean cosine, in [0, 0.9999]. Default: 0, disks. */
    double exposure;              /**< Multiplies the result before the tone map. In [1e-30, 1e30]. Default: 1. */
    aureole_tone_map tone_map;    /**< Default: none. */
    uint32_t encode_srgb;         /**< Boolean: for rgba8_unorm targets. Default: 0. */
    uint32_t dither;              /**< Boolean; default: 0. */
} aureole_composite_settings;
AUREOLE_API aureole_result aureole_composite_settings_defaults(aureole_composite_settings* settings);

/** NULL settings: as their defaults functions have them. */
AUREOLE_API aureole_result aureole_create_view(aureole_atmosphere* atmosphere, const aureole_view_settings* settings,
                                               const aureole_composite_settings* composite, aureole_view** out_view);
/** NULL: nothing. Its tables die with the frame of aureole_set_frame. */
AUREOLE_API aureole_result aureole_destroy_view(aureole_view* view);

/** Where a view looks from. Any right-handed world axes with the origin at the planet's centre; view space looks along -z.
 * Matrices by columns, as OpenGL and GLM have them: element (row, column) is m[4 * column + row]. */
typedef struct aureole_camera {
    uint32_t struct_size;
    aureole_projection kind;         /**< As aureole_view_settings::projection. Default: matrix. */
    aureole_depth_range depth_range; /**< Default: zero to one. */
    aureole_row_order row_order;     /**< Of target, colour and depth. Default: top first. */
    double position_m[3];            /**< From the planet's centre, at a distance in [1e-6, 1e13]. */
    double view[16];                 /**< World to view; its rotation is used. Default: the identity. */
    double projection[16];           /**< View, in metres, to clip: forward, reversed or infinite. Default: the identity. */
} aureole_camera;
AUREOLE_API aureole_result aureole_camera_defaults(aureole_camera* camera);
/** A camera above the +z pole, as `look` of aureole/camera.h: azimuth from +x counter-clockwise, reversed infinite depth. */
AUREOLE_API aureole_result aureole_look(double bottom_radius_m, double altitude_m, double azimuth_rad, double elevation_rad,
                                        double vertical_fov_rad, double aspect, double near_m, aureole_camera* out_camera);

/** A distant light. */
typedef struct aureole_sun {
    uint32_t struct_size;
    aureole_limb_darkening limb_darkening; /**< Default: neckel94. */
    double direction[3];                   /**< Towards it, of any length. Default: 0, 0, 1. */
    double irradiance[3];      /**< Above the air, facing it: the output's unit follows. In [0, 1e20]. Default: 1. */
    double angular_radius_rad; /**< In [0, pi/4]; 0: no disk. Default: 0.004675. */
} aureole_sun;
AUREOLE_API aureole_result aureole_sun_defaults(aureole_sun* sun);

/** The frame's camera and suns; `suns` all with the struct_size of the first. 0 suns: night. */
AUREOLE_API aureole_result aureole_update_view(aureole_view* view, const aureole_camera* camera, const aureole_sun* suns,
                                               uint32_t sun_count);
/** What of this camera and these suns is outside of the envelope of stability, on the planet of the view. As
 * aureole_envelope_of_air. */
AUREOLE_API aureole_result aureole_envelope_of_view(const aureole_view* view, const aureole_camera* camera,
                                                    const aureole_sun* suns, uint32_t sun_count, aureole_outside* out,
                                                    uint32_t capacity, uint32_t* out_count);
/** In [1e-30, 1e30]. */
AUREOLE_API aureole_result aureole_set_exposure(aureole_view* view, double exposure);

/** The host's shadow map of one sun (aureole/shadows.h). */
typedef struct aureole_shadow_map {
    uint32_t struct_size;
    uint32_t sun;               /**< Which of the suns. Default: 0. */
    aureole_texture texture;    /**< Depth, cascades side by side. 0, the default: nothing is in shadow. */
    double world_to_map[4][16]; /**< Of each cascade, by columns. */
    double bias;                /**< In [0, 1]. Default: 0. */
    uint32_t reversed;          /**< Boolean: depth is less the farther from the sun. Default: 0. */
} aureole_shadow_map;
AUREOLE_API aureole_result aureole_shadow_map_defaults(aureole_shadow_map* map);
/** Whenever it has been drawn anew or its matrices have changed, before aureole_record_view. The texture lives as long as it
 * is set; a texture of 0 ends its use. */
AUREOLE_API aureole_result aureole_set_shadow_map(aureole_view* view, const aureole_shadow_map* map);

/** Textures of one composite, in the states that docs/integration.md lists; left as they came. */
typedef struct aureole_composite_targets {
    uint32_t struct_size;
    uint32_t width, height;      /**< Of all of them. */
    aureole_texture scene_color; /**< With aureole_composite_settings::scene_color; else 0. */
    aureole_texture scene_depth; /**< With aureole_composite_settings::scene_depth; else 0. */
    aureole_texture target;      /**< In STORAGE_WRITE, or COLOR_ATTACHMENT with `raster`. */
} aureole_composite_targets;
AUREOLE_API aureole_result aureole_composite_targets_defaults(aureole_composite_targets* targets);
/** Makes the bindings, once for each set of textures; the 16 used last stay prepared. */
AUREOLE_API aureole_result aureole_prepare_composite(aureole_view* view, const aureole_composite_targets* targets);
/** Before the textures are destroyed. */
AUREOLE_API aureole_result aureole_release_composite(aureole_view* view, const aureole_composite_targets* targets);

/** Each frame: the atmosphere, then its views' tables, then their composites. Timestamps as aureole_record_atmosphere; both
 * functions of a view take the same `first_timestamp`. Nothing is allocated. */
AUREOLE_API aureole_result aureole_record_view(aureole_view* view, aureole_commands* commands, int32_t first_timestamp);
/** To the target, over the scene's colour. After aureole_record_view. */
AUREOLE_API aureole_result aureole_record_composite(aureole_view* view, aureole_commands* commands,
                                                    const aureole_composite_targets* targets, int32_t first_timestamp);
/** This view's recording is never executed: the next one makes its tables anew. */
AUREOLE_API aureole_result aureole_invalidate_view(aureole_view* view);
/** As aureole_atmosphere_reports. */
AUREOLE_API aureole_result aureole_view_reports(const aureole_view* view, aureole_pass_report* out, uint32_t capacity,
                                                uint32_t* out_count);
/** Bytes of device memory of the view's tables. */
AUREOLE_API aureole_result aureole_view_table_bytes(const aureole_view* view, uint64_t* out_bytes);

/** For shaders of the host that include aureole/glsl/aureole.glsl: the `define` lines that go before it, valid until the next
 * call in this thread; and what they bind. 0 where the model or the settings keep no such table. */
AUREOLE_API aureole_result aureole_shader_defines(const aureole_view* view, const char** out_defines);
/** What a host's own shaders bind. */
typedef struct aureole_view_tables {
    uint32_t struct_size;
    aureole_texture transmittance, multi_scatter;                        /**< Of the atmosphere. */
    aureole_texture sky_view, aerial_perspective, light, phase, profile; /**< Of the view. */
    aureole_buffer view_block, air_block;                                /**< Uniform blocks. */
} aureole_view_tables;
/** The same until aureole_set_parameters changes the structure of the air: then ask again. */
AUREOLE_API aureole_result aureole_get_view_tables(const aureole_view* view, aureole_view_tables* out_tables);

/* ---- Light for the host's own materials, on the CPU, from a light table that has been read back. ---- */

/** `texels`: what aureole_read_buffer gave of aureole_view_tables::light, 40 floats for each of max_suns; `count`: of floats.
 */
/** Irradiance at the camera of a surface that faces the sun. */
AUREOLE_API aureole_result aureole_sun_irradiance(const float* texels, uint32_t count, uint32_t sun, double out_rgb[3]);
/** Irradiance that the sky gives a surface with this normal, in world axes and of any length: by all suns. */
AUREOLE_API aureole_result aureole_sky_irradiance(const float* texels, uint32_t count, const double normal[3],
                                                  double out_rgb[3]);
/** Coefficient `index` in [0, 9) of the sky's radiance by one sun, in the order of aureole/light.h. */
AUREOLE_API aureole_result aureole_sky_coefficient(const float* texels, uint32_t count, uint32_t index, uint32_t sun,
                                                   double out_rgb[3]);

#ifdef __cplusplus
}
#endif

#endif
