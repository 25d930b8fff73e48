#!/bin/sh
# pkg_config.sh SOURCE_FOLDER WORK_FOLDER: programs that know nothing but what pkg-config says. CXX, CC and PKG_CONFIG_PATH are given.
# The package lies where no loader looks: its shared libraries, of which there is one at least, are named by an rpath.
set -eu
rpath=-Wl,-rpath,$(pkg-config --variable=libdir aureole)
# shellcheck disable=SC2046  # words
$CXX -Wall -Wextra -Werror -o "$2/pkg_rhi_only" "$1/rhi_only/main.cpp" "$rpath" $(pkg-config --cflags --libs aureole)
"$2/pkg_rhi_only"
$CXX -Wall -Wextra -Werror -o "$2/pkg_cpu" "$1/main.cpp" "$rpath" $(pkg-config --cflags --libs aureole-cpu)
"$2/pkg_cpu" "$2/pkg_host.comp"
# The C API asks for no package beside itself.
test "$(pkg-config --print-requires aureole-c)" = ''
$CC -std=c11 -Wall -Wextra -Werror -o "$2/pkg_c" "$1/c/main.c" "$rpath" $(pkg-config --cflags --libs aureole-c)
"$2/pkg_c"
