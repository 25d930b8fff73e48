/** \file
 * Devices: the CPU, Vulkan of Aureole's own or of a host's; textures, buffers and lists of commands. See aureole.h. */
#ifndef AUREOLE_C_DEVICE_H
#define AUREOLE_C_DEVICE_H

#include <aureole/c/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A device, whatever it stands on. */
typedef struct aureole_device aureole_device;
/** A list of commands that is being recorded. The device's own: never destroyed by the caller. */
typedef struct aureole_commands aureole_commands;
/** Objects of a device. 0 is none. Never used again for another object while the device lives. */
typedef uint64_t aureole_texture;
typedef uint64_t aureole_buffer; /**< A buffer of a device; as aureole_texture. */

/** Texel formats; of floats scene-linear. */
typedef uint32_t aureole_format;
enum {
    AUREOLE_FORMAT_UNDEFINED = 0,
    AUREOLE_FORMAT_R8_UNORM = 1,
    AUREOLE_FORMAT_RGBA8_UNORM = 2,
    AUREOLE_FORMAT_RGBA8_SRGB = 3,
    AUREOLE_FORMAT_BGRA8_UNORM = 4,
    AUREOLE_FORMAT_R16_FLOAT = 5,
    AUREOLE_FORMAT_RG16_FLOAT = 6,
    AUREOLE_FORMAT_RGBA16_FLOAT = 7,
    AUREOLE_FORMAT_R32_FLOAT = 8,
    AUREOLE_FORMAT_RG32_FLOAT = 9,
    AUREOLE_FORMAT_RGBA32_FLOAT = 10,
    AUREOLE_FORMAT_R11G11B10_FLOAT = 11,
    AUREOLE_FORMAT_D32_FLOAT = 12
};
/** What a texture or buffer may be used for; or-ed together. */
typedef uint32_t aureole_usage;
enum {
    AUREOLE_USAGE_SAMPLED = 1,          /**< Read through a sampler. */
    AUREOLE_USAGE_STORAGE = 2,          /**< Texture written by compute shaders. */
    AUREOLE_USAGE_COLOR_ATTACHMENT = 4, /**< Target of draws. */
    AUREOLE_USAGE_COPY_SOURCE = 8,
    AUREOLE_USAGE_COPY_DESTINATION = 16,
    AUREOLE_USAGE_CONSTANTS = 32, /**< Buffer read as a uniform block. */
    AUREOLE_USAGE_READ_BACK = 64, /**< Buffer whose bytes the CPU reads. Implies COPY_DESTINATION. */
    AUREOLE_USAGE_UPLOAD = 128    /**< Buffer whose bytes the CPU writes. Implies COPY_SOURCE, its first state. */
};
/** What a resource is being used for right now: docs/rhi.md. Barriers move it from one to another. */
typedef uint32_t aureole_state;
enum {
    AUREOLE_STATE_UNDEFINED = 0, /**< Contents may be thrown away. */
    AUREOLE_STATE_SAMPLED = 1,
    AUREOLE_STATE_DEPTH_READ = 2, /**< A depth texture sampled by shaders. */
    AUREOLE_STATE_STORAGE_WRITE = 3,
    AUREOLE_STATE_COLOR_ATTACHMENT = 4,
    AUREOLE_STATE_COPY_SOURCE = 5,
    AUREOLE_STATE_COPY_DESTINATION = 6,
    AUREOLE_STATE_CONSTANTS = 7,
    AUREOLE_STATE_GENERAL = 8 /**< Of a lent texture whose state has no name here. */
};
/** Shape of a texture. */
typedef uint32_t aureole_dimension;
enum { AUREOLE_2D = 0, AUREOLE_3D = 1, AUREOLE_CUBE = 2 };

/* ---- Making devices. ---- */

