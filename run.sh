#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds Toile and flattens a garment: installs what is missing (Debian 12), configures, builds,
# writes the pattern into out/, and opens the window where there is a display.
#
#   ./run.sh                 the T-shirt of resources/samples
#   ./run.sh FILE [OPTIONS]  your own garment; options as of `toile flatten` (--unit cm, ...)
#   ./run.sh --package       Debian packages, into build/package
#   ./run.sh --prepare [PACKAGE...]   only install what building needs, and these packages
#   ./run.sh --jobs          print how many compilers run at once
#
# With --no-install as the first argument apt-get is never called.
set -euo pipefail

caller=$PWD
cd "$(dirname "$0")"

packages=(
    g++ cmake ninja-build ccache
    libeigen3-dev libopenmesh-dev libsuitesparse-dev libcgal-dev
    libopenblas-pthread-dev # by name: Debian's default BLAS is the slow reference one
    nlohmann-json3-dev libpugixml-dev libcli11-dev libxxhash-dev libpolyclipping-dev
    libassimp-dev libzip-dev
    libfreetype-dev libharfbuzz-dev libfontconfig1-dev zlib1g-dev
    qt6-base-dev libqt6opengl6-dev qt6-svg-dev libglm-dev libgl-dev libegl-dev libepoxy-dev
    qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools # translations
    qt6-translations-l10n # Qt's own dialogs in other languages
    libgl1-mesa-dri fonts-dejavu-core
)

# Installs those of the given packages that are missing, and prints their names.
install_missing() {
    [ -z "${TOILE_NO_INSTALL:-}" ] || return 0
    if ! command -v apt-get >/dev/null; then
        echo "This is no Debian system; install these packages' counterparts by hand: $*"
        return
    fi
    local known missing=()
    known=" $(dpkg-query -W -f='${db:Status-Status}:${Package} ' "$@" 2>/dev/null || true)"
    for package in "$@"; do
        [[ $known == *" installed:$package "* ]] || missing+=("$package")
    done
    if [ ${#missing[@]} -eq 0 ]; then
        return
    fi
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "Missing packages, and no sudo to install them; as root, type:" >&2
            echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
            exit 1
        fi
        as_root=(sudo)
    fi
    echo "Installing with apt-get: ${missing[*]}"
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# One compiler for each core, but two GiB of free memory for each compiler.
jobs=$(awk -v cores="$(nproc)" '/^MemAvailable/ { n = int($2 / 2 ^ 21); print n < 1 ? 1 : n < cores ? n : cores }' \
    /proc/meminfo 2>/dev/null || true)
: "${jobs:=1}"
if [ "${1:-}" = --no-install ]; then
    export TOILE_NO_INSTALL=1 # also for the scripts that call this one
    shift
fi
build_folder=build/release
case ${1:-} in
    --help | -h)
        sed -n 's/^#  *\(\.\/run\.sh.*\)/\1/p' "$0"
        exit
        ;;
    --jobs)
        echo "$jobs"
        exit
        ;;
    --prepare)
        shift
        install_missing "${packages[@]}" "$@"
        exit
        ;;
    --package)
        # What describes the program to desktops and packages, and what the parts need of their own.
        packages+=(dpkg-dev file python3 gzip librsvg2-bin python3-dev pybind11-dev python3-numpy)
        build_folder=build/package
        ;;
esac
install_missing "${packages[@]}"

# Prints a line for each object that is missing or older than its sources: the tenths of a second that it took
# last time, or an estimate from the size of its sources, and its name.
plan() {
    ninja -C "$build_folder" -t commands "${targets[@]}" | sed -n 's/.* -o \([^ ]*\.o\) -c \(.*\)$/\1 \2/p' |
        while read -r object source; do
            files=$(sed -n 's/^#include "\(\/.*\)"$/\1/p' "$source" 2>/dev/null)
            # shellcheck disable=SC2086 # words
            if [ -n "$(find ${files:-$source} -newer "$build_folder/$object" 2>&1 | head -n 1)" ]; then
                echo "$object $(cat ${files:-$source} | wc -c)"
            fi
        done | awk -v log_file="$build_folder/.ninja_log" '
            BEGIN {
                while ((getline line <log_file) > 0) {
                    split(line, field, "\t")
                    before[field[4]] = (field[2] - field[1]) / 1000
                }
            }
            # Headers take about two seconds, and the rest one for each 15 kB.
            { printf "%d %s\n", 10 * ($1 in before ? before[$1] : 2 + $2 / 15000), $1 }'
}

