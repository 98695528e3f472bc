# SPDX-License-Identifier: GPL-3.0-or-later
"""OBJ and GLB files in Blender: what it sees of each triangle is what our OBJ text says."""
import json
import pathlib

from check import Check, near, require, said_by, same
from triangles import MILLIMETRES, WITHIN, compare, flat_area, written

SCENE = pathlib.Path(__file__).with_name("blender_scene.py")
AREAS = 1e-5  # of an area


def _seen(garment, kind):
    file = garment.file(kind)
    said_by("blender", "--background", "--factory-startup", "--python", SCENE, "--", file)
    return json.loads(pathlib.Path(f"{file}.scene.json").read_text(encoding="utf-8"))


def obj(garment):
    scene, pieces = _seen(garment, "obj"), written(garment)
    lines = {name for name in scene if name.startswith("pattern_")}
    require({"pattern_cut", "pattern_sew"} <= lines, f"no lines of the pattern: {list(scene)}")
    require(all(scene[name]["edges"] for name in lines), "objects of lines without edges")
    (mesh,) = (scene[name] for name in scene if name not in lines)
    unit = MILLIMETRES[garment.unit]
    seen = [[[*(unit * x for x in corner[:3]), *corner[3:]] for corner in triangle]
            for triangle in mesh["corners"]]
    return compare(seen, [t for triangles in pieces.values() for t in triangles], "the mesh")


def glb(garment):
    """In metres; Blender turns y up into z up."""
    scene, pieces = _seen(garment, "glb"), written(garment)
    same(len(scene), len(pieces), "meshes")
    worst = 0
    for piece in garment.pieces:
        name = piece["name"]
        seen = [[[1000 * value for value in (x, z, -y, u, w)] for x, y, z, u, w in triangle]
                for triangle in scene[name]["corners"]]
        worst = max(worst, compare(seen, pieces[name.replace(" ", "_")], name))
        near(flat_area(seen) / piece["area_2d"], 1, AREAS, f"{name}, area")
    return worst


CHECKS = [
    Check("OBJ", "Blender", "places and UV of every triangle; the lines are objects of edges",
          f"{WITHIN} mm", obj, ("blender",)),
    Check("GLB", "Blender", "places and UV of every triangle; areas of the UV as in the report",
          f"{WITHIN} mm", glb, ("blender",)),
]
