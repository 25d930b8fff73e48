# Kernels: one GLSL source, three programs (SPIR-V, C++ in float, C++ in double).
#
#   aureole_add_shaders(<target>
#       INCLUDE_DIRS <dir>...           # where #include "..." lines look, after the kernel's own folder
#       KERNELS <path/name.comp.glsl | path/name.frag.glsl>...)
#
# Call it in the folder that made <target> (a library or program; it is linked to aureole::rhi here). For each kernel:
#   - the prelude and all #includes are flattened into one GLSL text (#version 450 first); every included file needs an include
#     guard (#ifndef/#define at its start) and is taken once;
#   - glslangValidator makes SPIR-V 1.3 for Vulkan 1.1, spirv-opt -O shrinks it, spirv-val checks it; compiler errors are
#     reported with the line of the file you wrote;
#   - <name>.shader.cpp is generated and compiled into <target>: it includes the very same kernel file as a C++ class template
#     `aureole::kernels::<name>_kernel<real>`, holds SPIR-V, GLSL and the slot table, and defines the object
#         const aureole::rhi::Shader aureole::shaders::<name>;
#   - all of them are declared in the generated header  #include "<target>_shaders.h"
#     (seen by <target> and, inside this build tree only, by those that link to it, such as its tests).
# Kernel names are C++ identifiers and unique in the program. Slots, local size and push constants are read from the source
# after preprocessing, so a slot may be named by a #define. Builds are incremental: included files are tracked.
#
# CPU kernels are always optimized, also in Debug builds (they run for every pixel of every test), and without contraction to
# fused multiply-add, so that results do not depend on the machine.

find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
find_program(AUREOLE_GLSLANG glslangValidator REQUIRED)
find_program(AUREOLE_SPIRV_VAL spirv-val REQUIRED)
find_program(AUREOLE_SPIRV_OPT spirv-opt)
mark_as_advanced(AUREOLE_GLSLANG AUREOLE_SPIRV_VAL AUREOLE_SPIRV_OPT)

set(AUREOLE_SHADER_TOOL "${CMAKE_CURRENT_LIST_DIR}/shader_tool.py")
set(AUREOLE_PRELUDE "${CMAKE_CURRENT_LIST_DIR}/../rhi/include/aureole/rhi/kernel/prelude.glsl")
cmake_path(NORMAL_PATH AUREOLE_PRELUDE)
# maybe-uninitialized: g++ 12 cannot see that OUT parameters are written. math-errno: kernels never look at errno.
set(AUREOLE_KERNEL_OPTIONS -O2 -ffp-contract=off -fno-math-errno)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND AUREOLE_KERNEL_OPTIONS -Wno-maybe-uninitialized)
endif()
# The kernel language has no pointers, no objects of a derived class and no null: what looks for faults of them finds none in a
# kernel, and is a third of the time that a kernel takes to compile. A place outside of a texture or an array is still found.
if(AUREOLE_SANITIZE MATCHES "undefined")
    list(APPEND AUREOLE_KERNEL_OPTIONS -fno-sanitize=null,alignment,object-size,vptr,pointer-overflow)
endif()

# Nor is there a way to keep a variable's address beyond its scope, which is half of the time again.
if(AUREOLE_SANITIZE MATCHES "address")
    list(APPEND AUREOLE_KERNEL_OPTIONS -fno-sanitize-address-use-after-scope)
endif()
# Which branches kernels take tells libFuzzer nothing of readers and validation, and is a third of the time that kernels run.
if(AUREOLE_FUZZ)
    list(APPEND AUREOLE_KERNEL_OPTIONS -fno-sanitize=fuzzer-no-link)
endif()

