# SPDX-License-Identifier: GPL-3.0-or-later
"""OBJ and GLB files in Blender: what it sees of each triangle is what our OBJ text says."""
import json
import math
import pathlib

from check import Check, near, require, said_by, same

SCENE = pathlib.Path(__file__).with_name("blender_scene.py")
MILLIMETRES = {"mm": 1, "cm": 10, "m": 1000}
WITHIN = 0.001  # mm: the digits of a float of 10 m
AREAS = 1e-5  # of an area


def _written(garment):
    """Of each piece its triangles as the OBJ file has them, corners of x, y, z, u, v in mm."""
    unit = MILLIMETRES[garment.unit]
    places, flat, pieces, name = [], [], {}, None
    for row in garment.file("obj").read_text(encoding="utf-8").splitlines():
        word, *rest = row.split(" ")
        if word == "v":
            places.append([float(x) * unit for x in rest[:3]])
        elif word == "vt":
            flat.append([float(x) for x in rest[:2]])
        elif word == "g":
            name = row[2:]  # with _ for blanks
        elif word == "f":
            corners = [pair.split("/") for pair in rest]
            pieces.setdefault(name, []).append(
                [[*places[int(v) - 1], *flat[int(vt) - 1]] for v, vt in corners])
    return pieces


def _seen(garment, kind):
    file = garment.file(kind)
    said_by("blender", "--background", "--factory-startup", "--python", SCENE, "--", file)
    return json.loads(pathlib.Path(f"{file}.scene.json").read_text(encoding="utf-8"))


def _same(seen, written, what):
    """Largest difference of any coordinate, the triangles in the same order."""
    same(len(seen), len(written), f"{what}, triangles")
    worst = 0
    for triangle, ours in zip(seen, written):
        for corner, wanted in zip(triangle, ours):
            worst = max(worst, *(abs(a - b) for a, b in zip(corner, wanted)))
    require(worst <= WITHIN, f"{what}: {worst:.5f} mm off")
    return worst


def _flat_area(triangles):
    return math.fsum((b[3] - a[3]) * (c[4] - a[4]) - (c[3] - a[3]) * (b[4] - a[4])
                     for a, b, c in triangles) / 2


def obj(garment):
    scene, pieces = _seen(garment, "obj"), _written(garment)
    lines = {name for name in scene if name.startswith("pattern_")}
    require({"pattern_cut", "pattern_sew"} <= lines, f"no lines of the pattern: {list(scene)}")
    require(all(scene[name]["edges"] for name in lines), "objects of lines without edges")
    (mesh,) = (scene[name] for name in scene if name not in lines)
    unit = MILLIMETRES[garment.unit]
    seen = [[[*(unit * x for x in corner[:3]), *corner[3:]] for corner in triangle]
            for triangle in mesh["corners"]]
    return _same(seen, [t for triangles in pieces.values() for t in triangles], "the mesh")


def glb(garment):
    """In metres; Blender turns y up into z up."""
    scene, pieces = _seen(garment, "glb"), _written(garment)
    same(len(scene), len(pieces), "meshes")
    worst = 0
    for piece in garment.pieces:
        name = piece["name"]
        seen = [[[1000 * value for value in (x, z, -y, u, w)] for x, y, z, u, w in triangle]
                for triangle in scene[name]["corners"]]
        worst = max(worst, _same(seen, pieces[name.replace(" ", "_")], name))
        near(_flat_area(seen) / piece["area_2d"], 1, AREAS, f"{name}, area")
    return worst


CHECKS = [
    Check("OBJ", "Blender", "places and UV of every triangle; the lines are objects of edges",
          f"{WITHIN} mm", obj, ("blender",)),
    Check("GLB", "Blender", "places and UV of every triangle; areas of the UV as in the report",
          f"{WITHIN} mm", glb, ("blender",)),
]
