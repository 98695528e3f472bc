#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What takes too long for every change: hours on two cores. The other steps run if one fails; its output
# is in build/nightly/STEP.log. Ends with a table, and with status 1 if any failed.
#
#   tests/nightly.sh           everything, as ./test.sh --nightly does
#   tests/nightly.sh STEP...   these: slow monkey translation asan-window tsan fuzz odr tidy large outlines
#                              clock bench clients python blender batch package
#
# With TOILE_NO_INSTALL in the environment apt-get is never called.
set -uo pipefail
cd "$(dirname "$0")/.."
jobs=$(./run.sh --jobs)
seeds=${TOILE_NIGHTLY_SEEDS:-12} # of the monkey, 10 000 actions each
fuzz_seconds=${TOILE_NIGHTLY_FUZZ:-60}
logs=build/nightly
work=$PWD/$logs/work
mkdir -p "$work"

build() { # PRESET [-DOPTION...] [TARGET...]: with the tests, but for other options
    local preset=$1 options=(-DBUILD_TESTING=ON) targets=() word
    shift
    [ "$preset" != release ] || options+=(-DTOILE_PYTHON=ON) # the tree of ./test.sh
    for word in "$@"; do
        case $word in
            -D*) options+=("$word") ;;
            *) targets+=(--target "$word") ;;
        esac
    done
    cmake --preset "$preset" "${options[@]}" &&
        cmake --build --preset "$preset" --parallel "$jobs" "${targets[@]}"
}

# Suites named Slow: a thousand random pieces, fifty sets of random nests, whole garments by all methods.
step_slow() {
    build release && ctest --preset release -L slow --parallel "$jobs"
}

step_monkey() {
    build release toile_window_test || return
    export TOILE_MONKEY_ACTIONS=10020 QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 TOILE_SAMPLES=4
    seq "$seeds" | xargs -P "$jobs" -I{} env TOILE_MONKEY_SEED={} sh -c \
        'tests/app/own_display.sh build/release/tests/app/toile_window_test monkey >"$0/monkey-{}.log" 2>&1 &&
            echo "seed {} passed" || { echo "seed {} FAILED, see $0/monkey-{}.log"; exit 1; }' "$logs"
}

step_translation() {
    build release toile_window_test || return
    TOILE_STRICT_TRANSLATION=1 QT_QPA_PLATFORM=offscreen build/release/tests/app/toile_window_test translation
}

step_asan-window() {
    build asan-window || return
    # Leaks are those of drivers and of Qt's own singletons; memory is watched, speed is not.
    TOILE_MONKEY_ACTIONS=1000 ASAN_OPTIONS=detect_leaks=0 \
        ctest --preset asan-window -R '^app\.' -LE clock --parallel "$jobs" --timeout 3600
}

step_tsan() {
    build tsan toile_core_test || return
    # What starts threads, is cancelled from another, or is shared by several.
    build/tsan/tests/core/toile_core_test --gtest_brief=1 --gtest_filter='FlattenGarment*:GarmentFlattener*:CompareMethods*:Progress*:Pipeline*:PieceFlattener*:File*:*Cancel*:*Thread*-*Clock*'
}

step_fuzz() { tests/fuzz/run.sh "$fuzz_seconds"; }

step_odr() { tests/one_definition.py && build odr -DBUILD_TESTING=OFF toile; }

step_tidy() { tests/tidy.py --all; }

# A garment of a million triangles and a piece with an outline of 100 000 corners.
step_large() {
    build release toile || return
    python3 tests/large_mesh.py panel 1000000 >"$work/panel.obj" &&
        python3 tests/large_mesh.py star 100000 >"$work/star.obj" || return
    within 60 2 flatten "$work/panel.obj" --unit mm -o "$work/panel.svg" -o "$work/panel.json" &&
        within 20 1 flatten "$work/star.obj" --unit mm -o "$work/star.svg" -o "$work/star.dxf" \
            -o "$work/star.pdf" -o "$work/star.plt" -o "$work/star.glb" -o "$work/star.usda" \
            -o "$work/star.specification.json"
}

# Runs the program, that is to end with 0 within so many seconds of processor time and GiB.
within() {
    local seconds=$1 gib=$2
    shift 2
    prlimit --cpu="$seconds" --as=$((gib << 30)) build/release/app/toile "$@"
}

# Cutting lines of 10 000 random outlines.
step_outlines() {
    build release toile_core_test || return
    TOILE_OUTLINES=10000 build/release/tests/core/toile_core_test --gtest_brief=1 --gtest_filter='*CuttingLine*'
}

step_clock() {
    build release && ctest --preset release -L clock --parallel 1
}

step_bench() { tests/bench/run.sh --no-slow-peers; }

