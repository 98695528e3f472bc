#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A program of somebody else finds the installed library by find_package(Toile), builds against it alone,
# and flattens a garment to seams of equal sides.
#
#   consumer_test.sh BUILD      the build whose library is installed
set -euo pipefail
build=$1
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/installed" --component dev >/dev/null
if grep -rlF "$(cd "$here/../.." && pwd)" "$work/installed" --include='*.cmake'; then
    echo "These name the folder that the library was built from." >&2
    exit 1
fi
cmake -S "$here/consumer" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_PREFIX_PATH="$work/installed" -DCMAKE_CXX_FLAGS=-Werror >"$work/log"
cmake --build "$work/build" >>"$work/log" || { cat "$work/log"; exit 1; }
"$work/build/consumer" "$here/../../resources/samples/tshirt.obj" | tee "$work/seams"
awk '{ difference = $(NF - 1) - $NF; if (difference * difference > 1e-10) bad = 1 }
     END { exit bad || NR != 14 }' "$work/seams" || { echo "The T-shirt has 14 seams of equal sides." >&2; exit 1; }
