# How every target of this tree is built: warnings, sanitizers, names.

# For our own code, and only while building it: nothing of this reaches a project that uses Aureole. Which warnings there are
# depends on compiler and flags, so they stop nobody's build but ours.
set(AUREOLE_WARNINGS -Wall -Wextra -Wconversion)
if(AUREOLE_WARNINGS_AS_ERRORS)
    list(APPEND AUREOLE_WARNINGS -Werror)
endif()

# Sanitizers apply to a whole program, so they are set for every target of the tree.
if(AUREOLE_SANITIZE)
    add_compile_options(-fsanitize=${AUREOLE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${AUREOLE_SANITIZE})
endif()

# What libFuzzer steers by: which branches an input takes.
if(AUREOLE_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
    add_link_options(-fsanitize=fuzzer-no-link)
endif()

# What a shared library shows is what has a name of Aureole's (aureole.map): nothing of what it is made with. The same list for all,
# since each is also used by the others and by tests, which see more than the public headers.
function(aureole_export_symbols target)
    get_target_property(type ${target} TYPE)
    if(NOT type STREQUAL "SHARED_LIBRARY")
        return()
    endif()
    set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET default VISIBILITY_INLINES_HIDDEN OFF
                                               WINDOWS_EXPORT_ALL_SYMBOLS ON)
    if(CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF")
        set(map "${PROJECT_SOURCE_DIR}/cmake/aureole.map")
        target_link_options(${target} PRIVATE "LINKER:--version-script=${map}")
        set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${map}")
        if(NOT AUREOLE_SANITIZE) # whose functions are the program's
            target_link_options(${target} PRIVATE "LINKER:--no-undefined")
        endif()
        # They find each other beside themselves, wherever that is.
        set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN")
    endif()
endfunction()

# aureole_install_program(<target> <component>): into the package's folder of programs, from where it finds shared libraries of ours.
function(aureole_install_program target component)
    if(BUILD_SHARED_LIBS AND CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF")
        file(RELATIVE_PATH libraries "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")
        set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries}")
    endif()
    install(TARGETS ${target} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT ${component})
endfunction()

# aureole_add_library(<name> SOURCES <file>...)
#
# A library `aureole_<name>` with the alias `aureole::<name>`: static, or shared with BUILD_SHARED_LIBS. Its public headers are in
# include/ and are installed; src/ is for itself alone (and for its tests). The caller links what it needs and, last, calls nothing
# else: install rules are made here.
function(aureole_add_library name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES")
    set(target aureole_${name})
    add_library(${target} ${arg_SOURCES})
    add_library(aureole::${name} ALIAS ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX VERSION ${PROJECT_VERSION}
                                               SOVERSION ${PROJECT_VERSION_MAJOR})
    aureole_export_symbols(${target})
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_compile_options(${target} PRIVATE ${AUREOLE_WARNINGS})
    target_include_directories(
        ${target}
        PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>"
        PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/src")
    if(AUREOLE_INSTALL)
        # An export of its own, so that a package's user needs what the components in use need, and no more.
        install(
            TARGETS ${target} EXPORT aureole-${name}-targets
            ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development
            LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT libraries NAMELINK_COMPONENT development
            RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT libraries)
        set_property(GLOBAL APPEND PROPERTY AUREOLE_COMPONENTS ${name})
        install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
                COMPONENT development)
    endif()
endfunction()