# Opens our files in other programs, if these are installed; two come from npm.
step_clients() {
    build release toile toile_core_test toile_cli_test || return
    local status=0
    ! command -v npm >/dev/null || npm install --prefix "$work/node" three@0.187 gltf-validator@2.0.0-dev.3.10
    export NODE_PATH=$work/node/node_modules
    /usr/bin/python3 tests/clients/run.py --work "$work/clients" || status=1 # the one that has ezdxf
    build/release/tests/core/toile_core_test --gtest_brief=1 --gtest_filter='*Clients*:*PdfViewers*' || status=1
    build/release/tests/cli/toile_cli_test --gtest_brief=1 --gtest_filter='*Judge*' || status=1
    return $status
}

# The add-on in the real Blender: without a window, and with one.
step_blender() {
    build release toile || return
    if ! command -v blender >/dev/null; then
        echo "skipped: blender is not there"
        return
    fi
    # Blender is ended before it can remove its own folder of TMPDIR.
    local HOME=$work/blender TOILE_PROGRAM=$PWD/build/release/app/toile LIBGL_ALWAYS_SOFTWARE=1 status=0
    local TMPDIR=$HOME/tmp
    export HOME TOILE_PROGRAM LIBGL_ALWAYS_SOFTWARE TMPDIR
    rm -rf "$TMPDIR"
    mkdir -p "$TMPDIR"
    blender --background --factory-startup --python tests/blender/in_blender.py || status=1
    tests/app/own_display.sh blender --factory-startup --python tests/blender/in_window.py || status=1
    return $status
}

# The Python module: its tests with twenty times the calls, its wheel in a virtual environment, and what
# the address sanitizer finds. Leaks are CPython's own.
step_python() {
    build release toile toile_python || return
    local wheel=$work/wheel status=0 asan
    TOILE_CALLS=20000 ctest --preset release -R '^python\.' || status=1
    rm -rf "$wheel"
    /usr/bin/python3 -m venv --system-site-packages "$wheel/venv" &&
        TOILE_BUILD=build/release /usr/bin/python3 -m pip wheel --no-build-isolation --no-deps -w "$wheel" . &&
        "$wheel/venv/bin/pip" install --no-deps "$wheel"/toile-*.whl &&
        "$wheel/venv/bin/python" tests/python/arrays_test.py || status=1
    build asan -DTOILE_PYTHON=ON toile toile_python || return
    # With the library of exceptions, which the sanitizer wants to find when it starts.
    asan="$(clang -print-file-name=libclang_rt.asan-x86_64.so) $(clang -print-file-name=libstdc++.so.6)"
    for test in arrays errors prove same_bytes threads; do
        TOILE_CALLS=1000 TOILE_MEMORY=0 ASAN_OPTIONS=detect_leaks=0 LD_PRELOAD=$asan PYTHONPATH=$PWD/build/asan/app/python \
            TOILE_PROGRAM=$PWD/build/asan/app/toile /usr/bin/python3 "tests/python/${test}_test.py" || status=1
    done
    return $status
}

# 500 garments in shards, by Snakemake on two cores and by a Slurm of one node, workers killed at random; and
# how many more two cores do than one.
step_batch() {
    build release toile || return
    local status=0 trial ended
    for trial in local slurm 'throughput --least 1.7'; do
        ended=0
        # shellcheck disable=SC2086 # words
        python3 tests/batch/trial.py $trial || ended=$?
        [ $ended = 0 ] || [ $ended = 77 ] || status=1 # 77: something is not installed, and is named
    done
    return $status
}

# The Debian packages, judged by lintian, and on a system that has nothing else.
step_package() {
    ./run.sh --package && tests/package/judge.sh build/package || return
    if [ "$(id -u)" = 0 ]; then
        tests/package/bare.sh build/package
    else
        echo "bare.sh: skipped, it needs root"
    fi
}

./run.sh --prepare libgtest-dev libbenchmark-dev xvfb clang clang-tidy libclang-rt-14-dev libomp-dev \
    python3-numpy python3-dev python3-venv python3-pip python3-wheel python3-meshio python3-matplotlib \
    pybind11-dev python3-ezdxf librecad inkscape librsvg2-bin hp2xx qpdf mupdf-tools poppler-utils blender \
    snakemake slurmctld slurmd slurm-client munge mmdebstrap lintian || exit
steps=("$@")
[ $# -gt 0 ] || steps=(slow monkey translation asan-window tsan fuzz odr tidy large outlines clock bench clients python blender
    batch package)
rows=()
failed=0
for step in "${steps[@]}"; do
    if ! declare -F "step_$step" >/dev/null; then
        echo "There is no step $step; see tests/nightly.sh" >&2
        exit 2
    fi
    printf '== %-12s ' "$step"
    start=$SECONDS
    if ("step_$step") >"$logs/$step.log" 2>&1; then result=passed; else result=FAILED failed=1; fi
    rows+=("$(printf '%-12s %-7s %4d min %02d s' "$step" $result $(((SECONDS - start) / 60)) $(((SECONDS - start) % 60)))")
    printf '%s, %d s\n' $result $((SECONDS - start))
    [ $result = passed ] || tail -n 30 "$logs/$step.log"
done
printf '\n'
printf '%s\n' "${rows[@]}"
exit $failed