function(aureole_add_shaders target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "INCLUDE_DIRS;KERNELS")
    if(arg_UNPARSED_ARGUMENTS OR NOT arg_KERNELS)
        message(FATAL_ERROR "aureole_add_shaders(${target}): KERNELS is missing or arguments are unknown: ${arg_UNPARSED_ARGUMENTS}")
    endif()
    set(out "${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders")
    file(MAKE_DIRECTORY "${out}")

    set(include_dirs)
    set(include_flags)
    foreach(dir IN LISTS arg_INCLUDE_DIRS)
        cmake_path(ABSOLUTE_PATH dir NORMALIZE)
        list(APPEND include_dirs "${dir}")
        list(APPEND include_flags -I "${dir}")
    endforeach()
    set(optimizer_flags)
    if(AUREOLE_SPIRV_OPT)
        set(optimizer_flags --spirv-opt "${AUREOLE_SPIRV_OPT}")
    endif()

    set(names)
    foreach(kernel IN LISTS arg_KERNELS)
        cmake_path(ABSOLUTE_PATH kernel NORMALIZE)
        cmake_path(GET kernel FILENAME file)
        if(NOT file MATCHES "^([A-Za-z_][A-Za-z0-9_]*)\\.(comp|frag)\\.glsl$")
            message(FATAL_ERROR "aureole_add_shaders(${target}): ${file} is not named <identifier>.comp.glsl or <identifier>.frag.glsl")
        endif()
        set(name "${CMAKE_MATCH_1}")
        if(name IN_LIST names)
            message(FATAL_ERROR "aureole_add_shaders(${target}): two kernels are called ${name}")
        endif()
        list(APPEND names "${name}")
        add_custom_command(
            OUTPUT "${out}/${name}.shader.cpp"
            COMMAND
                Python3::Interpreter "${AUREOLE_SHADER_TOOL}" kernel "${kernel}" --prelude "${AUREOLE_PRELUDE}" ${include_flags}
                --glslang "${AUREOLE_GLSLANG}" --spirv-val "${AUREOLE_SPIRV_VAL}" ${optimizer_flags}
                --output "${out}/${name}.shader.cpp" --depfile "${out}/${name}.d"
            DEPENDS "${kernel}" "${AUREOLE_SHADER_TOOL}" "${AUREOLE_PRELUDE}"
            DEPFILE "${out}/${name}.d"
            COMMENT "Kernel ${name}"
            VERBATIM)
        set_source_files_properties("${out}/${name}.shader.cpp" PROPERTIES COMPILE_OPTIONS "${AUREOLE_KERNEL_OPTIONS}")
        target_sources(${target} PRIVATE "${out}/${name}.shader.cpp")
    endforeach()

    set(declarations "")
    foreach(name IN LISTS names)
        string(APPEND declarations "extern const rhi::Shader ${name};\n")
    endforeach()
    file(CONFIGURE OUTPUT "${out}/${target}_shaders.h" @ONLY CONTENT [[
// Generated by aureole_add_shaders: the kernels of @target@.
#pragma once

#include <aureole/rhi/shader.h>

namespace aureole::shaders {
@declarations@}  // namespace aureole::shaders
]])
    # Tests of the target may include its kernel files and its shader header; users of an installed package may not.
    foreach(dir IN LISTS include_dirs)
        target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${dir}>")
    endforeach()
    target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${out}>")
    target_link_libraries(${target} PUBLIC aureole::rhi)
endfunction()

# aureole_add_shader_library(<target> <path/name.glsl> [INCLUDE_DIRS <dir>...])
#
# For shaders of others: prelude, file and all that it includes as one self-contained GLSL text, made with <target> and installed
# with its headers as <aureole/glsl/name.glsl>. In the build tree it lies under <binary dir>/include, which users of <target> see.
# The folder aureole/glsl of either is the target's property AUREOLE_GLSL_DIR: for engines that look for shaders in folders.
function(aureole_add_shader_library target library)
    cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "INCLUDE_DIRS")
    cmake_path(ABSOLUTE_PATH library NORMALIZE)
    cmake_path(GET library FILENAME file)
    set(include_flags)
    foreach(dir IN LISTS arg_INCLUDE_DIRS)
        cmake_path(ABSOLUTE_PATH dir NORMALIZE)
        list(APPEND include_flags -I "${dir}")
    endforeach()
    set(output "${CMAKE_CURRENT_BINARY_DIR}/include/aureole/glsl/${file}")
    file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/include/aureole/glsl")
    add_custom_command(
        OUTPUT "${output}"
        COMMAND
            Python3::Interpreter "${AUREOLE_SHADER_TOOL}" library "${library}" --prelude "${AUREOLE_PRELUDE}" ${include_flags}
            --output "${output}" --depfile "${output}.d"
        DEPENDS "${library}" "${AUREOLE_SHADER_TOOL}" "${AUREOLE_PRELUDE}"
        DEPFILE "${output}.d"
        COMMENT "Shader library ${file}"
        VERBATIM)
    target_sources(${target} PRIVATE "${output}")
    set_target_properties(${target} PROPERTIES AUREOLE_GLSL_DIR "${CMAKE_CURRENT_BINARY_DIR}/include/aureole/glsl")
    target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_BINARY_DIR}/include>")
    if(AUREOLE_INSTALL)
        install(FILES "${output}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/aureole/glsl" COMPONENT development)
    endif()
endfunction()
