# Installs a build into a staging folder, moves it (a package must not know where it was born), and configures, builds and runs
# the outside project beside this file against it.
# Then the shader that it wrote, which includes the installed look-ups, is compiled, and more projects are built and run: one
# without any backend, one that proves a device with the conformance kit, one in C, one that names no component and is given those
# files alone that developers get, and programs that know nothing but what pkg-config says.
#   cmake -D BUILD_DIR=... -D WORK_DIR=... -D CXX_COMPILER=... -D GLSLANG=... -P install_test.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${WORK_DIR}")
set(steps_prefix "${CMAKE_COMMAND}" -E env --unset=AUREOLE_DIR --unset=CMAKE_PREFIX_PATH)
function(step)
    execute_process(COMMAND ${steps_prefix} ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        list(JOIN ARGN " " command)
        message("${output}")
        message(FATAL_ERROR "this step failed (${result}): ${command}")
    endif()
    message("${output}")
endfunction()

step("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/born")
foreach(page LICENSE README.md docs/integration.md atmosphere/composite/composite.md)
    if(NOT EXISTS "${WORK_DIR}/born/share/doc/aureole/${page}")
        message(FATAL_ERROR "${page} is not installed")
    endif()
endforeach()
if(EXISTS "${WORK_DIR}/born/bin/aureole")
    file(GLOB page "${WORK_DIR}/born/share/man/man1/aureole.1*")
    if(NOT page)
        message(FATAL_ERROR "the manual page is not installed")
    endif()
    foreach(file bash-completion/completions/aureole zsh/vendor-completions/_aureole
                 fish/vendor_completions.d/aureole.fish aureole/scenes/noon.toml)
        if(NOT EXISTS "${WORK_DIR}/born/share/${file}")
            message(FATAL_ERROR "share/${file} is not installed")
        endif()
    endforeach()
endif()
file(RENAME "${WORK_DIR}/born" "${WORK_DIR}/prefix")
set(package "${WORK_DIR}/prefix")
function(build_and_run source build program)
    step("${CMAKE_COMMAND}" -G Ninja -S "${source}" -B "${build}" "-DCMAKE_PREFIX_PATH=${package}"
         "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" -DCMAKE_BUILD_TYPE=Release)
    step("${CMAKE_COMMAND}" --build "${build}")
    step("${build}/${program}" ${ARGN})
endfunction()

build_and_run("${CMAKE_CURRENT_LIST_DIR}" "${WORK_DIR}/build" outside "${WORK_DIR}/host.comp")
step("${GLSLANG}" -V --target-env vulkan1.1 "-I${WORK_DIR}/prefix/include" -o "${WORK_DIR}/host.spv" "${WORK_DIR}/host.comp")
build_and_run("${CMAKE_CURRENT_LIST_DIR}/rhi_only" "${WORK_DIR}/build_rhi_only" outside_rhi)
build_and_run("${CMAKE_CURRENT_LIST_DIR}/rhi_tests" "${WORK_DIR}/build_rhi_tests" outside_rhi_tests)
build_and_run("${CMAKE_CURRENT_LIST_DIR}/c" "${WORK_DIR}/build_c" outside_c)

# Of a build with shared C++ libraries, those are a component of their own.
foreach(component development libraries)
    step("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/developer" --component ${component})
endforeach()
set(package "${WORK_DIR}/developer")
build_and_run("${CMAKE_CURRENT_LIST_DIR}/plain" "${WORK_DIR}/build_plain" outside_plain)

find_program(pkg_config pkg-config)
if(NOT pkg_config)
    message(FATAL_ERROR "there is no pkg-config (cmake/install_dependencies.sh --tests)")
endif()
file(GLOB_RECURSE found "${WORK_DIR}/prefix/*/aureole.pc")
cmake_path(GET found PARENT_PATH folder)
step("${CMAKE_COMMAND}" -E env "PKG_CONFIG_PATH=${folder}" "CXX=${CXX_COMPILER}" CC=cc sh "${CMAKE_CURRENT_LIST_DIR}/pkg_config.sh"
     "${CMAKE_CURRENT_LIST_DIR}" "${WORK_DIR}")
