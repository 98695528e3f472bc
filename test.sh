#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds and runs the tests. Ends with status 0 only if all passed.
#
#   ./test.sh            what every change must pass, as continuous integration runs it: checks of
#                        the source, the core and the command line without Qt under sanitizers, then
#                        both as they ship, the samples, and the window under a virtual display with
#                        software OpenGL
#   ./test.sh --quick    for daily work: the build, and the tests that take seconds
#   ./test.sh --nightly  what takes hours (tests/nightly.sh)
set -euo pipefail
cd "$(dirname "$0")"

jobs=$(nproc)
started=$SECONDS
step() { printf '\n== %s (after %d:%02d)\n' "$1" $(((SECONDS - started) / 60)) $(((SECONDS - started) % 60)); }
skipped() { # PRESET: how many tests its last run left out for want of files
    sed -n 's/^\[  SKIPPED \] \([0-9]*\) test.*/\1/p' "build/$1/Testing/Temporary/LastTest.log" |
        awk '{ n += $1 } END { print n + 0 " tests skipped" }'
}

packages=(
    libgtest-dev xvfb clang-format
    python3-dev python3-numpy pybind11-dev # the Python module
    desktop-file-utils appstream shared-mime-info libglib2.0-bin mandoc groff # what judges resources/package
)
clang_packages=(clang clang-tidy libclang-rt-14-dev libomp-dev)
clang_build=$PWD/build/asan # compiles the core's tests for both: it takes half the time
case ${1:-} in
    --quick)
        ./run.sh --prepare "${packages[@]}"
        step "Build, warnings are errors"
        cmake --preset ci -DTOILE_TESTS=ON >/dev/null
        cmake --build --preset ci --parallel "$jobs"
        step "Quick tests"
        ctest --preset ci --parallel "$jobs" -L quick
        exit
        ;;
    --nightly)
        ./run.sh --prepare "${packages[@]}" "${clang_packages[@]}" \
            libbenchmark-dev python3-ezdxf librsvg2-bin
        exec tests/nightly.sh
        ;;
    "") ;;
    *)
        sed -n 's/^#  *\(\.\/test\.sh.*\)/\1/p' "$0" >&2
        exit 2
        ;;
esac
./run.sh --prepare "${packages[@]}" "${clang_packages[@]}"

step "Source: format, one definition of everything, clang-tidy on what has changed"
git ls-files -- '*.cpp' '*.h' 2>/dev/null | xargs -r clang-format --dry-run -Werror
tests/one_definition.py
tests/tidy.py

step "Core and command line by Clang, without Qt, under sanitizers; warnings are errors"
cmake --preset asan -DTOILE_TESTS=ON
cmake --build --preset asan --parallel "$jobs" --target toile toile_core_test toile_cli_test
if ldd build/asan/app/toile | grep -E 'Qt6|libGL\.|libGLX|libOpenGL|libEGL|libepoxy'; then
    echo "The build without the window must not need these." >&2
    exit 1
fi
ctest --preset asan --parallel "$jobs" --progress -L full -R '^toile_(core|cli)'
skipped asan

step "Build by GCC, warnings are errors"
cmake --preset ci -DTOILE_TESTS=ON -DTOILE_CORE_TESTS_FROM="$clang_build"
cmake --build --preset ci --parallel "$jobs"

step "Tests"
ctest --preset ci --parallel $((jobs + 1)) -L full # those of the window wait now and then
skipped ci
step "All passed"
