/** \file
 * A host's own render interface, as a table of callbacks: what rhi::Device and rhi::CommandList are to C++ (docs/rhi.md, which
 * says what each must do, and docs/conformance.md, whose checks an adapter is put to). See aureole.h.
 *
 * The library checks every descriptor before a callback sees it, by the rules and in the words that all devices share:
 * callbacks get what is valid. A callback that returns another result than AUREOLE_OK fails the call that led to it, with that
 * result and the text of aureole_set_callback_error. Those that record return nothing: what cannot be recorded is the host's to
 * report. Callbacks must not throw, jump out, or call functions of this device; they come in the thread that calls the library.
 *
 * Handles are the host's own numbers: of textures, buffers, samplers, pipelines and binding sets each 1 at least, and never
 * used again for another object of the kind while the device lives. Pointers in what callbacks are given live during the call,
 * but for aureole_shader and all that it leads to, which live as long as the library. */
#ifndef AUREOLE_C_ADAPTER_H
#define AUREOLE_C_ADAPTER_H

#include <aureole/c/device.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a shader reads or writes in a slot. */
typedef uint32_t aureole_slot_kind;
enum { AUREOLE_SLOT_SAMPLED_TEXTURE = 0, AUREOLE_SLOT_STORAGE_TEXTURE = 1, AUREOLE_SLOT_CONSTANTS = 2 };
/** One resource that a shader reads or writes. */
typedef struct aureole_slot {
    uint32_t slot;               /**< layout(set = 0, binding = slot). */
    aureole_slot_kind kind;      /**< A value of AUREOLE_SLOT_. */
    aureole_dimension dimension; /**< Of textures. A cube's storage view has six layers. */
    const char* name;            /**< For messages and debuggers. Never NULL. */
} aureole_slot;
/** How a kernel is run. */
typedef uint32_t aureole_stage;
enum { AUREOLE_STAGE_COMPUTE = 0, AUREOLE_STAGE_FRAGMENT = 1 };
/** One kernel; take the form that suits. Its address stays the same: a host may key its translations by it. */
typedef struct aureole_shader {
    const char* name;             /**< For messages and debuggers. Never NULL. */
    aureole_stage stage;          /**< Fragment shaders are drawn as one triangle that covers the target. */
    uint32_t local_size[3];       /**< Invocations of a workgroup. Of compute. */
    uint32_t push_constant_bytes; /**< At most 128. */
    uint32_t slot_count;          /**< Of `slots`. */
    const aureole_slot* slots;    /**< `slot_count` of them, by rising slot. */
    const uint32_t* spirv;        /**< Vulkan 1.1, entry "main". */
    uint64_t spirv_words;         /**< Of 32 bits. */
    const char* glsl;             /**< One source, \#version 450; zero-terminated. */
} aureole_shader;
/** layout(constant_id = id): bits of an int32 (booleans 0 or 1) or of a float. */
typedef struct aureole_specialization {
    uint32_t id, bits; /**< The constant_id, and its value. */
} aureole_specialization;

/** How a sampler reads between texels. */
typedef uint32_t aureole_filter;
enum { AUREOLE_NEAREST = 0, AUREOLE_LINEAR = 1 };
/** What a sampler reads beyond the edges. */
typedef uint32_t aureole_address;
enum { AUREOLE_CLAMP = 0, AUREOLE_REPEAT = 1 };

