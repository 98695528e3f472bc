#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A notebook in one file: where must the cloth stretch, and how do methods compare?

python3 pictures.py bodice.obj -o pictures
"""

# %% What is looked at
from __future__ import annotations

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import toile
from matplotlib.collections import PolyCollection

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("garment", type=Path)
parser.add_argument("-o", "--output", type=Path, default=Path("pictures"))
arguments = parser.parse_args()
arguments.output.mkdir(parents=True, exist_ok=True)
garment = toile.load(arguments.garment, auto_cut=True)
flat = garment.flatten(pattern=True)

# %% The pattern, coloured by how much each triangle must stretch
WIDEST = 5.0  # per cent, at the ends of the colours


def draw(axes: plt.Axes, shown: toile.FlatGarment) -> PolyCollection:
    """All pieces where they lie on the sheet."""
    triangles, strains = [], []
    for piece, drawn in zip(shown.pieces, shown.pattern.pieces):
        if piece.positions is None or drawn.place is None:
            continue
        turn, offset = drawn.place[:, :2].T, drawn.place[:, 2]
        at = piece.positions @ turn + offset
        triangles.append(at[piece.piece.faces])
        strain = piece.strain
        larger = np.abs(strain).argmax(axis=1)
        strains.append(100 * strain[np.arange(len(strain)), larger])
        line = drawn.cutting_line @ turn + offset
        axes.fill(*line.T, facecolor="none", edgecolor="#444444", linewidth=0.7)
    cloth = PolyCollection(np.concatenate(triangles), cmap="RdBu_r", edgecolor="face")
    cloth.set_linewidth(0.1)
    cloth.set_array(np.concatenate(strains))
    cloth.set_clim(-WIDEST, WIDEST)
    axes.add_collection(cloth)
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set_axis_off()
    return cloth


figure, axes = plt.subplots(figsize=(7, 6), layout="compressed")
bar = figure.colorbar(draw(axes, flat), ax=axes, shrink=0.7, extend="both")
bar.set_label("strain the cloth must take, %")
axes.set_title(f"{arguments.garment.stem}: {len(flat)} pieces")
figure.savefig(arguments.output / "strain.png", dpi=120)

# %% Methods: what seams and cloth pay
METHODS = ("isometric", "curvature", "lscm")
results = {method: garment.flatten(method=method) for method in METHODS}


def figures_of(shown: toile.FlatGarment) -> tuple[float, float]:
    """The worst seam, mm; and the strain that a twentieth of the triangles exceeds, %."""
    seams = [abs(seam.error) for seam in shown.seams if seam.error is not None]
    strains = [np.abs(piece.strain).max(axis=1) for piece in shown.pieces if not piece.error]
    return max(seams, default=0.0), 100 * float(np.percentile(np.concatenate(strains), 95))


paid = {method: figures_of(shown) for method, shown in results.items()}
for method, (seam, strain) in paid.items():
    print(f"{method:10} worst seam {seam:6.2f} mm, strain {strain:5.2f} %")

figure, sides = plt.subplots(1, 2, figsize=(9, 3.2), layout="constrained")
TITLES = ("worst seam, mm", "strain that 5 % of triangles exceed, %")
for axes, index, title in zip(sides, (0, 1), TITLES):
    bars = axes.barh(list(METHODS), [paid[method][index] for method in METHODS], color="#4878a8")
    axes.bar_label(bars, fmt="%.2f", padding=3)
    axes.invert_yaxis()
    axes.margins(x=0.15)
    axes.set_title(title)
    axes.spines[["top", "right"]].set_visible(False)
figure.savefig(arguments.output / "methods.png", dpi=120)
