#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures speed and writes the tables and the plot of one run to build/bench/docs; docs/performance.md
# shows a selection. Needs libbenchmark-dev. Do not use the machine during the run.
#
#   tests/bench/run.sh            everything; about twelve minutes on two cores
#   tests/bench/run.sh --quick    up to 45 000 triangles, without most peers
#   tests/bench/run.sh --no-slow-peers   without the peers that take minutes
# Further options go to Google Benchmark (--benchmark_filter=...).
set -euo pipefail
cd "$(dirname "$0")/../.."

docs=build/bench/docs

cmake --preset core -DBUILD_TESTING=OFF -DTOILE_BENCH=ON -B build/bench >/dev/null
cmake --build build/bench --target toile_bench toile_bench_report --parallel "$(nproc)"
mkdir -p "$docs/images"
build/bench/tests/bench/toile_bench "$@" \
    --benchmark_out=build/bench/run.json --benchmark_out_format=json
build/bench/tests/bench/report/toile_bench_report build/bench/run.json "$docs"
