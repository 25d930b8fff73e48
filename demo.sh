#!/usr/bin/env bash
# Builds Aureole and renders its demo pictures.
set -euo pipefail
caller=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")"

usage() {
    cat << 'END'
usage: ./demo.sh [--no-install] [--out DIR]

  --no-install  only check the Debian packages, install nothing
  --out DIR     where the pictures go (default: out/ beside this script)
END
}

install_options=()
out=$PWD/out
while [ $# -gt 0 ]; do
    case "$1" in
        --no-install) install_options=(--no-install) ;;
        --out)
            [ $# -ge 2 ] && [ -n "$2" ] || { echo "demo.sh: --out needs a folder" >&2; exit 2; }
            out=$2
            [[ $out == /* ]] || out=$caller/$out
            shift ;;
        -h | --help) usage; exit 0 ;;
        *) echo "demo.sh: unknown option $1" >&2; usage >&2; exit 2 ;;
    esac
    shift
done

scenes=(noon golden_hour twilight altitude_10km low_orbit mars terrain_near terrain_far)

cmake/install_dependencies.sh "${install_options[@]}"
started=$SECONDS
cmake/build.sh release aureole_app
built=$SECONDS
mkdir -p "$out"

# Once, before the pictures: render says it again for each.
echo
build/release/bin/aureole devices < /dev/null
echo "Rendering ${#scenes[@]} pictures: about half a minute on 2 cores."

done_scenes=()
failed_scenes=()
for i in "${!scenes[@]}"; do
    scene=${scenes[$i]}
    echo
    echo "[$((i + 1))/${#scenes[@]}] $scene"
    if build/release/bin/aureole render "samples/scenes/$scene.toml" -o "$out/$scene.png" < /dev/null; then
        done_scenes+=("$scene")
    else
        failed_scenes+=("$scene")
    fi
done

echo
echo "Built in $((built - started)) s, rendered ${#done_scenes[@]} of ${#scenes[@]} pictures in $((SECONDS - built)) s;" \
    "with packages $((SECONDS / 60)) min $((SECONDS % 60)) s in all (the first time on 2 cores: under 10 min):"
for scene in "${done_scenes[@]}"; do echo "  $out/$scene.png"; done
if [ ${#failed_scenes[@]} -gt 0 ]; then
    echo "Failed: ${failed_scenes[*]}" >&2
    exit 1
fi
