#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of the documentation with the program itself: those of the methods with
# `toile render`, which needs no display, those of the whole window on a virtual one (package xvfb).
#
#   docs/make_pictures.sh                     every picture
#   docs/make_pictures.sh methods             docs/images/method-NAME.png for every method
#   docs/make_pictures.sh methods lscm abf    for these
#   docs/make_pictures.sh patterns            those of the page on patterns, but for the ones that a test takes
#   docs/make_pictures.sh proofs              those of the page on proofs
#   docs/make_pictures.sh blender             that of the page on Blender, where blender is installed
#   docs/make_pictures.sh batch               the summary of a batch, where chromium is installed
#   docs/make_pictures.sh readme              those of the README
#   IMAGES=trial docs/make_pictures.sh        into another folder than docs/images
#   TOILE=build/release/app/toile docs/make_pictures.sh    with another program than build/ci's
set -euo pipefail
cd "$(dirname "$0")/.."
toile=${TOILE:-build/ci/app/toile}
samples=resources/samples
images=${IMAGES:-docs/images}
export LIBGL_ALWAYS_SOFTWARE=1 LC_ALL=C.UTF-8
mkdir -p "$images"
images=$(realpath "$images")

can_make() { # PICTURE PROGRAM: whether what draws it is there; else says so
    command -v "$2" >/dev/null || { echo "skipped: $1 needs $2" && false; }
}

window_picture() { # FILE.png ARGUMENTS...: the whole window
    local file=$1
    shift
    QT_QPA_PLATFORM=xcb tests/app/own_display.sh "$toile" "$@" --screenshot "$file"
    echo "$file"
}

method_picture() { # METHOD: both views and the colour bar of the bodice, which is curved both ways
    local file="$images/method-$1.png"
    env -u DISPLAY "$toile" render "$samples/bodice.obj" --unit mm --up y --method "$1" \
        --overlay strain --size 1200x523 -o "$file"
    echo "$file"
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
        echo "$images/pattern-$name.png"
    done
}

make_patterns_to_cut() { # with allowances and notches
    env -u DISPLAY "$toile" render "$samples/tshirt.obj" --unit mm --view pattern --pattern \
        --overlay none --size 1100x720 -o "$images/pattern-cut.png"
    echo "$images/pattern-cut.png"
}

make_proofs() { # the shirt sewn back together: where it stands off, and where it pulls
    local name
    for name in gap worn-strain; do
        env -u DISPLAY "$toile" prove "$samples/tshirt.obj" --unit mm --up y --overlay $name \
            --size 1500x700 -o "$images/prove-$name.png" > /dev/null
    done
}

make_blender() { # as Blender shows it, with a window
    can_make blender.png blender || return 0
    tests/app/own_display.sh blender --factory-startup --enable-event-simulate \
        --window-geometry 0 0 1500 860 --python docs/blender_picture.py -- \
        "$(realpath "$toile")" "$images/blender.png" >/dev/null
    echo "$images/blender.png"
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
    echo "$images/batch-summary.png"
}

make_readme() {
    window_picture "$images/window.png" "$samples/tshirt.obj" --unit mm
    window_picture "$images/strain.png" "$samples/bodice.obj" --unit mm --up y --overlay strain
    window_picture "$images/area.png" "$samples/cap.obj" --unit mm --up y --overlay area
    window_picture "$images/seams.png" "$samples/tshirt.obj" --unit mm \
        --seams "$samples/tshirt.seams.json" --method natural --panel seams
}

case ${1:-all} in
    methods) make_methods "${@:2}" ;;
    patterns)
        make_patterns
        make_patterns_to_cut
        ;;
    proofs) make_proofs ;;
    blender) make_blender ;;
    batch) make_batch ;;
    readme) make_readme ;;
    all)
        make_methods
        make_patterns
        make_patterns_to_cut
        make_proofs
        make_blender
        make_batch
        make_readme
        ;;
    *) sed -n '3,15s/^# \{0,1\}//p' "$0" && exit 2 ;;
esac