# Shows how far the compiler is: one line that changes in a terminal, a line now and then elsewhere.
show_progress() {
    local line object weight elapsed percent left next=0 total=0 finished=0
    local -A weights=()
    while IFS= read -r line; do
        if [[ $line =~ ^plan\ ([0-9]+)\ (.*) ]]; then
            weights[${BASH_REMATCH[2]}]=${BASH_REMATCH[1]}
            total=$((total + BASH_REMATCH[1]))
        fi
        [[ $line =~ ^@([0-9]+)[.0-9]*\ .*Building\ CXX\ object\ (.*) ]] || continue
        elapsed=${BASH_REMATCH[1]} object=${BASH_REMATCH[2]}
        weight=${weights[$object]:-0}
        finished=$((finished + weight))
        ((total > 0 && finished * 10 >= total && elapsed >= 5)) || continue # too early to estimate
        percent=$((100 * finished / total)) left=$((elapsed * (total - finished) / finished))
        if [ -t 1 ]; then
            printf '\r\033[K[ %3d %% ] about %d:%02d left' "$percent" $((left / 60)) $((left % 60))
        elif [ "$percent" -ge "$next" ]; then
            printf '[ %3d %% ] about %d:%02d left\n' "$percent" $((left / 60)) $((left % 60))
            next=$((percent + 10))
        fi
    done
    [ ! -t 1 ] || printf '\r\033[K'
}

build() {
    local options=() targets=(toile)
    if [ "$build_folder" = build/package ]; then
        options=(-DCMAKE_INSTALL_PREFIX=/usr -DTOILE_DEBIAN=ON -DTOILE_PYTHON=ON)
        targets=()
    fi
    # A tree of version 0.1.0 has another option for the tests.
    grep -qs '^BUILD_TESTING:' "$build_folder/CMakeCache.txt" ||
        cmake --preset release -B "$build_folder" "${options[@]}" || return
    plan | sed 's/^/plan /'
    # Elapsed seconds, for show_progress.
    NINJA_STATUS='@%e ' cmake --build "$build_folder" --parallel "$jobs" "${targets[@]/#/--target=}"
}

[ -x "$build_folder/app/toile" ] || echo "Building Toile; the first time takes some minutes ..."
SECONDS=0
if ! build 2>&1 | tee build.log | show_progress; then
    tail -n 40 build.log >&2
    echo "The build failed; the whole log is in build.log." >&2
    exit 1
fi
if [ "$SECONDS" -ge 5 ]; then
    times >build/times # not in a pipe: there it would count its own
    cpu=$(awk 'NR == 2 { split($0, t, /[ms ]+/); print int((t[1] + t[3]) * 60 + t[2] + t[4]) }' build/times)
    printf 'Built in %d:%02d minutes, %d:%02d of processor time.\n' \
        $((SECONDS / 60)) $((SECONDS % 60)) $((cpu / 60)) $((cpu % 60))
fi

if [ "$build_folder" = build/package ]; then
    (cd build/package && rm -f ./*.deb && cpack >cpack.log) || {
        tail -n 20 build/package/cpack.log >&2
        exit 1
    }
    echo "Made in build/package:"
    (cd build/package && ls -- *.deb)
    echo "To install: sudo apt-get install ./build/package/toile_*.deb"
    exit
fi

toile=$PWD/build/release/app/toile
if [ $# -gt 0 ]; then
    garment=$1
    shift
    case $garment in
        /*) ;;
        *) garment=$caller/$garment ;;
    esac
else
    garment=resources/samples/tshirt.obj
    set -- --unit mm
fi

name=$(basename "${garment%.*}")
mkdir -p out
status=0
"$toile" flatten "$garment" "$@" \
    -o "out/$name.svg" -o "out/$name.dxf" -o "out/$name.obj" -o "out/$name.json" || status=$?

if [ "$status" -le 1 ] && [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    reading=()
    while [ $# -gt 0 ]; do # of the options, those of reading concern the window too
        case $1 in
            --unit | --up | --split | --seams | --as | --surface | --layer | --cut-style | \
                --max-strain | --enough | --close-holes | --smooth | --remesh | --weld-within)
                reading+=("$1" "$2") ;;
            --unit=* | --up=* | --split=* | --seams=* | --as=* | --surface=* | --layer=* | \
                --cut-style=* | --max-strain=* | --enough=* | --close-holes=* | --smooth=* | --remesh=* | \
                --weld-within=* | --turn-over | --keep-debris | --auto-cut | --swap-front | --weld | --strict | --close-slits | --complete-half)
                reading+=("$1") ;;
        esac
        shift
    done
    echo "Opening the window ..."
    "$toile" "$garment" "${reading[@]}"
fi
exit "$status"
