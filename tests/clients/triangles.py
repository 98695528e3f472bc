# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles with their place and their texture coordinates, as our OBJ text has them."""
import math

from check import require, same

MILLIMETRES = {"mm": 1, "cm": 10, "m": 1000}
WITHIN = 0.001  # mm: the digits of a float of 10 m


def written(garment):
    """Of each piece, by its name with _ for blanks, its triangles: corners of x, y, z, u, v in mm."""
    unit = MILLIMETRES[garment.unit]
    places, flat, pieces, name = [], [], {}, None
    for row in garment.file("obj").read_text(encoding="utf-8").splitlines():
        word, *rest = row.split(" ")
        if word == "v":
            places.append([float(x) * unit for x in rest[:3]])
        elif word == "vt":
            flat.append([float(x) for x in rest[:2]])
        elif word == "g":
            name = row[2:]
        elif word == "f":
            corners = [pair.split("/") for pair in rest]
            pieces.setdefault(name, []).append(
                [[*places[int(v) - 1], *flat[int(vt) - 1]] for v, vt in corners])
    return pieces


def compare(seen, wanted, what):
    """Largest difference of any coordinate, the triangles in the same order."""
    same(len(seen), len(wanted), f"{what}, triangles")
    worst = max(abs(a - b) for ours, theirs in zip(wanted, seen)
                for corner, other in zip(ours, theirs) for a, b in zip(corner, other))
    require(worst <= WITHIN, f"{what}: {worst:.5f} mm off")
    return worst


def flat_area(triangles):
    return math.fsum((b[3] - a[3]) * (c[4] - a[4]) - (c[3] - a[3]) * (b[4] - a[4])
                     for a, b, c in triangles) / 2