/** A buffer to be made. */
typedef struct aureole_buffer_desc {
    const char* name;    /**< For messages and debuggers. Never NULL. */
    uint64_t size;       /**< Bytes, 1 at least. */
    aureole_usage usage; /**< All that it is made for. */
} aureole_buffer_desc;
/** A sampler to be made. */
typedef struct aureole_sampler_desc {
    aureole_filter filter;                           /**< For smaller and larger alike. */
    aureole_address address_u, address_v, address_w; /**< Along width, height and depth. */
} aureole_sampler_desc;
/** A compute or raster pipeline to be made of one kernel. */
typedef struct aureole_pipeline_desc {
    const char* name;                             /**< For messages and debuggers. Never NULL. */
    const aureole_shader* shader;                 /**< The kernel. */
    const aureole_specialization* specialization; /**< `specialization_count` of them; the others have their defaults. */
    uint32_t specialization_count;                /**< May be 0. */
    aureole_format target_format;                 /**< Of raster pipelines; else undefined. */
} aureole_pipeline_desc;
/** What stands in one slot: a texture with its sampler (0 for storage), or a buffer, the whole of it. */
typedef struct aureole_binding {
    uint32_t slot;           /**< Of the shader. */
    aureole_texture texture; /**< Which one. Of a binding: 0 for constants. */
    uint64_t sampler;        /**< Of sampled slots; else 0. */
    aureole_buffer buffer;   /**< Which one. Of a binding: 0 for textures. */
} aureole_binding;
/** What a pipeline's shader finds in all of its slots. */
typedef struct aureole_binding_set_desc {
    const char* name;                /**< For messages and debuggers. Never NULL. */
    uint64_t pipeline;               /**< The set fits every pipeline made from the same shader. */
    const aureole_binding* bindings; /**< One for each slot of the shader. */
    uint32_t binding_count;          /**< As many as the shader has slots. */
} aureole_binding_set_desc;

/** Work recorded before is finished and visible to work recorded after, and the texture goes from one state to another. */
typedef struct aureole_texture_barrier {
    aureole_texture texture;     /**< Which one: made by the device, or lent. */
    aureole_state before, after; /**< The state that it is in, and the one it goes to. */
} aureole_texture_barrier;
/** The same of a buffer. */
typedef struct aureole_buffer_barrier {
    aureole_buffer buffer;       /**< Which one: of any usage. */
    aureole_state before, after; /**< The state that it is in, and the one it goes to. */
} aureole_buffer_barrier;
/** Runs a compute pipeline. */
typedef struct aureole_dispatch {
    uint64_t pipeline, binding_set; /**< binding_set 0: the shader has no slots. */
    const void* push_constants;     /**< To be copied. */
    uint32_t push_constant_bytes;   /**< The shader's. */
    uint32_t groups[3];             /**< Workgroups. */
} aureole_dispatch;
/** Runs a raster pipeline for every texel of a target. */
typedef struct aureole_draw {
    uint64_t pipeline, binding_set; /**< binding_set 0: the shader has no slots. */
    const void* push_constants;     /**< To be copied. */
    uint32_t push_constant_bytes;   /**< The shader's. */
    aureole_texture target;         /**< In COLOR_ATTACHMENT; every texel is written. */
} aureole_draw;

/** What `destroy` is given. */
typedef uint32_t aureole_object_kind;
enum {
    AUREOLE_OBJECT_TEXTURE = 0,
    AUREOLE_OBJECT_BUFFER = 1,
    AUREOLE_OBJECT_SAMPLER = 2,
    AUREOLE_OBJECT_PIPELINE = 3,
    AUREOLE_OBJECT_BINDING_SET = 4
};
/** What a format can be used for; or-ed together. */
enum {
    AUREOLE_SUPPORT_SAMPLED = 1,
    AUREOLE_SUPPORT_LINEAR_FILTER = 2,
    AUREOLE_SUPPORT_STORAGE = 4,
    AUREOLE_SUPPORT_COLOR_ATTACHMENT = 8
};

/** Every callback is given `user`; those that record are given `list`, which is the host_list of aureole_begin. None may be
 * NULL but those that say so. */
