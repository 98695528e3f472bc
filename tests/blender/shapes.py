# SPDX-License-Identifier: GPL-3.0-or-later
"""Small garments of quads, z up, in metres, for tests in and out of Blender."""

from __future__ import annotations

import math

ROUND, ROWS = 24, 10
RADIUS, HEIGHT = 0.2, 0.5


def tube() -> tuple[list[tuple[float, float, float]], list[tuple[int, ...]]]:
    """A skirt: open above and below, no seam."""
    places = []
    for row in range(ROWS + 1):
        radius = RADIUS * (1 + 0.3 * row / ROWS)
        for i in range(ROUND):
            angle = 2 * math.pi * i / ROUND
            places.append(
                (radius * math.cos(angle), radius * math.sin(angle), -HEIGHT * row / ROWS)
            )
    faces = []
    for row in range(ROWS):
        for i in range(ROUND):
            k = (i + 1) % ROUND
            a, b = row * ROUND, (row + 1) * ROUND
            faces.append((b + i, b + k, a + k, a + i))
    return places, faces


def upright_edges(column: int, rows: int = ROWS) -> set[tuple[int, int]]:
    """Of the tube, from its upper rim down."""
    return {(row * ROUND + column, (row + 1) * ROUND + column) for row in range(rows)}
