/** \file
 * Aureole's C API: skies of planets in an engine's own frame, from C, Rust, C#, Zig and whatever else binds to C.
 *
 *     aureole_cpu_device_desc desc = {.struct_size = sizeof desc};
 *     aureole_cpu_device_desc_defaults(&desc);
 *     aureole_device *device = NULL;
 *     if (aureole_create_cpu_device(&desc, &device) != AUREOLE_OK) puts(aureole_last_error());
 *
 * The same library as the C++ API (aureole/atmosphere.h), which these functions call; they convert, and add nothing. Link
 * aureole::c, a shared library. Page: atmosphere/c_api/c_api.md.
 *
 * Results. Every function that can fail returns an aureole_result. Whatever fails leaves its objects as they were and its
 * outputs unwritten, and aureole_last_error() says, for this thread, which field had which value and what is allowed. Nothing
 * is thrown across.
 *
 * Structs. Each begins with struct_size, which the caller sets to sizeof before anything else, also where the library writes
 * the struct. Then a program built with an older header works with a newer library: fields that it does not know have their
 * defaults. A size that the library does not know is AUREOLE_INVALID_ARGUMENT. X_defaults(&x) fills a struct in.
 *
 * Pointers. No pointer given to a function is kept after it returns, unless its comment says so. A null one where no comment
 * allows it is AUREOLE_INVALID_ARGUMENT. Strings are UTF-8, zero-terminated. Booleans are 0 or 1 in a uint32_t.
 *
 * Handles. Destroy what was made from an object before the object: AUREOLE_MISUSE otherwise. Destroying NULL does nothing. A
 * handle that was destroyed must not be used again.
 *
 * Threads. One thread at a time uses a device and all that was made from it; another device may be used by another thread.
 */
#ifndef AUREOLE_H
#define AUREOLE_H

#include <aureole/c/adapter.h>
#include <aureole/c/atmosphere.h>
#include <aureole/c/base.h>
#include <aureole/c/device.h>
#include <aureole/c/parameters.h>
#include <aureole/c/plan.h>
#include <aureole/c/planned_sky.h>
#include <aureole/c/view.h>

#endif