typedef struct aureole_adapter {
    uint32_t struct_size;
    void* user; /**< Kept. */

    const char *backend, *device, *driver; /**< What the device is: aureole_capabilities. Copied. NULL: empty. */
    uint32_t max_texture_2d, max_texture_3d, max_texture_cube; /**< Texels along a side. */
    uint32_t max_push_constant_bytes;                          /**< Aureole needs 16. */
    uint32_t timestamp_slots;              /**< 0: none; then `timestamp` and `read_timestamps` may be NULL. */
    uint32_t storage_write_without_format; /**< Boolean; Aureole needs it. */
    uint32_t raster;                       /**< Boolean. 0: `create_raster_pipeline` and `draw_fullscreen` may be NULL. */

    /** AUREOLE_SUPPORT_ flags of a format; 0 for what cannot be used. Never fails. */
    uint32_t (*format_support)(void* user, aureole_format format, aureole_dimension dimension);

    /** Its contents are undefined. As the other callbacks that create: `out` gets the handle. */
    aureole_result (*create_texture)(void* user, const aureole_texture_desc* desc, aureole_texture* out);
    /** NULL: nothing can be lent. */
    aureole_result (*wrap_texture)(void* user, const aureole_external_texture* external, aureole_texture* out);
    /** Its contents are undefined. */
    aureole_result (*create_buffer)(void* user, const aureole_buffer_desc* desc, aureole_buffer* out);
    /** For the slots of binding sets. */
    aureole_result (*create_sampler)(void* user, const aureole_sampler_desc* desc, uint64_t* out);
    /** May take long. */
    aureole_result (*create_compute_pipeline)(void* user, const aureole_pipeline_desc* desc, uint64_t* out);
    /** May take long. */
    aureole_result (*create_raster_pipeline)(void* user, const aureole_pipeline_desc* desc, uint64_t* out);
    /** Its objects outlive it. */
    aureole_result (*create_binding_set)(void* user, const aureole_binding_set_desc* desc, uint64_t* out);
    /** Nothing recorded from now on uses the object; free it once the frame is complete. */
    void (*destroy)(void* user, aureole_object_kind kind, uint64_t handle, uint64_t last_used_frame);
    /** Frees what was destroyed with a frame number up to this one. */
    void (*collect)(void* user, uint64_t completed_frame);
    /** Within the buffer's size. */
    aureole_result (*write_buffer)(void* user, aureole_buffer buffer, const void* bytes, uint64_t size);
    /** Within the buffer's size. */
    aureole_result (*read_buffer)(void* user, aureole_buffer buffer, void* bytes, uint64_t size);
    /** Times of the slots [0, count), from any origin. */
    aureole_result (*read_timestamps)(void* user, double* out_nanoseconds, uint32_t count);

    /** Replaces the first bytes of a constants buffer, in order with the commands around it. */
    void (*update_constants)(void* user, void* list, aureole_buffer buffer, const void* bytes, uint64_t size);
    /** Ends accesses in the states before, makes their writes visible, allows accesses in the states after. */
    void (*barrier)(void* user, void* list, const aureole_texture_barrier* textures, uint32_t texture_count,
                    const aureole_buffer_barrier* buffers, uint32_t buffer_count);
    /** Runs a compute pipeline. */
    void (*dispatch)(void* user, void* list, const aureole_dispatch* desc);
    /** Runs a raster pipeline for every texel of its target. */
    void (*draw_fullscreen)(void* user, void* list, const aureole_draw* desc);
    /** All texels, tightly packed: rows, then slices or faces. */
    void (*copy_texture_to_buffer)(void* user, void* list, aureole_texture source, aureole_buffer destination);
    /** The same, back. */
    void (*copy_buffer_to_texture)(void* user, void* list, aureole_buffer source, aureole_texture destination);
    /** Same format and extent. */
    void (*copy_texture_to_texture)(void* user, void* list, aureole_texture source, aureole_texture destination);
    void (*begin_marker)(void* user, void* list, const char* name); /**< NULL: no markers, nor end_marker. */
    void (*end_marker)(void* user, void* list);                     /**< Of the marker begun last. */
    /** Writes the time at which the work recorded before has finished into a slot. */
    void (*timestamp)(void* user, void* list, uint32_t slot);
} aureole_adapter;
/** All 0. */
AUREOLE_API aureole_result aureole_adapter_defaults(aureole_adapter* adapter);
/** The callbacks are copied; what `user` leads to outlives the device. Recording: aureole_begin with the host's list. */
AUREOLE_API aureole_result aureole_create_adapter_device(const aureole_adapter* adapter, aureole_device** out_device);
/** For a callback that is about to return a failure: what went wrong, in this thread. Copied. */
AUREOLE_API void aureole_set_callback_error(const char* text);

#ifdef __cplusplus
}
#endif

#endif
