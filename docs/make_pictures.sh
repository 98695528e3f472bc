#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of the documentation with the program itself. The pictures of methods come from
# `toile render`, which needs no display; those of the whole window need a virtual display (package xvfb).
# Each picture is reduced to 256 colours if pngquant is installed; the repository keeps only such pictures.
#
#   docs/make_pictures.sh                     every picture
#   docs/make_pictures.sh methods             docs/images/method-NAME.png for every method
#   docs/make_pictures.sh methods lscm abf    for these methods
#   docs/make_pictures.sh patterns            docs/images/pattern-{exact,fair,cut}.png
#   docs/make_pictures.sh proofs              docs/images/prove-*.png
#   docs/make_pictures.sh blender             docs/images/blender.png; needs blender
#   docs/make_pictures.sh batch               docs/images/batch-summary.png; needs chromium
#   docs/make_pictures.sh readme              the pictures of the README
#   docs/make_pictures.sh window              those of the window's states, and what tests take on their way
#   docs/make_pictures.sh compress            reduce the colours of all pictures, or of the files named
#   IMAGES=trial docs/make_pictures.sh        write into another folder than docs/images (all but window)
#   TOILE=build/dev/app/toile docs/make_pictures.sh    use another program than build/release's
set -euo pipefail
cd "$(dirname "$0")/.."
toile=${TOILE:-build/release/app/toile}
samples=resources/samples
images=${IMAGES:-docs/images}
export LIBGL_ALWAYS_SOFTWARE=1 LC_ALL=C.UTF-8
mkdir -p "$images"
images=$(realpath "$images")

compress() { # FILE.png...: to a palette of 256 colours, about a third of the size
    command -v pngquant >/dev/null || return 0
    # Status 98: the result would be larger, so the file stays as it was.
    pngquant --speed 1 --strip --skip-if-larger --force --ext .png -- "$@" || [ $? -eq 98 ]
}

finish() { # FILE.png: compresses it and prints its name
    compress "$1"
    echo "$1"
}

can_make() { # PICTURE PROGRAM: whether the program that draws the picture is installed
    command -v "$2" >/dev/null || { echo "skipped: $1 needs $2" && false; }
}

window_picture() { # FILE.png ARGUMENTS...: the whole window
    local file=$1
    shift
    QT_QPA_PLATFORM=xcb tests/app/own_display.sh "$toile" "$@" --screenshot "$file"
    finish "$file"
}

method_picture() { # METHOD: both views and the colour bar of the bodice, which is curved both ways
    local file="$images/method-$1.png"
    env -u DISPLAY "$toile" render "$samples/bodice.obj" --unit mm --up y --method "$1" \
        --overlay strain --size 1200x523 -o "$file"
    finish "$file"
}

method_names() { # as the program lists them
    "$toile" compare --help | sed -n 's/^ *--methods \([a-z0-9,]*\).*/\1/p' | tr ',' ' '
}

make_methods() {
    local name
    for name in ${*:-$(method_names)}; do
        method_picture "$name"
    done
}

make_patterns() { # the bodice's pattern, exact and drawn
    local name
    for name in exact fair; do
        env -u DISPLAY "$toile" render "$samples/bodice.obj" --unit mm --up y --view pattern \
            --overlay none $([ $name = exact ] || echo --true) --size 900x640 \
            -o "$images/pattern-$name.png"
        finish "$images/pattern-$name.png"
    done
}

make_patterns_to_cut() { # with allowances and notches
    env -u DISPLAY "$toile" render "$samples/tshirt.obj" --unit mm --view pattern --pattern \
        --overlay none --size 1100x720 -o "$images/pattern-cut.png"
    finish "$images/pattern-cut.png"
}

make_proofs() { # the shirt sewn back together: where it stands off, and where it pulls
    local name
    for name in gap worn-strain; do
        env -u DISPLAY "$toile" prove "$samples/tshirt.obj" --unit mm --up y --overlay $name \
            --size 1500x700 -o "$images/prove-$name.png" >/dev/null
        finish "$images/prove-$name.png"
    done
}

make_blender() { # as Blender shows it, with a window
    can_make blender.png blender || return 0
    tests/app/own_display.sh blender --factory-startup --enable-event-simulate \
        --window-geometry 0 0 1500 860 --python docs/blender_picture.py -- \
        "$(realpath "$toile")" "$images/blender.png" >/dev/null
    finish "$images/blender.png"
}

make_batch() {
    local work status=0
    can_make batch-summary.png chromium || return 0
    work=$(mktemp -d)
    tests/batch/make_garments.py "$work" 500
    "$toile" batch "$work/list.txt" -o "$work/out" >/dev/null || status=$?
    [ $status -le 1 ] # 1: the bad files among them
    resources/batch/summary.py "$work/out" --html "$work/summary.html"
    chromium --headless --no-sandbox --hide-scrollbars --window-size=1000,1600 \
        --screenshot="$images/batch-summary.png" "file://$work/summary.html" 2>/dev/null
    rm -r "$work"
    finish "$images/batch-summary.png"
}

make_readme() {
    window_picture "$images/window.png" "$samples/tshirt.obj" --unit mm
    window_picture "$images/strain.png" "$samples/bodice.obj" --unit mm --up y --overlay strain
    window_picture "$images/seams.png" "$samples/tshirt.obj" --unit mm \
        --seams "$samples/tshirt.seams.json" --method natural --panel seams
}

make_window() { # with the programs of the tests, which go to the states that the pages describe
    local name status=0 program=build/release/tests/app/toile_window_test
    [ -x "$program" ] || { echo "skipped: the pictures of the window need ./test.sh --quick" && return; }
    for name in window_pictures reading_pictures whole_pattern first_steps; do
        TOILE_UPDATE_DOCS=1 TOILE_SAMPLES=4 QT_QPA_PLATFORM=xcb tests/app/own_display.sh "$program" "$name" \
            >/dev/null || { echo "$name failed" >&2 && status=1; }
    done
    compress docs/images/{window,input,first-steps,pattern,marker,export,print}-*.png
    return $status
}

command -v pngquant >/dev/null || echo "pngquant is not installed: pictures keep all their colours" >&2
case ${1:-all} in
    compress)
        shift
        [ $# -gt 0 ] || set -- "$images"/*.png
        compress "$@"
        ;;
    methods) make_methods "${@:2}" ;;
    patterns)
        make_patterns
        make_patterns_to_cut
        ;;
    proofs) make_proofs ;;
    blender) make_blender ;;
    batch) make_batch ;;
    readme) make_readme ;;
    window) make_window ;;
    all)
        make_methods
        make_patterns
        make_patterns_to_cut
        make_proofs
        make_blender
        make_batch
        make_readme
        make_window
        ;;
    *) sed -n '3,18s/^# \{0,1\}//p' "$0" && exit 2 ;;
esac
