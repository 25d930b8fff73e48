/** \file
 * Results, the last error, and the log. See aureole.h. */
#ifndef AUREOLE_C_BASE_H
#define AUREOLE_C_BASE_H

#include <stddef.h>
#include <stdint.h>

/** Before each function: it can be called from outside of the library. */
#if defined(_WIN32) && !defined(AUREOLE_C_BUILD)
#define AUREOLE_API __declspec(dllimport)
#elif defined(_WIN32)
#define AUREOLE_API __declspec(dllexport)
#else
#define AUREOLE_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What a function returns: one of the values below. */
typedef int32_t aureole_result;
enum {
    AUREOLE_OK = 0,
    AUREOLE_INVALID_ARGUMENT = 1, /**< A value given by the caller is outside its documented range. */
    AUREOLE_UNSUPPORTED = 2,      /**< The device, or this build, lacks what the request needs. */
    AUREOLE_OUT_OF_MEMORY = 3,    /**< Host or device memory could not be had. */
    AUREOLE_DEVICE_LOST = 4,      /**< The device stopped working; every object made from it is dead. */
    AUREOLE_IO = 5,               /**< A file could not be read or written. No function here uses files. */
    AUREOLE_MISUSE = 6,           /**< Called in a forbidden order or state. */
    AUREOLE_INTERNAL = 7          /**< A bug in Aureole, in a driver or in a callback. */
};
/** "ok", "invalid_argument" ...; "unknown" for any other number. Never NULL; static. */
AUREOLE_API const char* aureole_result_name(aureole_result result);

/** The latest failure in this thread: "<field>: <value> is not allowed; allowed: <range>", or a plain sentence. Empty before
 * the first; a success leaves it. Never NULL. Valid until the next failure in this thread. */
AUREOLE_API const char* aureole_last_error(void);
/** Its parts: the dotted name as the C++ API knows it ("planet.bottom_radius_m"), what was given, what is allowed. Empty where
 * the failure is not about one field. Never NULL. Valid as aureole_last_error. */
AUREOLE_API const char* aureole_last_error_field(void);
AUREOLE_API const char* aureole_last_error_value(void);   /**< As aureole_last_error_field. */
AUREOLE_API const char* aureole_last_error_allowed(void); /**< As aureole_last_error_field. */

/** "1.0.0": of the library that is linked. Static. */
AUREOLE_API const char* aureole_version(void);

/** How much a message matters. */
typedef uint32_t aureole_severity;
enum { AUREOLE_INFO = 0, AUREOLE_WARNING = 1, AUREOLE_ERROR = 2 };
/** Receives messages, in the thread that calls the library. `user` is what was given with it; `text` lives during the call. It
 * must not call the library, throw or jump out. */
typedef void (*aureole_message_callback)(void* user, aureole_severity severity, const char* text);

/** The library's log: warnings of values outside of the envelope of stability, of cameras deep inside a planet; recording
 * functions say there why they recorded nothing. NULL: silent, as it is at the start. Of the whole library; `user` stays valid
 * until another callback has been set. May be called from any thread that calls the library. */
AUREOLE_API aureole_result aureole_set_log(aureole_message_callback callback, void* user);

#ifdef __cplusplus
}
#endif

#endif
