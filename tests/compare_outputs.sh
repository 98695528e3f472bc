#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Compares what two programs make of the same garments: SVG, DXF, OBJ and JSON (without times), what
# they print and how they end; over resources/samples and, where it stands, ../shared/data.
#
#   tests/compare_outputs.sh OLD NEW [PART...]   two `toile` programs; only cases with PART in their name
#
# Ends with 0 where all is equal to the byte, or listed with its reason in expected_differences.txt.
# The outputs of OLD are kept in build/compare (or $COMPARE), so that a second run is quick.
set -euo pipefail
if [ $# -lt 2 ]; then
    sed -n 's/^# \{0,1\}//; 3,9p' "$0"
    exit 2
fi
exec nice python3 "$(dirname "$0")/compare_outputs.py" "$@"
