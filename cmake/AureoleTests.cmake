# aureole_add_test(<name> SOURCES <file>... [LIBS <target>...] [INCLUDE_DIRS <dir>...] [LABELS <label>...] [TIMEOUT <seconds>]
#                  [COST <seconds>])
#
# A doctest program <name> (one shared main: tests/doctest_main.cpp) that ctest runs under the same name. It sees the src/
# folder of the directory it is made in. ctest calls it in that program's own empty working folder. With sanitizers, programs
# labelled `vulkan` (they open a driver) or `slow` are neither run nor part of the default build: to be built by name.
# COST: about what a long one takes. ctest starts tests with the highest cost first, so that none runs alone at the end.
find_package(doctest 2.4 REQUIRED)

# Compiled once: doctest's own implementation is by far the slowest part of a test program.
add_library(aureole_doctest_main STATIC "${PROJECT_SOURCE_DIR}/tests/doctest_main.cpp")
target_link_libraries(aureole_doctest_main PUBLIC doctest::doctest)
target_compile_features(aureole_doctest_main PUBLIC cxx_std_20)

function(aureole_add_test name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "TIMEOUT;COST" "SOURCES;LIBS;INCLUDE_DIRS;LABELS")
    if(arg_UNPARSED_ARGUMENTS OR NOT arg_SOURCES)
        message(FATAL_ERROR "aureole_add_test(${name}): SOURCES is missing or arguments are unknown: ${arg_UNPARSED_ARGUMENTS}")
    endif()
    add_executable(${name} ${arg_SOURCES})
    target_compile_options(${name} PRIVATE ${AUREOLE_WARNINGS})
    target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/src" "${PROJECT_SOURCE_DIR}/tests" ${arg_INCLUDE_DIRS})
    target_link_libraries(${name} PRIVATE aureole_doctest_main ${arg_LIBS})
    if(AUREOLE_SANITIZE AND (vulkan IN_LIST arg_LABELS OR slow IN_LIST arg_LABELS))
        set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL TRUE)
        return()
    endif()
    set(folder "${CMAKE_CURRENT_BINARY_DIR}/run/${name}")
    file(MAKE_DIRECTORY "${folder}")
    set(options --no-intro)
    if(AUREOLE_SANITIZE)
        list(APPEND options --test-suite-exclude=long)  # its code runs in shorter ones, too
    endif()
    add_test(NAME ${name} COMMAND ${name} ${options} WORKING_DIRECTORY "${folder}")
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 300)
    endif()
    if(NOT arg_COST)
        set(arg_COST 0)
    endif()
    set_tests_properties(${name} PROPERTIES TIMEOUT ${arg_TIMEOUT} COST ${arg_COST} LABELS "${arg_LABELS}")
endfunction()

# aureole_skip_without_vulkan(<test>...): ctest says "Skipped" where a test found no device or no validation layer and therefore
# compared less than it should, unless what it did compare has failed. ./test.sh, which installs both, takes that for a failure.
# A tree that is built without the Vulkan backend has nothing to skip.
function(aureole_skip_without_vulkan)
    foreach(name IN LISTS ARGN)
        if(TEST ${name})
            set_tests_properties(
                ${name} PROPERTIES SKIP_REGULAR_EXPRESSION
                                   "skipped: (no usable Vulkan device|the Vulkan validation layer).*SUCCESS!")
        endif()
    endforeach()
endfunction()
