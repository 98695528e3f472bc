# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays and lists as the compiled part takes them; or a sentence that says why they are none.

What is of the wrong kind is a TypeError, what is of the wrong shape a ValueError.
"""

from __future__ import annotations

import operator
from collections.abc import Iterator, Mapping, Sequence, Set
from typing import Any

import numpy as np

_INT_MAX = np.iinfo(np.int32).max
_MOST_DECIMALS = 17
_FEWEST_CORNERS = 3


def numbers(given: Any, name: str, columns: int) -> np.ndarray:
    """float64 (n, columns)."""
    wanted = f"(n, {columns})"
    array = _array(given, name, wanted)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} holds {array.dtype}, not numbers")
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{name} has the shape {array.shape}, not {wanted}")
    return np.ascontiguousarray(array, np.float64)


def polygons(
    given: Any, name: str, count: int, sizes: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Where each face starts, and the corners of all, rows of so many points.

    sizes: how many corners each face is known to have; None: where a row ends, or -1 fills it up.
    """
    if isinstance(given, np.ndarray) and given.dtype == object:
        raise TypeError(
            f"{name} is an array of objects{_two_sizes(given)}; give the list of its polygons, "
            f"{name}.tolist(), or rows filled up with -1"
        )
    if not isinstance(given, np.ndarray) and isinstance(given, Sequence):
        several = _of_several_sizes(given, name, count)
        if several is not None:
            return several
    array = _array(given, name, "(n, corners)")
    if array.size == 0:
        return np.zeros(1, np.int32), np.empty(0, np.int32)
    if array.ndim != 2:
        raise ValueError(f"{name} has the shape {array.shape}, not (n, corners)")
    _check_count(array.size, name)
    corners = _indices(array, name, count)
    is_corner = _corners_filled_up(corners) if sizes is None else _corners_of(corners, sizes)
    if is_corner is None:
        return np.arange(0, array.size + 1, array.shape[1], dtype=np.int32), corners.ravel()
    start = np.concatenate([[0], np.cumsum(is_corner.sum(axis=1))])
    return start.astype(np.int32), corners[is_corner]


def names(given: Any, name: str, count: int) -> tuple[list[bytes], np.ndarray]:
    """The names in the order in which they come first, and which each face has."""
    if given is None:
        return [], np.empty(0, np.int32)
    if isinstance(given, (np.ndarray, Iterator)):
        given = _array(given, name, f"({count},)")
        given = given[:, 0] if given.ndim == 2 and given.shape[1] == 1 else given
        if given.ndim != 1:
            raise ValueError(f"{name} has the shape {given.shape}, not ({count},)")
    is_one_each = hasattr(given, "__len__") and len(given) == count
    if not is_one_each or isinstance(given, (str, bytes, Mapping, Set)):
        raise ValueError(f"{name} is one name for each of {count} faces")
    index: dict[bytes, int] = {}
    of_face = np.fromiter(
        (
            -1 if one is None else index.setdefault(_name(one, name, face), len(index))
            for face, one in enumerate(given)
        ),
        np.int32,
        count,
    )
    return list(index), of_face


def decimals(given: Any) -> int:
    try:
        number = operator.index(given)
    except TypeError:
        number = -1
    if not 0 <= number <= _MOST_DECIMALS:
        raise ValueError(f"decimals is a whole number from 0 to {_MOST_DECIMALS}, not {given!r}")
    return number


def _array(given: Any, name: str, wanted: str) -> np.ndarray:
    if isinstance(given, Iterator):
        kind = type(given).__name__
        raise TypeError(f"{name} is a {kind}, which is read but once; give list({name})")
    if isinstance(given, np.ma.MaskedArray):
        if np.ma.is_masked(given):
            raise TypeError(f"{name} is masked in places; leave these out, or fill them")
        return np.ma.getdata(given)
    try:
        return np.asarray(given)
    except ValueError:
        raise ValueError(f"{name} has rows of several lengths, not the shape {wanted}") from None


def _of_several_sizes(
    given: Sequence[Any], name: str, count: int
) -> tuple[np.ndarray, np.ndarray] | None:
    """None where all are of one size, or it is no list of rows."""
    is_row = [hasattr(face, "__len__") for face in given]
    if not any(is_row):
        return None
    if not all(is_row):
        face = is_row.index(False)
        raise TypeError(f"{name}[{face}] is {given[face]!r:.60}, not the corners of a face")
    sizes = [len(face) for face in given]
    if len(set(sizes)) == 1:
        return None
    start = np.concatenate([[0], np.cumsum(sizes, dtype=np.int64)])
    _check_count(start[-1], name)
    rows = [_array(face, name, "(corners,)") for face in given if len(face) > 0]
    if any(row.ndim != 1 for row in rows):
        raise ValueError(f"{name} has rows within rows, not a list of polygons")
    return start.astype(np.int32), _indices(np.concatenate(rows), name, count)


def _indices(array: np.ndarray, name: str, count: int) -> np.ndarray:
    if array.dtype.kind not in "iu" and array.size > 0:
        raise TypeError(f"{name} holds {array.dtype}, not whole numbers")
    if array.dtype != np.int32 and array.size > 0:
        if array.min() < -1 or array.max() > max(count, 0):  # out of range either way
            array = np.clip(array, -2, _INT_MAX)
    return np.ascontiguousarray(array, np.int32)


def _corners_filled_up(corners: np.ndarray) -> np.ndarray | None:
    """Which are corners, where rows are filled up with -1 behind three or more; None: all are."""
    if corners.shape[1] <= _FEWEST_CORNERS or not (corners[:, -1] == -1).any():
        return None
    is_corner = np.logical_or.accumulate(corners[:, ::-1] != -1, axis=1)[:, ::-1].copy()
    is_corner[is_corner.sum(axis=1) < _FEWEST_CORNERS] = True
    return is_corner


def _corners_of(corners: np.ndarray, sizes: np.ndarray) -> np.ndarray | None:
    """Which are corners, where faces have so many; None: all are, or these are no such faces."""
    if len(sizes) != len(corners):
        return None
    is_corner = np.arange(corners.shape[1]) < sizes[:, None]
    return is_corner if (corners[~is_corner] == -1).all() else None


def _check_count(corners: int, name: str) -> None:
    if corners > _INT_MAX:
        raise ValueError(f"{name} has {corners} corners, more than {_INT_MAX}")


def _two_sizes(objects: np.ndarray) -> str:
    """Where two polygons first differ."""
    sizes = [len(face) if hasattr(face, "__len__") else 1 for face in objects.ravel()]
    other = next((row for row, size in enumerate(sizes) if size != sizes[0]), None)
    if other is None:
        return ""
    return f" (row 0 has {sizes[0]} corners, row {other} has {sizes[other]})"


def _name(one: Any, name: str, face: int) -> bytes:
    if isinstance(one, bytes):
        return bytes(one)
    if isinstance(one, (list, tuple, np.ndarray)):
        raise ValueError(f"{name}[{face}] is {one!r:.60}, not one name")
    try:
        return str(one).encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        raise ValueError(f"{name}[{face}] holds half a character: {ascii(one):.60}") from None
