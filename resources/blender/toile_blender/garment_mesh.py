# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes as Toile reads them, and what it found back on their corners. Knows no Blender."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from typing import Any, Iterable, Sequence

Point = Sequence[float]
MILLIMETRES = 1000.0
FINE = 0.1  # mm: to what places in sentences are told


@dataclass
class SourceMesh:
    """One mesh of a garment: places in millimetres, z up."""

    name: str
    places: list[tuple[float, float, float]]
    faces: list[tuple[int, ...]]  # vertices, anti-clockwise as seen from the cloth's right side
    seams: set[tuple[int, int]] = field(default_factory=set)  # edges, the lesser vertex first


def edge(a: int, b: int) -> tuple[int, int]:
    return (a, b) if a < b else (b, a)


def parted(mesh: SourceMesh) -> tuple[list[int], list[tuple[int, ...]]]:
    """The mesh opened along its seams: corners of a vertex stay one where faces around it hold
    together. Returns the vertex that each new one was, and the faces by the new ones. Linear."""
    first_corner = [0]
    for face in mesh.faces:
        first_corner.append(first_corner[-1] + len(face))
    parent = list(range(first_corner[-1]))

    def root(corner: int) -> int:
        while parent[corner] != corner:
            parent[corner] = parent[parent[corner]]
            corner = parent[corner]
        return corner

    seen: dict[tuple[int, int], tuple[int, int]] = {}  # edge: its corners in an earlier face
    for f, face in enumerate(mesh.faces):
        for i, a in enumerate(face):
            k = (i + 1) % len(face)
            b = face[k]
            key = edge(a, b)
            if key in mesh.seams:
                continue
            here = (first_corner[f] + i, first_corner[f] + k)
            here = here if a < b else here[::-1]
            for mine, other in zip(here, seen.setdefault(key, here)):
                parent[root(mine)] = root(other)
    number: dict[int, int] = {}
    was: list[int] = []
    faces = []
    for f, face in enumerate(mesh.faces):
        corners = []
        for i, vertex in enumerate(face):
            group = root(first_corner[f] + i)
            if group not in number:
                number[group] = len(was)
                was.append(vertex)
            corners.append(number[group])
        faces.append(tuple(corners))
    return was, faces


# How the file of `written` is read: the islands of its map are the pieces.
READING = ["--unit", "mm", "--up", "z", "--as", "sheet", "--split", "uv"]


@dataclass
class WrittenGarment:
    """What was written of several meshes: faces in their order, by vertices of the file from 0."""

    text: str
    faces: list[tuple[int, ...]]
    first_face: list[int]  # of each mesh, and one more
    same: list[int]  # of each vertex: the first at its place, which stands for it when welded


def written(meshes: Sequence[SourceMesh]) -> WrittenGarment:
    """The meshes as OBJ, each an object, with all digits; `READING` is how to read it.

    Parted along their seams they are a map: what a map parts stays apart, while meshes whose every
    face is on its own would be taken for a file of loose triangles and joined."""
    lines: list[str] = []
    if meshes:  # Islands of a lone object are called "panel", so it has a companion without faces.
        lines.append(f"o {one_line(meshes[0].name)} (none)")
    all_faces: list[tuple[int, ...]] = []
    first_face, same = [0], []
    first_at: dict[tuple[float, ...], int] = {}
    corners = 0  # of the map
    for mesh in meshes:
        was, faces = parted(mesh)
        lines.append("o " + one_line(mesh.name))
        number: dict[int, int] = {}
        for vertex in was:
            if vertex not in number:
                number[vertex] = len(same)
                same.append(first_at.setdefault(tuple(mesh.places[vertex]), len(same)))
                lines.append("v {!r} {!r} {!r}".format(*mesh.places[vertex]))
        lines += ["vt 0 0"] * len(was)
        for face in faces:
            all_faces.append(tuple(number[was[corner]] for corner in face))
            both = zip(all_faces[-1], face)
            lines.append("f " + " ".join(f"{v + 1}/{corners + corner + 1}" for v, corner in both))
        corners += len(was)
        first_face.append(len(all_faces))
    return WrittenGarment("\n".join(lines) + "\n", all_faces, first_face, same)


def one_line(text: str) -> str:
    return " ".join(text.split())


