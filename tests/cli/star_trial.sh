#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Flattens stars of so many corners, whose edges all crowd, and says how long each method takes and
# how much memory. Fails beyond 10 s or 1 GB.
#   star_trial.sh TOILE [CORNERS [METHOD...]]
set -eu
toile=$1
corners=${2:-100000}
shift "$(($# < 2 ? $# : 2))"
[ $# -gt 0 ] || set -- isometric curvature wang2005 lscm
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
awk -v n="$corners" 'BEGIN {
    pi = atan2(0, -1)
    print "v 0 0 0"
    for (k = 0; k < n; ++k) {
        r = k % 2 ? 50 : 100
        printf "v %.12g %.12g 0\n", r * cos(2 * pi * k / n), r * sin(2 * pi * k / n)
    }
    for (k = 0; k < n; ++k) print "f 1", k + 2, (k + 1) % n + 2
}' > "$folder/star.obj"
failed=0
for method in "$@"; do
    status=0
    /usr/bin/time -f '%e %M' -o "$folder/cost" \
        "$toile" flatten "$folder/star.obj" --unit mm --method "$method" -o "$folder/star.svg" \
        > "$folder/out" 2>&1 || status=$?
    cat "$folder/out"
    tail -n 1 "$folder/cost" | awk -v method="$method" -v status="$status" '{
        printf "%s: status %d, %.1f s, %.0f MB\n", method, status, $1, $2 / 1024
        exit status > 1 || $1 > 10 || $2 > 1024 * 1024
    }' || failed=1
done
exit "$failed"
