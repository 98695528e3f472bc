#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the fuzz targets and runs each of them, one after the other, starting from the kept seeds.
# What is found along the way stays in build/fuzz/found; an input that breaks something is named at
# the end and the status is 1. Reduce such an input with
#   build/fuzz/tests/fuzz/toile_fuzz_obj -minimize_crash=1 -max_total_time=60 INPUT
# repair the reader, and add the reduced input to seeds/ under a name that tells what it did.
#
#   tests/fuzz/run.sh [SECONDS]           seconds per target, 300 if not given
#   FORMATS="obj ply" tests/fuzz/run.sh   only these targets; "garment" is the whole pipeline
#   BUILD=folder JOBS=1 tests/fuzz/run.sh build there instead of in build/fuzz, one file at a time
set -euo pipefail
seconds=${1:-300}
build=${BUILD:-build/fuzz}
cd "$(dirname "$0")/../.."

./run.sh --prepare clang libclang-rt-14-dev libomp-dev
cmake --preset fuzz -B "$build"
cmake --build "$build" --target toile_fuzz --parallel "${JOBS:-2}"

status=0
for format in ${FORMATS:-obj off ply stl usdmesh project seams dxf svg garmentcode pdf plt glb usda prepare garment serve}; do
    work=$build/found/$format
    mkdir -p "$work/corpus" "$work/broken"
    printf '\n== %s, %s seconds\n' "$format" "$seconds"
    case $format in
        garment | prepare) words=off ;; # they start from an OFF file
        project | seams) words=json ;;
        glb) words=garmentcode ;; # its JSON
        usdmesh) words=usda ;;
        *) words=$format ;;
    esac
    # Seconds for one input and megabytes in all are findings too.
    "$build/tests/fuzz/toile_fuzz_$format" -max_total_time="$seconds" -timeout=10 \
        -rss_limit_mb=2048 -malloc_limit_mb=1024 -print_final_stats=1 \
        -dict="tests/fuzz/words/$words.dict" -artifact_prefix="$work/broken/" \
        "$work/corpus" "tests/fuzz/seeds/$format" 2>"$work/log" || status=1
    tail -n 12 "$work/log"
done
if [ "$status" -ne 0 ]; then
    echo "Findings, each with its log beside it:" >&2
    ls "$build"/found/*/broken/* >&2
fi
exit "$status"