def nowhere(mesh: SourceMesh) -> int | None:
    """A vertex whose place is no number."""
    lost = (v for v, at in enumerate(mesh.places) if not all(map(math.isfinite, at)))
    return next(lost, None)


@dataclass
class FoundPattern:
    """What Toile found, by faces and corners of the file."""

    places: list[list[Point] | None]  # per face: its corners on the sheet, mm; None: not flat
    strains: list[float]  # per face: the principal strain of larger size; 0 where not flat
    is_split: bool  # a face lies in parts: its corners alone cannot tell where
    lost: int  # faces that are left out, though no piece has failed that they belong to


def found(garment: WrittenGarment, arrays: dict[str, dict]) -> FoundPattern:
    """@param arrays  of the pieces by name, as `query` gives them"""
    corners: list[dict[int, Point]] = [{} for _ in garment.faces]
    split: set[int] = set()
    failed: set[int] = set()
    strains = [0.0] * len(garment.faces)
    for piece in arrays.values():
        sheet = piece.get("sheet")
        if sheet is None:
            failed.update(piece["source_faces"])
            continue
        source = [garment.same[v] if v >= 0 else v for v in piece["source_vertices"]]
        for triangle, face, strain in zip(
            piece["triangles"], piece["source_faces"], piece["strain"]
        ):
            if face < 0:
                continue
            if strain is not None and abs(strain) > abs(strains[face]):
                strains[face] = strain
            for vertex in triangle:
                at = corners[face].setdefault(source[vertex], sheet[vertex])
                if source[vertex] < 0 or at != sheet[vertex]:
                    split.add(face)
    places: list[list[Point] | None] = []
    lost = 0
    for f, (face, known) in enumerate(zip(garment.faces, corners)):
        is_whole = f not in split and all(garment.same[corner] in known for corner in face)
        places.append([known[garment.same[corner]] for corner in face] if is_whole else None)
        lost += not is_whole and f not in failed
    return FoundPattern(places, strains, bool(split), lost)


def left_out(faces: int) -> str:
    what = "1 face is" if faces == 1 else f"{faces} faces are"
    return f"{what} left out of the pattern, grey, and at (0, 0) of the UV map."


def metres_per_unit(points: Iterable[Point], is_fitted: bool) -> float:
    """How many metres of cloth a unit of the UV map is: 1, or as many as fit the whole pattern,
    which lies from (0, 0) on, into the unit square."""
    largest = max((max(point) for point in points), default=0.0)
    return largest / MILLIMETRES if is_fitted and largest > 0 else 1.0


def strain_colour(strain: float, full: float) -> tuple[float, float, float, float]:
    """White where the cloth rests, red where it must stretch by `full` or more, blue where it is
    too long by as much."""
    share = max(-1.0, min(1.0, strain / full))
    if share >= 0:
        return (1.0, 1.0 - share, 1.0 - share, 1.0)
    return (1.0 + share, 1.0 + share, 1.0, 1.0)


def short_name(seam: str, pieces: Sequence[str]) -> str:
    """Pieces that are parts of one mesh by their numbers, "Tee / Tee 2, seam 1" as "1 / 2, seam 1";
    other names as they are."""
    mesh = min(pieces, key=len, default="")
    part = re.compile(re.escape(mesh) + r"(?: (\d+))?(?!\w)")
    if len(pieces) < 2 or not all(part.fullmatch(piece) for piece in pieces):
        return seam
    return part.sub(lambda found: found[1] or "1", seam)


def in_scene(said: dict[str, Any], unit: float) -> str:
    """A sentence of Toile's with the places that it tells as Blender shows them.
    @param unit  millimetres to a unit of the scene"""
    decimals = max(0, math.ceil(math.log10(unit / FINE)))
    before, told = said["message"], ""
    for place in reversed(said.get("places", [])):
        before, _, after = before.rpartition(place["words"])
        values = (round(value / unit, decimals) + 0.0 for value in in_file(place["at"]))  # no -0
        shown = ", ".join(f"{value:.{decimals}f}" for value in values)
        told = f"({shown}){after}{told}"
    return before + told


def in_file(place: Point) -> tuple[float, float, float]:
    """A place of Toile's, y up, in the file's axes, z up."""
    return (place[0], -place[2], place[1])
