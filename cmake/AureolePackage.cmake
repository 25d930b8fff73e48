# cmake --install: the libraries (each has its own rule, see aureole_add_library) become a package for find_package(aureole).
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/aureole")
get_property(components GLOBAL PROPERTY AUREOLE_COMPONENTS)
foreach(component IN LISTS components)
    install(EXPORT aureole-${component}-targets NAMESPACE aureole:: DESTINATION "${package_dir}")
endforeach()
configure_package_config_file(
    "${CMAKE_CURRENT_LIST_DIR}/aureole-config.cmake.in" "${PROJECT_BINARY_DIR}/aureole-config.cmake"
    INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/aureole-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(
    FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}")
# The pages link to each other and to headers by their places in the tree, so they keep them.
install(
    DIRECTORY "${PROJECT_SOURCE_DIR}/docs" "${PROJECT_SOURCE_DIR}/atmosphere"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}"
    FILES_MATCHING
    PATTERN "*.md"
    PATTERN "docs/images/*.png"
    PATTERN include EXCLUDE)
install(
    FILES "${PROJECT_BINARY_DIR}/aureole-config.cmake" "${PROJECT_BINARY_DIR}/aureole-config-version.cmake"
    DESTINATION "${package_dir}")
