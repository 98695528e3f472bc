# SPDX-License-Identifier: GPL-3.0-or-later
"""Between Blender's meshes and what is flattened."""

from __future__ import annotations

from array import array
from contextlib import contextmanager
from typing import Iterator

import bpy

from .flattening import Outcome
from .program import ToileError
from .garment_mesh import (
    MILLIMETRES,
    FoundPattern,
    Point,
    SourceMesh,
    edge,
    in_file,
    metres_per_unit,
    strain_colour,
)

UV_MAP = "Toile"
STRAIN = "toile_strain"
STRAIN_COLOUR = "Toile strain"
UV_METRES = "toile_uv_metres"  # property of a mesh: metres of cloth to a unit of its UV map
FULL_STRAIN = 0.05  # of the colours
MOST_UV_MAPS = 8  # that Blender takes


@contextmanager
def object_mode(context: bpy.types.Context) -> Iterator[None]:
    """Meshes cannot be read or written in edit mode."""
    mode = context.object.mode if context.object else "OBJECT"
    if mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    try:
        yield
    finally:
        if mode != "OBJECT":
            bpy.ops.object.mode_set(mode=mode)


def selected_meshes(context: bpy.types.Context) -> list[bpy.types.Object]:
    """By name, so that the same selection is the same garment."""
    chosen = {obj.name: obj for obj in context.selected_objects if obj.type == "MESH"}
    return [chosen[name] for name in sorted(chosen)]


def millimetres(scene: bpy.types.Scene) -> float:
    """To a unit of Blender's."""
    return MILLIMETRES * scene.unit_settings.scale_length


def source_of(obj: bpy.types.Object, unit: float) -> SourceMesh:
    """The mesh where it stands in the world, without its modifiers."""
    mesh: bpy.types.Mesh = obj.data
    rows = [[float(value) for value in row] for row in obj.matrix_world]
    flat = array("f", [0.0]) * (3 * len(mesh.vertices))
    mesh.vertices.foreach_get("co", flat)
    places = []
    for i in range(0, len(flat), 3):
        x, y, z = flat[i], flat[i + 1], flat[i + 2]
        places.append(tuple(unit * (r[0] * x + r[1] * y + r[2] * z + r[3]) for r in rows[:3]))
    faces = [tuple(polygon.vertices) for polygon in mesh.polygons]
    if obj.matrix_world.is_negative:  # the right side of a mirrored mesh stays outside
        faces = [face[::-1] for face in faces]
    seams = {edge(*marked.vertices) for marked in mesh.edges if marked.use_seam}
    return SourceMesh(obj.name, places, faces, seams)


def check_writable(objects: list[bpy.types.Object]) -> None:
    """Raises ToileError where the pattern would find no place, or one taken by another's."""
    owners: dict[bpy.types.Mesh, str] = {}
    for obj in objects:
        mesh: bpy.types.Mesh = obj.data
        if mesh in owners:
            raise ToileError(
                f"{owners[mesh]} and {obj.name} share one mesh, which has room for the pattern of one; "
                "make them single user: Object > Relations > Make Single User > Object & Data."
            )
        owners[mesh] = obj.name
        if UV_MAP not in mesh.uv_layers and len(mesh.uv_layers) >= MOST_UV_MAPS:
            raise ToileError(
                f"{obj.name} has {len(mesh.uv_layers)} UV maps, and Blender takes no more; remove one."
            )


def fits(obj: bpy.types.Object, source: SourceMesh) -> bool:
    """Whether the mesh still has the faces that were read."""
    mesh = obj.data
    return len(mesh.polygons) == len(source.faces) and all(
        set(polygon.vertices) == set(face) for polygon, face in zip(mesh.polygons, source.faces)
    )


def _write(
    mesh: bpy.types.Mesh, corners: list[list[Point] | None], strains: list[float], metres: float
) -> None:
    """UV map, strain and its colours; by corners of the mesh's polygons."""
    # Each is filled before the next is made: making one may move the others.
    layer = mesh.uv_layers.get(UV_MAP) or mesh.uv_layers.new(name=UV_MAP, do_init=False)
    per_unit = MILLIMETRES * metres
    uv = array("f")
    for polygon, places in zip(mesh.polygons, corners):
        for i in range(polygon.loop_total):
            uv.extend(value / per_unit for value in (places[i] if places else (0.0, 0.0)))
    layer.data.foreach_set("uv", uv)
    mesh.uv_layers.active = layer
    old = mesh.attributes.get(STRAIN)
    if old:
        mesh.attributes.remove(old)
    mesh.attributes.new(STRAIN, "FLOAT", "FACE").data.foreach_set("value", array("f", strains))
    old = mesh.attributes.get(STRAIN_COLOUR)
    if old:
        mesh.attributes.remove(old)
    colours = array("f")
    for polygon, places, strain in zip(mesh.polygons, corners, strains):
        colour = strain_colour(strain, FULL_STRAIN) if places else (0.5, 0.5, 0.5, 1.0)
        for _ in range(polygon.loop_total):
            colours.extend(colour)
    attribute = mesh.color_attributes.new(STRAIN_COLOUR, "FLOAT_COLOR", "CORNER")
    attribute.data.foreach_set("color", colours)
    mesh.color_attributes.active_color = mesh.color_attributes[STRAIN_COLOUR]
    mesh[UV_METRES] = metres
    mesh.update()


def write_onto(
    objects: list[bpy.types.Object], outcome: Outcome, is_fitted: bool
) -> None:
    """The pattern as the UV map of the meshes that it was made of."""
    pattern: FoundPattern = outcome.pattern
    metres = metres_per_unit(
        (point for places in pattern.places if places for point in places), is_fitted
    )
    starts = outcome.garment.first_face
    for k, obj in enumerate(objects):
        corners = pattern.places[starts[k] : starts[k + 1]]
        if obj.matrix_world.is_negative:
            corners = [places[::-1] if places else None for places in corners]
        _write(obj.data, corners, pattern.strains[starts[k] : starts[k + 1]], metres)


def add_cut_garment(
    context: bpy.types.Context, name: str, outcome: Outcome, is_fitted: bool
) -> bpy.types.Object:
    """The garment as Toile has cut it, as a mesh of its own, where cuts run through faces."""
    unit = millimetres(context.scene)
    places: list[tuple[float, ...]] = []
    faces: list[tuple[int, ...]] = []
    corners: list[list[Point] | None] = []
    strains: list[float] = []
    for piece in outcome.arrays.values():
        first = len(places)
        places += [tuple(value / unit for value in in_file(at)) for at in piece["vertices"]]
        sheet = piece["sheet"]
        for i, triangle in enumerate(piece["triangles"]):
            faces.append(tuple(first + vertex for vertex in triangle))
            corners.append([sheet[vertex] for vertex in triangle] if sheet else None)
            strains.append((piece["strain"][i] or 0.0) if sheet else 0.0)
    mesh = bpy.data.meshes.new(f"{name} cut")
    mesh.from_pydata(places, [], faces)
    metres = metres_per_unit((at for three in corners if three for at in three), is_fitted)
    _write(mesh, corners, strains, metres)
    obj = bpy.data.objects.new(mesh.name, mesh)
    context.scene.collection.objects.link(obj)
    return obj
