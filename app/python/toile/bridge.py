# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of other packages: meshio, and what looks like a trimesh.Trimesh. Neither is needed."""

from __future__ import annotations

import re
from numbers import Real
from typing import Any

import numpy as np

from . import FlatGarment, Garment, garment

# Cells that are faces, and how many of their nodes are corners; nodes of higher orders come behind.
_FACE = re.compile(r"(triangle|quad|polygon)\d*")
_CORNERS = {"triangle": 3, "quad": 4, "polygon": None}


def from_meshio(mesh: Any, **options: Any) -> Garment:
    """A garment of the triangles, quads and polygons of a meshio.Mesh;
    of cells of higher order, "triangle6", those of their corners.

    Of `cell_data` an "obj:group_ids", "gmsh:physical" or "groups" names the group of each face; an
    "obj:vt" of `point_data` is its UV map. options: as of toile.garment.
    """
    kinds = [_FACE.fullmatch(block.type) for block in mesh.cells]
    kept = [k for k, kind in enumerate(kinds) if kind]
    faces = [face[: _CORNERS[kinds[k][1]]] for k in kept for face in mesh.cells[k].data]
    for key in ("obj:group_ids", "gmsh:physical", "groups"):
        if key in mesh.cell_data and "groups" not in options:
            options["groups"] = [
                None if _is_no_group(one, key) else one
                for k in kept
                for one in np.ravel(mesh.cell_data[key][k])
            ]
    uv = mesh.point_data.get("obj:vt")
    if uv is not None and "vt" not in options and len(uv) == len(mesh.points):
        options["vt"] = np.asarray(uv)[:, :2]
    points = np.asarray(mesh.points, np.float64)
    return garment(points, faces, **options)


def _is_no_group(tag: Any, key: str) -> bool:
    """meshio numbers groups of an OBJ from 0, faces before the first -1; Gmsh from 1."""
    return isinstance(tag, Real) and tag < (1 if key.startswith("gmsh:") else 0)


def from_trimesh(mesh: Any, **options: Any) -> Garment:
    """A garment of an object with `vertices` (V, 3) and `faces` (F, 3), such as a trimesh.Trimesh;
    with its `visual.uv` (V, 2), if it has one, as UV map. options: as of toile.garment.
    """
    uv = getattr(getattr(mesh, "visual", None), "uv", None)
    if uv is not None and "vt" not in options:
        options["vt"] = np.asarray(uv)
    return garment(np.asarray(mesh.vertices), np.asarray(mesh.faces), **options)


def to_meshio(flat: FlatGarment, *, worn: bool = False) -> Any:
    """All pieces that are flat as one meshio.Mesh, mm: where they lie on the sheet, z = 0; or as
    they are worn.

    cell_data: "piece", the index of the piece, and "strain", the principal strain of larger size.
    point_data: "flat" (V, 2) on the sheet, and "worn" (V, 3).
    """
    import meshio

    points, flats, faces, pieces, strains = [], [], [], [], []
    first = 0
    for index, (piece, drawn) in enumerate(zip(flat.pieces, flat.pattern.pieces)):
        if piece.positions is None or drawn.place is None:
            continue
        at = piece.positions @ drawn.place[:, :2].T + drawn.place[:, 2]
        flats.append(at)
        points.append(piece.piece.vertices)
        faces.append(piece.piece.faces + first)
        pieces.append(np.full(len(piece.piece.faces), index, np.int32))
        larger = np.abs(piece.strain).argmax(axis=1)
        strains.append(piece.strain[np.arange(len(larger)), larger])
        first += len(at)
    if not points:
        return meshio.Mesh(np.empty((0, 3)), [])
    on_sheet, in_space = np.concatenate(flats), np.concatenate(points)
    level = np.column_stack([on_sheet, np.zeros(len(on_sheet))])
    return meshio.Mesh(
        in_space if worn else level,
        [("triangle", np.concatenate(faces))],
        point_data={"flat": on_sheet, "worn": in_space},
        cell_data={"piece": [np.concatenate(pieces)], "strain": [np.concatenate(strains)]},
    )
