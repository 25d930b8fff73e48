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
build=(cmake --build "$folder" --parallel "$jobs" "${targets[@]}")

# On a terminal ninja keeps to one line; elsewhere a line per file would drown the rest, so every tenth of the way is told.
if [ -t 1 ]; then
    "${build[@]}" < /dev/null
    exit
fi
tell() {
    local line tenth told=0
    while IFS= read -r line; do
        if [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\  ]]; then
            tenth=$((10 * BASH_REMATCH[1] / BASH_REMATCH[2]))
            if [ $tenth -gt $told ]; then echo "  ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]} steps"; fi
            told=$tenth
        elif [[ $line != "ninja: no work to do." ]]; then
            echo "$line"
        fi
    done
}
if ! "${build[@]}" < /dev/null 2>&1 | tell; then
    echo "Building $folder failed (its messages are above)." >&2
    exit 1
fi
