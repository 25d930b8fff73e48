#!/usr/bin/env bash
# Builds Aureole and runs every test: all of them in the release build (Vulkan under the validation layer), then those that
# need no graphics driver again by clang++ under AddressSanitizer and UndefinedBehaviorSanitizer, with some seconds of libFuzzer for
# each reader, and those of the CPU backend under ThreadSanitizer.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")" || exit 1

usage() {
    cat << 'END'
usage: ./test.sh [--no-install]

  --no-install  only check the Debian packages, install nothing
END
}

install_options=(--tests)
for argument in "$@"; do
    case "$argument" in
        --no-install) install_options+=(--no-install) ;;
        -h | --help) usage; exit 0 ;;
        *) echo "test.sh: unknown option $argument" >&2; usage >&2; exit 2 ;;
    esac
done

cmake/install_dependencies.sh "${install_options[@]}" || exit 1

summary=()
failed=no

# run PRESET TARGET CTEST_OPTION...: builds a target of a preset and runs its tests; a failure is kept for the summary.
run() {
    local preset=$1 target=$2 started=$SECONDS built log=build/$1/test.log
    shift 2
    echo
    echo "== $preset"
    if ! cmake/build.sh "$preset" "$target"; then
        summary+=("$preset: the build failed")
        failed=yes
        return
    fi
    built=$((SECONDS - started))
    ctest --test-dir "build/$preset" --output-on-failure --no-tests=error --parallel "$(nproc)" "$@" < /dev/null 2>&1 | tee "$log"
    if [ "${PIPESTATUS[0]}" != 0 ]; then failed=yes; fi
    if grep -q '(Skipped)$' "$log"; then
        summary+=("$preset: skipped tests count as failed here: every package they need was asked for")
        failed=yes
    fi
    summary+=("$preset: built in $built s; ctest's closing lines:" "$(sed -n '/tests passed/,$p' "$log" | sed '/^$/d; s/^/    /')")
}

export ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1:detect_stack_use_after_return=1
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
export TSAN_OPTIONS="suppressions='$PWD/tests/thread.supp'"
run release all
run sanitize all --label-exclude 'vulkan|slow'
run thread backend_cpu_test --tests-regex '^backend_cpu_test$'

echo
echo "== summary ($SECONDS s)"
printf '%s\n' "${summary[@]}"
if [ $failed = yes ]; then
    echo "FAILED"
    exit 1
fi
echo "All passed."
