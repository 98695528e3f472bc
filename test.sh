#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds and runs the tests. Exits with 0 only if all passed. The last line counts them.
#
#   ./test.sh                      what every change must pass: checks of the source, then the tests of the
#                                  core, the command line, the window (virtual display, software OpenGL),
#                                  the Python module and the packages, in the build tree of ./run.sh
#   ./test.sh --quick              for daily work: the build, and the tests that take seconds
#   ./test.sh --sanitize           core and command line, built by Clang with sanitizers
#   ./test.sh --nightly [STEP...]  what takes hours (tests/nightly.sh)
#
# With --no-install as the first argument apt-get is never called. In continuous integration (CI is set)
# warnings are errors, and too many skipped tests are a failure (TOILE_MAX_SKIPPED).
set -euo pipefail
cd "$(dirname "$0")"

if [ "${1:-}" = --no-install ]; then
    export TOILE_NO_INSTALL=1 # for run.sh, which installs what is missing
    shift
fi

packages=(
    libgtest-dev xvfb clang-format clang-tidy
    python3-dev python3-numpy pybind11-dev # the Python module
    desktop-file-utils appstream shared-mime-info libglib2.0-bin mandoc groff # check resources/package
)
clang_packages=(clang libclang-rt-14-dev libomp-dev libgtest-dev)
jobs=$(./run.sh --jobs)
started=$SECONDS
stage='' stage_started=$SECONDS
stages=()

# Ends the stage before, and prints how long it took with the others at the end.
stage() { # NAME
    [ -z "$stage" ] || stages+=("$(printf '%3d:%02d  %s' \
        $(((SECONDS - stage_started) / 60)) $(((SECONDS - stage_started) % 60)) "$stage")")
    stage=$1 stage_started=$SECONDS
    [ -z "$stage" ] || printf '\n== %s\n' "$stage"
}

# Prints the times of the stages and the number of tests; fails if one failed or too many were skipped.
report() { # BUILD STATUS
    local status=$2
    stage ''
    printf '\nMinutes:\n'
    printf '  %s\n' "${stages[@]}"
    printf '%5d:%02d  in all\n\n' $(((SECONDS - started) / 60)) $(((SECONDS - started) % 60))
    tests/count_tests.py "$1/Testing/Temporary/LastTest.log" ${CI:+--max-skipped "${TOILE_MAX_SKIPPED:-0}"} ||
        status=1
    exit "$status"
}

werror=(-DTOILE_WERROR="${CI:+ON}")
tests() { # BUILD CTEST-ARGUMENT...
    local build=$1 status=0
    shift
    # One more than there are cores: tests of the window wait now and then.
    ctest --test-dir "$build" --output-on-failure --no-tests=error --parallel $((jobs + 1)) "$@" || status=1
    report "$build" $status
}

case ${1:-} in
    --quick)
        ./run.sh --prepare "${packages[@]}"
        stage "Build"
        cmake --preset release -DBUILD_TESTING=ON -DTOILE_PYTHON=ON "${werror[@]}" >/dev/null
        cmake --build build/release --parallel "$jobs"
        stage "Quick tests"
        tests build/release -L quick
        ;;
    --sanitize)
        ./run.sh --prepare "${clang_packages[@]}"
        stage "Build by Clang with sanitizers"
        cmake --preset asan "${werror[@]}" >/dev/null
        cmake --build build/asan --parallel "$jobs" --target toile toile_core_test toile_cli_test
        if ldd build/asan/app/toile | grep -E 'Qt6|libGL\.|libGLX|libOpenGL|libEGL|libepoxy'; then
            echo "The build without the window must not need these." >&2
            exit 1
        fi
        stage "Tests with sanitizers"
        tests build/asan -L quick -R '^toile_(core|cli)_test'
        ;;
    --nightly)
        ./run.sh --prepare "${packages[@]}" "${clang_packages[@]}" librsvg2-bin
        exec tests/nightly.sh "${@:2}"
        ;;
    "") ;;
    *)
        sed -n 's/^#  *\(\.\/test\.sh.*\)/\1/p' "$0" >&2
        exit 2
        ;;
esac

./run.sh --prepare "${packages[@]}"
stage "Source: format, licence headers"
{ git ls-files -- '*.cpp' '*.h' 2>/dev/null || true; } | xargs -r -P "$jobs" -n 200 clang-format --dry-run -Werror
tests/check_headers.sh

stage "Build"
cmake --preset release -DBUILD_TESTING=ON -DTOILE_PYTHON=ON "${werror[@]}" >/dev/null
cmake --build build/release --parallel "$jobs"

stage "clang-tidy on changed lines"
tests/tidy.py

stage "Tests"
tests build/release -L full
