#!/bin/sh
# pkg_config.sh SOURCE_FOLDER WORK_FOLDER: programs that know nothing but what pkg-config says. CXX, CC and PKG_CONFIG_PATH are given.
# The package lies where no loader looks: its shared libraries, of which there is one at least, are named by an rpath.
set -eu
# pkg-config writes words as a shell reads them (a space in a path as "\ "), hence eval.
eval "rpath=-Wl,-rpath,$(pkg-config --variable=libdir aureole)"

# compile PACKAGE OUTPUT COMMAND...
compile() {
    package=$1 output=$2
    shift 2
    eval "set -- \"\$@\" -Wall -Wextra -Werror -o \"\$output\" \"\$rpath\" $(pkg-config --cflags --libs "$package")"
    "$@"
}

compile aureole "$2/pkg_rhi_only" "$CXX" "$1/rhi_only/main.cpp"
"$2/pkg_rhi_only"
compile aureole-cpu "$2/pkg_cpu" "$CXX" "$1/main.cpp"
"$2/pkg_cpu" "$2/pkg_host.comp"
# The C API asks for no package beside itself.
test "$(pkg-config --print-requires aureole-c)" = ''
compile aureole-c "$2/pkg_c" "$CC" -std=c11 "$1/c/main.c"
"$2/pkg_c"
