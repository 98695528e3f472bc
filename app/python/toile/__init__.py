# SPDX-License-Identifier: GPL-3.0-or-later
"""Toile flattens 3D garment meshes into sewing patterns.

    import toile

    tee = toile.load("tee.obj", unit="cm")
    flat = tee.flatten(method="isometric")
    flat.pieces[0].positions        # float64 (V, 2), mm
    flat.write("tee.svg", "tee.dxf")

Lengths are millimetres, areas mm2, angles radians; strains and shares are parts of 1. Keyword
arguments are the long options of the command line with underscores: `auto_cut=True` is
`--auto-cut`, `fair=(0.5, 40)` is `--fair 0.5,40`, `as_="scan"` is `--as scan`. Arrays that come
out are read-only views of memory that the objects own and share.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from . import _arrays, _core
from ._core import (
    FlatGarment,
    FlatPiece,
    FlatSeam,
    Garment,
    Pattern,
    PatternPiece,
    Piece,
    Problem,
    Proof,
    ProvenPiece,
    Seam,
    Written,
    formats,
    methods,
)
from .errors import Error, FileError, UsageError

__version__: str = _core.__version__

__all__ = [
    "Error",
    "FileError",
    "FlatGarment",
    "FlatPiece",
    "FlatSeam",
    "Garment",
    "Pattern",
    "PatternPiece",
    "Piece",
    "Problem",
    "Proof",
    "ProvenPiece",
    "Seam",
    "UsageError",
    "Written",
    "formats",
    "garment",
    "load",
    "methods",
]


def load(
    *paths: str | os.PathLike[str],
    progress: Callable[[float], object] | None = None,
    **options: Any,
) -> Garment:
    """Reads mesh files as one garment, or a project (.toile).

    progress: called every 50 ms with the fraction done, and at the end with 1; an exception of it
        cancels, as Ctrl-C does.
    options: those of `toile flatten` about reading: unit="cm", or the millimetres in one, 25.4;
        up="z", split="uv", auto_cut=True, cut_style="topology", weld=True, as_="scan",
        strict=True; seams: a seams file, or what stands in one as a dictionary (docs/seams.md).

    Runs without the interpreter's lock. Raises FileError, Error ("no-geometry"), UsageError.
    """
    if not paths:
        raise UsageError("load() takes the path of a garment", "wrong-usage")
    return _core.load([os.fsencode(path) for path in paths], progress=progress, **options)


def garment(
    vertices: Any,
    faces: Any,
    *,
    vt: Any = None,
    ft: Any = None,
    objects: Any = None,
    groups: Any = None,
    materials: Any = None,
    name: str = "garment",
    decimals: int | None = None,
    progress: Callable[[float], object] | None = None,
    **options: Any,
) -> Garment:
    """A garment of arrays: the same as of a mesh file that holds them.

    vertices: (V, 3) numbers, in `unit`. float64 in C order is read where it lies.
    faces: (F, k) whole numbers, rows of `vertices`; or a list of polygons of several sizes. int32
        in C order is read where it lies. -1 behind three corners or more fills a row up, as of
        triangles among quads. A face with an index out of range is left out, and listed among
        `problems`.
    vt: (T, 2) numbers: a UV map, which may divide the garment into pieces.
    ft: as `faces`, rows of `vt`; -1 for none. None: as `faces`.
    objects, groups, materials: the name of each face, a sequence of F strings, bytes or numbers;
        what files call o, g and usemtl. None: it has no name.
    name: of the file that would hold the mesh: "tee.obj". Files that are written name it.
    decimals: with how many the OBJ export repeats the vertices, as a file's own digits; None: as
        many as give the same numbers again.
    progress, options: as of load(); unit is guessed from the size where it is not given.

    Everything is copied once, into the garment. Raises TypeError and ValueError for arrays of
    another kind or shape, and for masked ones; Error, UsageError.
    """
    points = _arrays.numbers(vertices, "vertices", 3)
    start, corners = _arrays.polygons(faces, "faces", len(points))
    uvs = np.empty((0, 2)) if vt is None else _arrays.numbers(vt, "vt", 2)
    corner_uvs = np.empty(0, np.int32)
    if vt is not None:
        uv_start, corner_uvs = (
            (start, corners) if ft is None else _arrays.polygons(ft, "ft", len(uvs), np.diff(start))
        )
        if not np.array_equal(start, uv_start):
            raise ValueError("ft and faces have polygons of other sizes")
    elif ft is not None:
        raise ValueError("ft is of vt, which is not given")
    count = len(start) - 1
    return _core.garment_of_arrays(
        points,
        start,
        corners,
        uvs,
        corner_uvs,
        _arrays.names(objects, "objects", count),
        _arrays.names(groups, "groups", count),
        _arrays.names(materials, "materials", count),
        os.fsencode(name),
        -1 if decimals is None else _arrays.decimals(decimals),
        progress=progress,
        **options,
    )


def _plain(value: Any) -> Any:
    """Of seams, what JSON does not know."""
    if isinstance(value, Mapping):
        return dict(value)
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"seams hold a {type(value).__name__}")
