# cmake --install: the libraries (each has its own rule, see aureole_add_library) become a package for find_package(aureole), for
# pkg-config, and with cpack for Debian (AureoleDebian.cmake).
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/aureole")
get_property(components GLOBAL PROPERTY AUREOLE_COMPONENTS)
foreach(component IN LISTS components)
    install(EXPORT aureole-${component}-targets NAMESPACE aureole:: DESTINATION "${package_dir}" COMPONENT development)
endforeach()
configure_package_config_file(
    "${CMAKE_CURRENT_LIST_DIR}/aureole-config.cmake.in" "${PROJECT_BINARY_DIR}/aureole-config.cmake"
    INSTALL_DESTINATION "${package_dir}" PATH_VARS CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/aureole-config-version.cmake" COMPATIBILITY SameMajorVersion)
install(
    FILES "${PROJECT_BINARY_DIR}/aureole-config.cmake" "${PROJECT_BINARY_DIR}/aureole-config-version.cmake"
    DESTINATION "${package_dir}" COMPONENT development)
install(
    FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
          "${PROJECT_SOURCE_DIR}/CONTRIBUTING.md"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT development)
# The pages link to each other, to pictures, to code and to examples by their places in the tree, so these keep them.
install(
    DIRECTORY "${PROJECT_SOURCE_DIR}/docs" "${PROJECT_SOURCE_DIR}/atmosphere" "${PROJECT_SOURCE_DIR}/rhi" "${PROJECT_SOURCE_DIR}/backends"
              "${PROJECT_SOURCE_DIR}/samples"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT development
    FILES_MATCHING
    REGEX "\\.(md|png|jpg|svg|toml|glsl|h)$"
    REGEX "/atmosphere/.*\\.cpp$"
    REGEX "/samples/(host_vulkan|ogre)/.*"
    REGEX "/docs/site$" EXCLUDE
    REGEX "_test\\.(h|cpp)$" EXCLUDE)

# aureole_pkg_config(<name> DESCRIPTION <text> LIBRARIES <component>... [REQUIRES <package>...] [FLAGS <flag>...]): <name>.pc
function(aureole_pkg_config name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "DESCRIPTION" "LIBRARIES;REQUIRES;FLAGS")
    set(folder "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
    file(RELATIVE_PATH prefix_from_here "/${folder}" "/")
    string(REGEX REPLACE "/$" "" prefix_from_here "${prefix_from_here}")
    set(description "${arg_DESCRIPTION}")
    list(TRANSFORM arg_LIBRARIES PREPEND "-laureole_" OUTPUT_VARIABLE libraries)
    list(JOIN libraries " " libraries)
    list(JOIN arg_REQUIRES ", " requires)
    list(JOIN arg_FLAGS " " flags)
    configure_file("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/aureole.pc.in" "${PROJECT_BINARY_DIR}/${name}.pc" @ONLY)
    install(FILES "${PROJECT_BINARY_DIR}/${name}.pc" DESTINATION "${folder}" COMPONENT development)
endfunction()

# C++20 is said here since g++ 12 takes an older one by itself.
aureole_pkg_config(
    aureole DESCRIPTION "Real-time planetary atmospheres behind an abstract render interface" LIBRARIES atmosphere rhi REQUIRES glm
                        "spdlog >= 1.8" FLAGS -std=c++20)
aureole_pkg_config(
    aureole-cpu DESCRIPTION "Aureole's render interface on the CPU" LIBRARIES backend_cpu REQUIRES "aureole = ${PROJECT_VERSION}" tbb)
if(TARGET aureole_backend_vulkan)
    aureole_pkg_config(
        aureole-vulkan DESCRIPTION "Aureole's render interface on Vulkan 1.1" LIBRARIES backend_vulkan REQUIRES
        "aureole = ${PROJECT_VERSION}")
endif()

if(TARGET aureole_c)
    # A C compiler needs nothing else: what the library is made with it brings along.
    aureole_pkg_config(aureole-c DESCRIPTION "Aureole's C API" LIBRARIES c)
endif()

if(PROJECT_IS_TOP_LEVEL)
    include(AureoleDebian)
endif()