/** Arithmetic of the CPU backend. */
typedef uint32_t aureole_precision;
enum {
    AUREOLE_FLOAT32 = 0, /**< Mirrors a GPU. */
    AUREOLE_FLOAT64 = 1  /**< The reference: double arithmetic, nothing rounded in textures. */
};
/** A device on the CPU. */
typedef struct aureole_cpu_device_desc {
    uint32_t struct_size;
    aureole_precision precision; /**< Default: float32. */
    uint32_t threads;            /**< 1 to 1024; 0, the default: all that the process may use. */
} aureole_cpu_device_desc;
AUREOLE_API aureole_result aureole_cpu_device_desc_defaults(aureole_cpu_device_desc* desc);
/** The CPU backend, with a queue of its own. */
AUREOLE_API aureole_result aureole_create_cpu_device(const aureole_cpu_device_desc* desc, aureole_device** out_device);

/** A Vulkan device of Aureole's own: for tools and tests. A host lends its own with aureole_borrow_vulkan_device. */
typedef struct aureole_vulkan_device_desc {
    uint32_t struct_size;
    int32_t index;       /**< In the loader's order; -1, the default: the best that works. */
    const char* name;    /**< Part of the device's name, in any case. NULL or empty, the default: any. */
    uint32_t validation; /**< Boolean: under the Khronos validation layer. AUREOLE_UNSUPPORTED if it is not installed. */
    aureole_message_callback message_callback; /**< From the very start. NULL, the default: silent. Kept. */
    void* message_user;                        /**< Kept. */
} aureole_vulkan_device_desc;
AUREOLE_API aureole_result aureole_vulkan_device_desc_defaults(aureole_vulkan_device_desc* desc);
/** A Vulkan device of its own, with a queue of its own. AUREOLE_UNSUPPORTED says why there is none, or that this library was
 * built without the Vulkan backend. */
AUREOLE_API aureole_result aureole_create_vulkan_device(const aureole_vulkan_device_desc* desc, aureole_device** out_device);

/** A host's Vulkan device, on which Aureole is a guest: it makes objects and records, and never submits or waits. Everything
 * stays the host's, and outlives the guest. What both promise each other: docs/vulkan.md. */
typedef struct aureole_borrowed_vulkan {
    uint32_t struct_size;
    uint32_t api_version;                 /**< VkApplicationInfo::apiVersion: VK_API_VERSION_1_1 at least. */
    void* instance;                       /**< VkInstance. */
    void* physical_device;                /**< VkPhysicalDevice. */
    void* device;                         /**< VkDevice. */
    void (*get_instance_proc_addr)(void); /**< PFN_vkGetInstanceProcAddr that made the instance, cast to this type. */
    uint32_t queue_family;                /**< Of the queue that the host submits to. */
    uint32_t debug_utils;                 /**< Boolean: VK_EXT_debug_utils is enabled in the instance. Default: 0. */
    const void* enabled_features;         /**< VkPhysicalDeviceFeatures, as enabled in VkDeviceCreateInfo:
                                             shaderStorageImageWriteWithoutFormat among them. */
    uint64_t pipeline_cache;              /**< VkPipelineCache; 0, the default: the guest makes one. */
    uint32_t second_queue_family;         /**< Another family with VK_QUEUE_COMPUTE_BIT, whose queues get recordings too or use
                                             what Aureole makes (asynchronous compute): images and buffers are made for both.
                                             UINT32_MAX (VK_QUEUE_FAMILY_IGNORED), the default, or `queue_family`: none. */
} aureole_borrowed_vulkan;
AUREOLE_API aureole_result aureole_borrowed_vulkan_defaults(aureole_borrowed_vulkan* host);
/** AUREOLE_UNSUPPORTED names what the device lacks. Nothing of the struct is kept but what it names. */
AUREOLE_API aureole_result aureole_borrow_vulkan_device(const aureole_borrowed_vulkan* host, aureole_device** out_device);

/** AUREOLE_MISUSE while an atmosphere or a planned sky of the device lives. Waits for work of the device's own queue; a host
 * has waited for the work of its own. Frees everything made from it. */
AUREOLE_API aureole_result aureole_destroy_device(aureole_device* device);

