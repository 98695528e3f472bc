#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of the documentation with the program itself, on a virtual display. Needs
# xvfb-run and ImageMagick's convert (packages xvfb and imagemagick).
#
#   docs/make_pictures.sh                     every picture
#   docs/make_pictures.sh methods             docs/images/method-NAME.png for every method
#   docs/make_pictures.sh methods lscm abf    for these
#   docs/make_pictures.sh readme              those of the README
#   TOILE=build/release/app/toile docs/make_pictures.sh    with another program than build/ci's
set -euo pipefail
cd "$(dirname "$0")/.."
toile=${TOILE:-build/ci/app/toile}
samples=resources/samples
images=docs/images
export QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1

picture() { # FILE.png ARGUMENTS...: the whole window
    local file=$1
    shift
    xvfb-run -a -s "-screen 0 1600x1000x24 +extension GLX" \
        "$toile" "$@" --screenshot "$file"
    echo "$file"
}

method_picture() { # METHOD: both views and the colour bar of the bodice, which is curved both ways
    local whole
    whole=$(mktemp --suffix=.png)
    picture "$whole" "$samples/bodice.obj" --unit mm --up y --method "$1" --overlay strain >/dev/null
    convert "$whole" -crop 1600x697+0+55 +repage -resize 1200x -strip \
        "$images/method-$1.png"
    rm -f "$whole"
    echo "$images/method-$1.png"
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

make_readme() {
    picture "$images/window.png" "$samples/tshirt.obj" --unit mm
    picture "$images/strain.png" "$samples/bodice.obj" --unit mm --up y --overlay strain
    picture "$images/area.png" "$samples/cap.obj" --unit mm --up y --overlay area
    picture "$images/seams.png" "$samples/tshirt.obj" --unit mm \
        --seams "$samples/tshirt.seams.json" --method natural --panel seams
}

case ${1:-all} in
    methods) make_methods "${@:2}" ;;
    readme) make_readme ;;
    all) make_methods && make_readme ;;
    *) sed -n '3,11s/^# \{0,1\}//p' "$0" && exit 2 ;;
esac
