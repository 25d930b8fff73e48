# The manual page and what shells complete words by: the program prints them itself, so they are made once it is built, and they are
# installed where man and the shells look for them. Not for another machine's program, which does not run here.
if(CMAKE_CROSSCOMPILING)
    return()
endif()
set(made "${CMAKE_CURRENT_BINARY_DIR}/manual")
file(MAKE_DIRECTORY "${made}")
find_program(AUREOLE_GZIP gzip)
mark_as_advanced(AUREOLE_GZIP)
set(printed)

# aureole_printed(<file> <folder of share/> <arguments of the program>...)
function(aureole_printed file folder)
    add_custom_command(
        OUTPUT "${made}/${file}"
        COMMAND aureole_app ${ARGN} > "${made}/${file}"
        DEPENDS aureole_app COMMENT "aureole ${ARGN}" VERBATIM)
    if(folder MATCHES "^man/" AND AUREOLE_GZIP)  # as Debian wants it, and as man reads it anywhere
        add_custom_command(OUTPUT "${made}/${file}.gz" COMMAND "${AUREOLE_GZIP}" -9nkf "${made}/${file}" DEPENDS "${made}/${file}" VERBATIM)
        string(APPEND file .gz)
    endif()
    install(FILES "${made}/${file}" DESTINATION "${CMAKE_INSTALL_DATADIR}/${folder}" COMPONENT program)
    set(printed ${printed} "${made}/${file}" PARENT_SCOPE)
endfunction()
aureole_printed(aureole bash-completion/completions completion bash)
aureole_printed(_aureole zsh/vendor-completions completion zsh)
aureole_printed(aureole.fish fish/vendor_completions.d completion fish)
aureole_printed(aureole.1 man/man1 man)
add_custom_target(aureole_manual ALL DEPENDS ${printed})
