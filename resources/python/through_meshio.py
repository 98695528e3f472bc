#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Any mesh that meshio reads becomes a flat pattern with its strain, in any format that it writes.

python3 through_meshio.py dress.obj flat.vtu
"""

from __future__ import annotations

import argparse
from pathlib import Path

import meshio
import toile.bridge


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", type=Path)
    parser.add_argument("output", type=Path)
    parser.add_argument("--unit", default=None, help="of the mesh: mm, cm, m; guessed if not given")
    arguments = parser.parse_args()
    garment = toile.bridge.from_meshio(
        meshio.read(arguments.mesh), name=arguments.mesh.name, unit=arguments.unit
    )
    flat = garment.flatten()
    toile.bridge.to_meshio(flat).write(arguments.output)
    print(f"{len(flat)} pieces, {len(flat.seams)} seams and free edges")


if __name__ == "__main__":
    main()
