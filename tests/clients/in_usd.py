# SPDX-License-Identifier: GPL-3.0-or-later
"""USD scenes, which no program of Debian 12 reads: in three.js and usdchecker."""
import json
import pathlib

from check import Check, said_by, same
from triangles import WITHIN, compare, written

SCENE = pathlib.Path(__file__).with_name("three_scene.cjs")


def three(garment):
    """The garment as it is worn and its flat pieces; three.js gives both in metres."""
    file, pieces, worst = garment.file("usda"), written(garment), 0
    said_by("node", SCENE, file)
    scene = json.loads(pathlib.Path(f"{file}.scene.json").read_text(encoding="utf-8"))
    same(sorted(mesh["name"] for mesh in scene), sorted([*pieces, *pieces]), "meshes")
    for mesh in scene:
        seen = [[[1000 * value for value in corner] for corner in triangle]
                for triangle in mesh["corners"]]
        wanted = pieces[mesh["name"]]
        if mesh["of"] == "pattern":
            wanted = [[[u, v, 0, u, v] for _, _, _, u, v in triangle] for triangle in wanted]
        worst = max(worst, compare(seen, wanted, f"{mesh['of']}, {mesh['name']}"))
    return worst


def checked(garment):
    said_by("usdchecker", garment.file("usda"))


CHECKS = [
    Check("USD", "three.js", "places and UV of every triangle, worn and flat", f"{WITHIN} mm", three,
          ("node",), node="three"),
    Check("USD", "usdchecker", "finds nothing", "", checked, ("usdchecker",)),
]