/** Strings live as long as the device. */
typedef struct aureole_capabilities {
    uint32_t struct_size;
    const char* backend;                                       /**< "vulkan", "cpu", or what an adapter says. */
    const char* device;                                        /**< Its name. */
    const char* driver;                                        /**< And version. */
    uint32_t max_texture_2d, max_texture_3d, max_texture_cube; /**< Texels along a side. */
    uint32_t max_push_constant_bytes;                          /**< Aureole needs 16. */
    uint32_t timestamp_slots;                                  /**< 0: none. */
    uint32_t raster;                                           /**< Boolean: aureole_composite_settings::raster may be 1. */
} aureole_capabilities;
/** The same for as long as the device lives. */
AUREOLE_API aureole_result aureole_get_capabilities(const aureole_device* device, aureole_capabilities* out_capabilities);
/** Where the device's messages go, of validation layers too. NULL: nowhere. Both are kept. */
AUREOLE_API aureole_result aureole_set_message_callback(aureole_device* device, aureole_message_callback callback, void* user);

/* ---- Textures and buffers. ---- */

/** A texture to be made, or what a lent one is. */
typedef struct aureole_texture_desc {
    uint32_t struct_size;
    aureole_dimension dimension;   /**< Default: 2D. */
    aureole_format format;         /**< Default: undefined, which is refused. */
    uint32_t width, height, depth; /**< Texels; each 1 at least, which is the default. Depth 1 but of 3D. */
    aureole_usage usage;           /**< Default: none, which is refused. */
    const char* name;              /**< For messages and debuggers. NULL: none. */
} aureole_texture_desc;
AUREOLE_API aureole_result aureole_texture_desc_defaults(aureole_texture_desc* desc);
/** Its contents are undefined. AUREOLE_UNSUPPORTED: the device has no such format, use or size. */
AUREOLE_API aureole_result aureole_create_texture(aureole_device* device, const aureole_texture_desc* desc,
                                                  aureole_texture* out_texture);

/** A texture of the host's, lent. */
typedef struct aureole_external_texture {
    uint32_t struct_size;
    aureole_state state;              /**< That it is in when a recording starts, and is returned to. */
    const aureole_texture_desc* desc; /**< What it is; NULL, the default, is refused. */
    uint64_t native;                  /**< The VkImage, or what an adapter takes it for. 0, the default, on the CPU. */
    uint64_t native_view;             /**< VkImageView; 0, the default: the device makes one. */
    void* cpu_texels; /**< CPU: tightly packed texels in desc.format, kept as long as the texture. Default: NULL. */
} aureole_external_texture;
AUREOLE_API aureole_result aureole_external_texture_defaults(aureole_external_texture* external);
/** Lends it: aureole_destroy_texture forgets it, and it stays the host's. */
AUREOLE_API aureole_result aureole_wrap_texture(aureole_device* device, const aureole_external_texture* external,
                                                aureole_texture* out_texture);

/** `size` in bytes, 1 at least. `name` may be NULL. */
AUREOLE_API aureole_result aureole_create_buffer(aureole_device* device, const char* name, uint64_t size, aureole_usage usage,
                                                 aureole_buffer* out_buffer);
/** Freed once the frame `last_used_frame` is complete (aureole_collect, aureole_wait). A lent texture is forgotten, and stays
 * the host's. 0 as a handle does nothing. */
AUREOLE_API aureole_result aureole_destroy_texture(aureole_device* device, aureole_texture texture, uint64_t last_used_frame);
/** As aureole_destroy_texture. */
AUREOLE_API aureole_result aureole_destroy_buffer(aureole_device* device, aureole_buffer buffer, uint64_t last_used_frame);
/** `size` bytes from the start of an UPLOAD buffer, of a READ_BACK buffer. The caller has waited for the device. */
AUREOLE_API aureole_result aureole_write_buffer(aureole_device* device, aureole_buffer buffer, const void* bytes,
                                                uint64_t size);
