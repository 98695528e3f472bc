#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints an OBJ that is too large to keep.

    tests/large_mesh.py panel TRIANGLES   a square of cloth bent both ways, 500 mm wide
    tests/large_mesh.py star CORNERS      a flat star, every second corner near the middle: its
                                          edges crowd there
"""
import math
import sys


def panel(triangles):
    side = round(math.sqrt(triangles / 2))
    for row in range(side + 1):
        for column in range(side + 1):
            x, y = column / side - 0.5, row / side - 0.5
            yield f"v {500 * x:.6f} {500 * y:.6f} {300 * x * x - 200 * y * y:.6f}"
    for row in range(side):
        for column in range(side):
            a = row * (side + 1) + column + 1
            yield f"f {a} {a + 1} {a + side + 2}\nf {a} {a + side + 2} {a + side + 1}"


def star(corners):
    yield "v 0 0 0"
    for corner in range(corners):
        angle, radius = 2 * math.pi * corner / corners, 10 if corner % 2 else 1000
        yield f"v {radius * math.cos(angle):.9f} {radius * math.sin(angle):.9f} 0"
    for corner in range(corners):
        yield f"f 1 {corner + 2} {(corner + 1) % corners + 2}"


if len(sys.argv) != 3 or sys.argv[1] not in ("panel", "star"):
    sys.exit(__doc__)
for line in (panel if sys.argv[1] == "panel" else star)(int(sys.argv[2])):
    print(line)
