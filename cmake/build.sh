#!/usr/bin/env bash
# Configures one of the presets of CMakePresets.json and builds it: cmake/build.sh PRESET [TARGET...]
# Quiet while all is well; a failing step shows everything it said.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=$1
shift
folder=build/$preset
jobs=$(nproc)
mkdir -p "$folder"

echo "Configuring $folder"
if ! cmake --preset "$preset" < /dev/null > "$folder/configure.log" 2>&1; then
    cat "$folder/configure.log" >&2
    echo "Configuring $folder failed (its messages are above)." >&2
    exit 1
fi

echo "Building $folder with $jobs jobs"
targets=()
[ $# = 0 ] || targets=(--target "$@")
# On a terminal ninja keeps to one line; elsewhere a line per file would drown the rest.
if [ -t 1 ]; then
    cmake --build "$folder" --parallel "$jobs" "${targets[@]}" < /dev/null
elif ! cmake --build "$folder" --parallel "$jobs" "${targets[@]}" < /dev/null > "$folder/build.log" 2>&1; then
    grep -v '^\[[0-9]*/[0-9]*\] ' "$folder/build.log" >&2
    echo "Building $folder failed (its messages are above)." >&2
    exit 1
fi
