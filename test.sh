#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds and runs every test: the library, the command line and the samples, the window under a
# virtual display with software OpenGL, the build without Qt, the core once more under the address
# and undefined-behaviour sanitizers, a guard on speed, and the source format. Ends with status 0 only
# if all passed.
#
#   ./test.sh            everything
#   ./test.sh --quick    without the sanitizers
set -euo pipefail
cd "$(dirname "$0")"

./run.sh --prepare libgtest-dev libbenchmark-dev xvfb clang-format python3-numpy

step() { printf '\n== %s\n' "$1"; }
jobs=$(nproc)

step "Build, warnings are errors"
cmake --preset ci -DTOILE_TESTS=ON
cmake --build --preset ci --parallel "$jobs"

step "Build without Qt"
cmake --preset core -DTOILE_TESTS=OFF
cmake --build --preset core --parallel "$jobs"
./build/core/app/toile flatten resources/samples/cap.obj --unit mm

step "Source format"
git ls-files -- '*.cpp' '*.h' 2>/dev/null | xargs -r clang-format --dry-run -Werror

if [ "${1:-}" != --quick ]; then
    step "Core under the address and undefined-behaviour sanitizers"
    cmake --preset asan
    cmake --build --preset asan --parallel "$jobs"
    ctest --preset asan --parallel "$jobs" --progress
fi

step "All tests"
ctest --preset ci --parallel "$jobs"
