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
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from . import _core
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

_INT_MAX = np.iinfo(np.int32).max


def load(
    *paths: str | os.PathLike[str],
    progress: Callable[[float], object] | None = None,
    **options: Any,
) -> Garment:
    """Reads mesh files as one garment, or a project (.toile).

    progress: called every 50 ms with the fraction done; an exception of it cancels, as Ctrl-C does.
    options: those of `toile flatten` about reading: unit="cm", up="z", split="uv", auto_cut=True,
        cut_style="topology", weld=True, as_="scan", strict=True; seams: a seams file, or what
        stands in one as a dictionary (docs/seams.md).

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
        in C order is read where it lies. A face with an index out of range is left out, and
        listed among `problems`.
    vt: (T, 2) numbers: a UV map, which may divide the garment into pieces.
    ft: as `faces`, rows of `vt`; -1 for none. None: as `faces`.
    objects, groups, materials: the name of each face, a sequence of F strings or numbers; what
        files call o, g and usemtl.
    name: of the file that would hold the mesh: "tee.obj". Files that are written name it.
    decimals: with how many the OBJ export repeats the vertices, as a file's own digits; None: as
        many as give the same numbers again.
    progress, options: as of load(); unit is guessed from the size where it is not given.

    Everything is copied once, into the garment. Raises TypeError and ValueError for arrays of
    another shape; Error, UsageError.
    """
    points = _numbers(vertices, "vertices", 3)
    start, corners = _polygons(faces, "faces", len(points))
    uvs = np.empty((0, 2)) if vt is None else _numbers(vt, "vt", 2)
    corner_uvs = np.empty(0, np.int32)
    if vt is not None:
        uv_start, corner_uvs = (
            (start, corners) if ft is None else _polygons(ft, "ft", len(uvs))
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
        _names(objects, "objects", count),
        _names(groups, "groups", count),
        _names(materials, "materials", count),
        os.fsencode(name),
        -1 if decimals is None else _decimals(decimals),
        progress=progress,
        **options,
    )


def _numbers(given: Any, name: str, columns: int) -> np.ndarray:
    array = np.asarray(given)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} holds {array.dtype}, not numbers")
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{name} has the shape {array.shape}, not (n, {columns})")
    return np.ascontiguousarray(array, np.float64)


def _indices(array: np.ndarray, name: str, count: int) -> np.ndarray:
    if array.dtype.kind not in "iu" and array.size > 0:
        raise TypeError(f"{name} holds {array.dtype}, not whole numbers")
    if array.dtype != np.int32 and array.size > 0:
        if array.min() < -1 or array.max() > max(count, 0):  # out of range either way
            array = np.clip(array, -2, _INT_MAX)
    return np.ascontiguousarray(array, np.int32)


def _polygons(given: Any, name: str, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Where each face starts, and the corners of all."""
    if not isinstance(given, np.ndarray) and isinstance(given, Sequence):
        sizes = [len(face) for face in given]
        if len(set(sizes)) > 1:
            start = np.concatenate([[0], np.cumsum(sizes, dtype=np.int64)])
            _check_count(start[-1], name)
            corners = np.concatenate([np.asarray(face) for face in given if len(face) > 0])
            return start.astype(np.int32), _indices(corners, name, count)
    array = np.asarray(given)
    if array.size == 0:
        return np.zeros(1, np.int32), np.empty(0, np.int32)
    if array.ndim != 2:
        raise ValueError(f"{name} has the shape {array.shape}, not (n, corners)")
    _check_count(array.size, name)
    start = np.arange(0, array.size + 1, array.shape[1], dtype=np.int32)
    return start, _indices(array, name, count).ravel()


def _check_count(corners: int, name: str) -> None:
    if corners > _INT_MAX:
        raise ValueError(f"{name} has {corners} corners, more than {_INT_MAX}")


def _plain(value: Any) -> Any:
    """Of seams, what JSON does not know."""
    if isinstance(value, Mapping):
        return dict(value)
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"seams hold a {type(value).__name__}")


def _names(given: Any, name: str, count: int) -> tuple[list[str], np.ndarray]:
    """The names in the order in which they come first, and which each face has."""
    if given is None:
        return [], np.empty(0, np.int32)
    if isinstance(given, (str, bytes, Mapping)) or len(given) != count:
        raise ValueError(f"{name} is one name for each of {count} faces")
    index: dict[str, int] = {}
    of_face = np.fromiter(
        (-1 if one is None else index.setdefault(str(one), len(index)) for one in given),
        np.int32,
        count,
    )
    return list(index), of_face


def _decimals(given: int) -> int:
    if not 0 <= given <= 17:
        raise ValueError("decimals is a number from 0 to 17")
    return int(given)
