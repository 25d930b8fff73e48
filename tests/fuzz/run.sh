#!/usr/bin/env bash
# libFuzzer on every reader: tests/fuzz/run.sh [SECONDS [READER...]]
#
#   SECONDS  of each reader; 60 if not given
#   READER   scene suite measurements checkpoint npz exr png csv parameters settings; all if none is given
#
# Needs clang++ with its sanitizers (Debian: clang libclang-rt-14-dev). New inputs that reach new code gather in build/fuzz/found,
# and the next run starts from them; what a reader fails at is left in build/fuzz/failed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

seconds=${1:-60}
[ $# = 0 ] || shift
[[ $seconds =~ ^[1-9][0-9]*$ ]] || { sed -n '2,5s/^# \{0,1\}//p' tests/fuzz/run.sh >&2; exit 2; }
readers=("$@")
[ ${#readers[@]} != 0 ] || readers=(scene suite measurements checkpoint npz exr png csv parameters settings)

cmake/build.sh sanitize "${readers[@]/#/fuzz_}"

export ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1:allocator_may_return_null=0
export UBSAN_OPTIONS=print_stacktrace=1
failed=()
for reader in "${readers[@]}"; do
    found=build/fuzz/found/$reader artifacts=build/fuzz/failed/$reader log=build/fuzz/$reader.log
    mkdir -p "$found" "$artifacts"
    options=(-max_total_time="$seconds" -timeout=10 -rss_limit_mb=3072 -malloc_limit_mb=1536 -print_final_stats=1
             -artifact_prefix="$artifacts/")
    case $reader in
        measurements | checkpoint | suite | scene) options+=(-max_len=16384) ;;
        *) options+=(-max_len=4096) ;;
    esac
    # OpenEXR makes room for the lines or the tiles of all channels, below 2 GiB.
    [ "$reader" != exr ] || options+=(-malloc_limit_mb=2048)
    [ ! -f "tests/fuzz/$reader.dict" ] || options+=(-dict="tests/fuzz/$reader.dict")
    echo "== $reader, $seconds s"
    if "build/sanitize/bin/fuzz_$reader" "${options[@]}" "$found" "tests/fuzz/corpus/$reader" < /dev/null > "$log" 2>&1; then
        grep 'Done ' "$log"
    else
        tail -n 60 "$log"
        failed+=("$reader")
    fi
done
[ ${#failed[@]} = 0 ] || { echo "FAILED: ${failed[*]} (build/fuzz/failed)"; exit 1; }
echo "No reader failed."