/** As aureole_write_buffer. */
AUREOLE_API aureole_result aureole_read_buffer(aureole_device* device, aureole_buffer buffer, void* bytes, uint64_t size);
/** Nanoseconds of the slots [0, count), from any origin. Slots never written are NaN. The caller has waited for the device. */
AUREOLE_API aureole_result aureole_read_timestamps(aureole_device* device, double* out_nanoseconds, uint32_t count);

/** Of a Vulkan device, for descriptor sets of the host's own; else AUREOLE_UNSUPPORTED. */
typedef struct aureole_native_texture {
    uint32_t struct_size;
    uint32_t sampled_layout; /**< VkImageLayout in AUREOLE_STATE_SAMPLED. */
    uint64_t image;          /**< VkImage. */
    uint64_t sampled_view;   /**< VkImageView; 0 of a texture without AUREOLE_USAGE_SAMPLED. */
} aureole_native_texture;
/** Valid as long as the texture. */
AUREOLE_API aureole_result aureole_get_native_texture(const aureole_device* device, aureole_texture texture,
                                                      aureole_native_texture* out_native);
/** The VkBuffer; bind the whole of it. */
AUREOLE_API aureole_result aureole_get_native_buffer(const aureole_device* device, aureole_buffer buffer, uint64_t* out_native);

/* ---- Recording. One list of a device at a time. ---- */

/** `host_list`: NULL for devices with a queue of their own (CPU, Vulkan of Aureole's own); a VkCommandBuffer in the recording
 * state, outside of a render pass, for a host's Vulkan device; what the callbacks get as `list` for an adapter. AUREOLE_MISUSE
 * while a list is open. */
AUREOLE_API aureole_result aureole_begin(aureole_device* device, void* host_list, aureole_commands** out_commands);
/** The same where `host_list` goes to a queue of this family: of a host's Vulkan device, `queue_family` or
 * `second_queue_family` of what it lent. On a family without graphics there are no raster passes and no copies of depth, on one
 * without timestamps none of those: both are told and left out. UINT32_MAX, as aureole_begin has it: `queue_family`; of other
 * devices nothing else is allowed. The host orders lists on two queues by semaphores: docs/vulkan.md. */
AUREOLE_API aureole_result aureole_begin_on(aureole_device* device, void* host_list, uint32_t queue_family,
                                            aureole_commands** out_commands);
/** Ends the list. Of a device with a queue of its own: submits it; `out_frame` (may be NULL) gets its number, 1, 2, ... Of a
 * host's: the list stays the host's to submit, and `out_frame` gets 0. AUREOLE_MISUSE where none is open. */
AUREOLE_API aureole_result aureole_end(aureole_device* device, uint64_t* out_frame);
/** Waits for all that a device with a queue of its own has been given. AUREOLE_UNSUPPORTED of a host's, which waits itself. */
AUREOLE_API aureole_result aureole_wait(aureole_device* device);
/** The host has seen the end of this frame, in its own counting: frees what was destroyed up to it. */
AUREOLE_API aureole_result aureole_collect(aureole_device* device, uint64_t completed_frame);

/** What goes into a list beside Aureole's own passes, for tools. `commands` is that of the open list. */
AUREOLE_API aureole_result aureole_barrier_texture(aureole_commands* commands, aureole_texture texture, aureole_state before,
                                                   aureole_state after);
/** The same for a buffer. */
AUREOLE_API aureole_result aureole_barrier_buffer(aureole_commands* commands, aureole_buffer buffer, aureole_state before,
                                                  aureole_state after);
/** The whole of it, tightly packed. Source in COPY_SOURCE, destination in COPY_DESTINATION. */
AUREOLE_API aureole_result aureole_copy_texture_to_buffer(aureole_commands* commands, aureole_texture source,
                                                          aureole_buffer destination);
/** As aureole_copy_texture_to_buffer. */
AUREOLE_API aureole_result aureole_copy_buffer_to_texture(aureole_commands* commands, aureole_buffer source,
                                                          aureole_texture destination);

#ifdef __cplusplus
}
#endif

#endif
