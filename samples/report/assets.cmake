# aureole_report_page(<variable>): the generated source that holds the report's page, libraries and all (report.md).
#
# The charts' libraries come from npm into the build folder, once for each package-lock.json. Without npm, or where it reaches
# no registry, the source holds no page, and the program says so when it is asked for one; everything else works.
option(AUREOLE_REPORT_PAGE "Fetch the libraries of the report's charts with npm" ON)
find_program(AUREOLE_NPM npm)
mark_as_advanced(AUREOLE_NPM)

set(AUREOLE_REPORT_ROOM "${CMAKE_CURRENT_LIST_DIR}")

# Leaves node_modules in `folder`, or sets `problem` to why there is none.
function(aureole_fetch_report_libraries folder problem)
    set(${problem} "" PARENT_SCOPE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${AUREOLE_REPORT_ROOM}/package-lock.json")
    file(SHA256 "${AUREOLE_REPORT_ROOM}/package-lock.json" wanted)
    set(present "")
    if(EXISTS "${folder}/fetched")
        file(READ "${folder}/fetched" present)
    endif()
    if(wanted STREQUAL present)
        return()
    endif()
    if(NOT AUREOLE_NPM)
        set(${problem} "npm was not found" PARENT_SCOPE)
        return()
    endif()
    message(STATUS "Fetching the libraries of the report's charts")
    file(COPY "${AUREOLE_REPORT_ROOM}/package.json" "${AUREOLE_REPORT_ROOM}/package-lock.json" DESTINATION "${folder}")
    execute_process(
        COMMAND "${AUREOLE_NPM}" ci --ignore-scripts --no-audit --no-fund --loglevel=error --prefer-offline --fetch-retries=1
        WORKING_DIRECTORY "${folder}" TIMEOUT 300
        RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(NOT result EQUAL 0)
        set(${problem} "npm ci failed (${result}): ${said}" PARENT_SCOPE)
        return()
    endif()
    file(WRITE "${folder}/fetched" "${wanted}")
endfunction()

function(aureole_report_page variable)
    set(folder "${CMAKE_CURRENT_BINARY_DIR}/report_libraries")
    set(libraries "")
    if(AUREOLE_REPORT_PAGE)
        aureole_fetch_report_libraries("${folder}" problem)
        if(problem)
            message(WARNING "`aureole report` is built without its HTML page: ${problem}")
        else()
            set(libraries "${folder}/node_modules")
        endif()
    endif()

    set(output "${CMAKE_CURRENT_BINARY_DIR}/report_page.cpp")
    file(GLOB parts CONFIGURE_DEPENDS "${AUREOLE_REPORT_ROOM}/page/*")
    add_custom_command(
        OUTPUT "${output}"
        COMMAND Python3::Interpreter "${AUREOLE_REPORT_ROOM}/pack.py" "${AUREOLE_REPORT_ROOM}/page" "${output}" ${libraries}
        DEPENDS "${AUREOLE_REPORT_ROOM}/pack.py" "${AUREOLE_REPORT_ROOM}/package-lock.json" ${parts}
        COMMENT "Packing the report's page" VERBATIM)
    set(${variable} "${output}" PARENT_SCOPE)
endfunction()
