# Configures the project beside this file, which adds Aureole with add_subdirectory and CMake's own Release flags (-O3), and
# builds those of its sources that put messages together: there g++ warns of different things at each level of optimization.
#   cmake -D AUREOLE_TREE=... -D WORK_DIR=... -D CXX_COMPILER=... -D CXX_LAUNCHER=... -P subdirectory_test.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${WORK_DIR}")
function(step)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    message("${output}")
    if(NOT result EQUAL 0)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "this step failed (${result}): ${command}")
    endif()
endfunction()
set(configure "${CMAKE_COMMAND}" -G Ninja -S "${CMAKE_CURRENT_LIST_DIR}" -B "${WORK_DIR}" "-DAUREOLE_TREE=${AUREOLE_TREE}"
              "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${CXX_LAUNCHER}" -DCMAKE_BUILD_TYPE=Release
              -DAUREOLE_BUILD_VULKAN=OFF)

# As a newcomer has it; then with the warnings that would be told now stopping the build.
step(${configure})
step(${configure} -DAUREOLE_WARNINGS_AS_ERRORS=ON -DWARNINGS_MAY_STOP=ON)

set(objects)
foreach(room camera common parameters phase quality)
    file(GLOB sources RELATIVE "${AUREOLE_TREE}/atmosphere" "${AUREOLE_TREE}/atmosphere/${room}/*.cpp")
    list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
    foreach(source ${sources})
        list(APPEND objects "aureole/atmosphere/CMakeFiles/aureole_atmosphere.dir/${source}.o")
    endforeach()
endforeach()
step("${CMAKE_COMMAND}" --build "${WORK_DIR}" --target aureole_rhi ${objects})
