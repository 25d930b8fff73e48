#!/bin/sh
# pkg_config.sh SOURCE_FOLDER WORK_FOLDER: programs that know nothing but what pkg-config says. CXX and PKG_CONFIG_PATH are given.
set -eu
# shellcheck disable=SC2046  # words
$CXX -Wall -Wextra -Werror -o "$2/pkg_rhi_only" "$1/rhi_only/main.cpp" $(pkg-config --cflags --libs aureole)
"$2/pkg_rhi_only"
$CXX -Wall -Wextra -Werror -o "$2/pkg_cpu" "$1/main.cpp" $(pkg-config --cflags --libs aureole-cpu)
"$2/pkg_cpu" "$2/pkg_host.comp"
