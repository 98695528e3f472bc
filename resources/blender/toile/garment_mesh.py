# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes as Toile reads them, and what it found back on their corners. Knows no Blender."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Iterable, Sequence

Point = Sequence[float]
MILLIMETRES = 1000.0


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


@dataclass
class WrittenGarment:
    """What was written of several meshes: faces in their order, by vertices of the file from 0."""

    text: str
    faces: list[tuple[int, ...]]
    first_face: list[int]  # of each mesh, and one more


def written(meshes: Iterable[SourceMesh]) -> WrittenGarment:
    """The meshes as OBJ, each an object, open along their seams, with all digits."""
    lines: list[str] = []
    all_faces: list[tuple[int, ...]] = []
    first_face = [0]
    vertices = 0
    for mesh in meshes:
        was, faces = parted(mesh)
        lines.append("o " + " ".join(mesh.name.split()))
        lines += ["v {!r} {!r} {!r}".format(*mesh.places[vertex]) for vertex in was]
        for face in faces:
            all_faces.append(tuple(vertices + corner for corner in face))
            lines.append("f " + " ".join(str(corner + 1) for corner in all_faces[-1]))
        vertices += len(was)
        first_face.append(len(all_faces))
    return WrittenGarment("\n".join(lines) + "\n", all_faces, first_face)


@dataclass
class FoundPattern:
    """What Toile found, by faces and corners of the file."""

    places: list[list[Point] | None]  # per face: its corners on the sheet, mm; None: not flat
    strains: list[float]  # per face: the principal strain of larger size; 0 where not flat
    is_cut: bool  # cuts run through faces: corners alone cannot tell where they lie


def found(garment: WrittenGarment, arrays: dict[str, dict]) -> FoundPattern:
    """@param arrays  of the pieces by name, as `query` gives them"""
    corners: list[dict[int, Point]] = [{} for _ in garment.faces]
    triangles = [0] * len(garment.faces)
    strains = [0.0] * len(garment.faces)
    for piece in arrays.values():
        if piece.get("sheet") is None:
            continue
        source_vertices, sheet = piece["source_vertices"], piece["sheet"]
        for triangle, face, strain in zip(
            piece["triangles"], piece["source_faces"], piece["strain"]
        ):
            triangles[face] += 1
            if strain is not None and abs(strain) > abs(strains[face]):
                strains[face] = strain
            for vertex in triangle:
                corners[face][source_vertices[vertex]] = sheet[vertex]
    is_cut = False
    places: list[list[Point] | None] = []
    for face, known, count in zip(garment.faces, corners, triangles):
        is_whole = count == len(face) - 2 and all(corner in known for corner in face)
        is_cut = is_cut or (count > 0 and not is_whole)
        places.append([known[corner] for corner in face] if is_whole else None)
    return FoundPattern(places, strains, is_cut)


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


def in_file(place: Point) -> tuple[float, float, float]:
    """A place of Toile's, y up, in the file's axes, z up."""
    return (place[0], -place[2], place[1])
