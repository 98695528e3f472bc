#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many garments, a row of a table each: a bad file never stops the rest.

python3 batch.py *.obj -o patterns
"""

from __future__ import annotations

import argparse
import csv
from itertools import chain, count
from pathlib import Path

import numpy as np
import toile

FIGURES = ("garment", "pieces", "flat", "strain_p95", "seam_error_mm", "error")


def names_of(paths: list[Path]) -> list[str]:
    """Those of the files, with a number where several are called the same."""
    names: list[str] = []
    for path in paths:
        numbered = (f"{path.stem} {n}" for n in count(2))
        names.append(next(name for name in chain([path.stem], numbered) if name not in names))
    return names


def figures_of(path: Path, name: str, folder: Path) -> dict[str, object]:
    """Writes the pattern of a garment; what is worth knowing of it."""
    row: dict[str, object] = {"garment": name}
    try:
        flat = toile.load(path, auto_cut=True).flatten(pattern=True)
        failed = next((piece.error.code for piece in flat.pieces if piece.error), "")
        if all(piece.error for piece in flat.pieces):  # there is no pattern
            return row | {"pieces": len(flat), "flat": 0, "error": failed}
        flat.write(folder / f"{name}.svg", folder / f"{name}.dxf")
    except toile.Error as error:
        return row | {"error": error.code}
    strains = [np.abs(piece.strain).max(axis=1) for piece in flat.pieces if not piece.error]
    strain = float(np.percentile(np.concatenate(strains), 95))
    errors = [abs(seam.error) for seam in flat.seams if seam.error is not None]
    return row | {
        "pieces": len(flat),
        "flat": len(strains),
        "strain_p95": round(strain, 4),
        "seam_error_mm": round(max(errors, default=0.0), 4),
        "error": failed,
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("garments", nargs="+", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True, help="folder")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    with (arguments.output / "summary.csv").open("w", newline="") as file:
        table = csv.DictWriter(file, FIGURES)
        table.writeheader()
        for path, name in zip(arguments.garments, names_of(arguments.garments)):
            row = figures_of(path, name, arguments.output)
            table.writerow(row)
            print(*(f"{key} {value}" for key, value in row.items() if value != ""), sep=", ")


if __name__ == "__main__":
    main()
