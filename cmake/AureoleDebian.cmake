# cpack -G DEB, in a build folder: packages for Debian. `aureole` is the program, `aureole-viewer` the one with a window, where it
# was built, `libaureole-dev` what others build with; with BUILD_SHARED_LIBS there is `libaureole1`, too.
set(AUREOLE_PACKAGE_CONTACT "Aureole <aureole@localhost.localdomain>" CACHE STRING "Who answers for packages that cpack makes")
mark_as_advanced(AUREOLE_PACKAGE_CONTACT)
find_program(AUREOLE_GZIP gzip)
mark_as_advanced(AUREOLE_GZIP)
if(NOT AUREOLE_GZIP)
    return()
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME aureole)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "${AUREOLE_PACKAGE_CONTACT}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL)

set(runtime "libaureole${PROJECT_VERSION_MAJOR}")
set(what "Aureole renders the sky, the sun and the air in front of a scene in real
time, for planets given in SI units. It records passes into the host's
command list through a small render interface.")

# What Debian wants in every package: its licence, and a history of its own.
set(folder "${PROJECT_BINARY_DIR}/debian")
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(CONFIGURE OUTPUT "${folder}/changelog.Debian" @ONLY CONTENT "aureole (@PROJECT_VERSION@-1) unstable; urgency=medium

  * Made by cpack; what has changed is told in CHANGELOG.md.

 -- @AUREOLE_PACKAGE_CONTACT@  @now@
")
execute_process(COMMAND "${AUREOLE_GZIP}" -9nkf "${folder}/changelog.Debian" COMMAND_ERROR_IS_FATAL ANY)

# aureole_debian_package(<component> <package> SECTION <section> SUMMARY <line> [DEPENDS <packages>] [RECOMMENDS <packages>])
function(aureole_debian_package component package)
    cmake_parse_arguments(PARSE_ARGV 2 arg "" "SECTION;SUMMARY;DEPENDS;RECOMMENDS;SUGGESTS" "")
    string(TOUPPER "${component}" name)
    set(papers "${component}_papers")
    string(TOUPPER "${papers}" papers_name)
    install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" RENAME copyright
            COMPONENT ${papers} EXCLUDE_FROM_ALL)
    install(FILES "${folder}/changelog.Debian.gz" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" COMPONENT ${papers}
            EXCLUDE_FROM_ALL)
    set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} ${papers} PARENT_SCOPE)
    set(CPACK_COMPONENT_${name}_GROUP ${component} PARENT_SCOPE)
    set(CPACK_COMPONENT_${papers_name}_GROUP ${component} PARENT_SCOPE)
    set(CPACK_COMPONENT_GROUP_${name}_DESCRIPTION "${arg_SUMMARY}\n${what}" PARENT_SCOPE)
    set(CPACK_COMPONENT_${name}_DESCRIPTION "${arg_SUMMARY}\n${what}" PARENT_SCOPE)
    set(CPACK_DEBIAN_${name}_PACKAGE_NAME ${package} PARENT_SCOPE)
    set(CPACK_DEBIAN_${name}_PACKAGE_SECTION ${arg_SECTION} PARENT_SCOPE)
    set(CPACK_DEBIAN_${name}_PACKAGE_DEPENDS "${arg_DEPENDS}" PARENT_SCOPE)
    set(CPACK_DEBIAN_${name}_PACKAGE_RECOMMENDS "${arg_RECOMMENDS}" PARENT_SCOPE)
    set(CPACK_DEBIAN_${name}_PACKAGE_SUGGESTS "${arg_SUGGESTS}" PARENT_SCOPE)
    # Needed libraries are told by dpkg-shlibdeps: of programs, and of the C library, which stands among the archives.
    set(CPACK_DEBIAN_${name}_PACKAGE_SHLIBDEPS ON PARENT_SCOPE)
endfunction()

set(same "(= ${PROJECT_VERSION}-1)")
# Who holds shared libraries tells the loader of them; other packages are told whom to name for them.
file(WRITE "${folder}/triggers" "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
if(BUILD_SHARED_LIBS)
    set(CPACK_DEBIAN_LIBRARIES_PACKAGE_CONTROL_EXTRA "${folder}/triggers")
elseif(TARGET aureole_c)
    set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_CONTROL_EXTRA "${folder}/triggers")
endif()
set(runtime_needed "")
if(BUILD_SHARED_LIBS)
    set(runtime_needed "${runtime} ${same}, ")
    aureole_debian_package(libraries ${runtime} SECTION libs SUMMARY "real-time planetary atmospheres - libraries")
    set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}/rhi" "${PROJECT_BINARY_DIR}/atmosphere"
                                                    "${PROJECT_BINARY_DIR}/backends/cpu" "${PROJECT_BINARY_DIR}/backends/vulkan")
endif()
aureole_debian_package(
    development libaureole-dev SECTION libdevel SUMMARY "real-time planetary atmospheres - development files"
    DEPENDS "${runtime_needed}libglm-dev, libspdlog-dev" RECOMMENDS "libtbb-dev, libvulkan-dev" SUGGESTS "aureole")
if(AUREOLE_BUILD_SAMPLES)
    string(REGEX REPLACE ", $" "" program_needs "${runtime_needed}")
    aureole_debian_package(
        program aureole SECTION graphics SUMMARY "real-time planetary atmospheres on the command line" DEPENDS "${program_needs}"
        RECOMMENDS "libvulkan1" SUGGESTS "python-matplotlib-data, libaureole-dev")
endif()
if(TARGET aureole_viewer)
    string(REGEX REPLACE ", $" "" viewer_needs "${runtime_needed}")
    aureole_debian_package(viewer aureole-viewer SECTION graphics SUMMARY "real-time planetary atmospheres in a window"
                           DEPENDS "${viewer_needs}" SUGGESTS "aureole")
endif()
include(CPack)
