#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A program outside the project finds the installed library by find_package(Toile), builds against it alone, and
# writes the same bytes as `toile flatten --pattern --allowance 10`.
#
#   consumer_test.sh BUILD      the build whose library is installed, with the program `toile`
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
toile="$build/app/toile"
cd "$work"
for sample in tshirt skirt cap; do
    garment="$here/../../resources/samples/$sample.obj"
    "$toile" flatten "$garment" --pattern --allowance 10 -o "cli.svg" -o "cli.dxf" >/dev/null 2>>log || [ $? -le 1 ]
    "$work/build/consumer" "$garment" own.svg own.dxf
    cmp cli.svg own.svg
    cmp cli.dxf own.dxf
done
