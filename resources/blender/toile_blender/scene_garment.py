# SPDX-License-Identifier: GPL-3.0-or-later
"""Between Blender's meshes and what is flattened."""

from __future__ import annotations

import pathlib
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
CUT_OF = "toile_cut_of"  # property of an object: the one that it is the cut garment of
MOST_UV_MAPS = 8  # that Blender takes


@contextmanager
def object_mode(context: bpy.types.Context) -> Iterator[None]:
    """Meshes cannot be read or written in edit mode."""
    edited = context.object
    mode = edited.mode if edited else "OBJECT"
    if mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    try:
        yield
    finally:
        if mode != "OBJECT" and context.object == edited:
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
        override = mesh.override_library
        library = mesh.library or override and override.reference.library
        if library:
            raise ToileError(
                f"{obj.name} is linked from {pathlib.PurePath(library.filepath).name}, where "
                "nothing can be written; make it local: Object > Relations > Make Local > "
                "Selected Objects and Data."
            )
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


def fits(obj: bpy.types.Object, source: SourceMesh, unit: float) -> bool:
    """Whether the mesh is still what was read: places, faces and seams."""
    return source_of(obj, unit) == source


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


def show_cut_garment(
    context: bpy.types.Context, objects: list[bpy.types.Object], outcome: Outcome, is_fitted: bool
) -> bpy.types.Object:
    """The garment as Toile has cut it, as an object of its own beside the first, where cuts run
    through faces; in the place of what an earlier flattening has made there. Object mode only."""
    first = objects[0]
    mesh = _cut_mesh(f"{first.name} cut", objects, outcome, millimetres(context.scene), is_fitted)
    earlier = (each for each in context.view_layer.objects if each.get(CUT_OF) == first)
    made = next((each for each in earlier if each.type == "MESH" and each not in objects), None)
    if made:
        old = made.data
        name, made.data = old.name, mesh
        if not old.users:
            bpy.data.meshes.remove(old)
            mesh.name = name
        made.matrix_world.identity()  # places are the world's
    else:
        made = bpy.data.objects.new(mesh.name, mesh)
        made[CUT_OF] = first
        for collection in first.users_collection:
            collection.objects.link(made)
    for each in context.selected_objects:
        each.select_set(False)
    made.hide_set(False)
    made.select_set(True)
    context.view_layer.objects.active = made
    return made


def _cut_mesh(
    name: str,
    objects: list[bpy.types.Object],
    outcome: Outcome,
    unit: float,
    is_fitted: bool,
) -> bpy.types.Mesh:
    places: list[tuple[float, ...]] = []
    faces: list[tuple[int, ...]] = []
    corners: list[list[Point] | None] = []
    strains: list[float] = []
    sources: list[int] = []
    for piece in outcome.arrays.values():
        first = len(places)
        places += [tuple(value / unit for value in in_file(at)) for at in piece["vertices"]]
        sheet = piece["sheet"]
        sources += piece["source_faces"]
        for i, triangle in enumerate(piece["triangles"]):
            faces.append(tuple(first + vertex for vertex in triangle))
            corners.append([sheet[vertex] for vertex in triangle] if sheet else None)
            strains.append((piece["strain"][i] or 0.0) if sheet else 0.0)
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(places, [], faces)
    _take_materials(mesh, objects, sources)
    metres = metres_per_unit((at for three in corners if three for at in three), is_fitted)
    _write(mesh, corners, strains, metres)
    return mesh


def _take_materials(
    mesh: bpy.types.Mesh, objects: list[bpy.types.Object], sources: list[int]
) -> None:
    """Materials and shading of the faces that those of the mesh come from; all objects' in turn."""
    slots: list[bpy.types.Material | None] = []
    looks: list[tuple[int, bool]] = []  # of each face of the objects
    for obj in objects:
        first = len(slots)
        slots += [slot.material for slot in obj.material_slots] or [None]
        for polygon in obj.data.polygons:
            index = min(first + polygon.material_index, len(slots) - 1)
            looks.append((index, polygon.use_smooth))
    for material in slots if any(slots) else ():
        mesh.materials.append(material)
    for polygon, source in zip(mesh.polygons, sources):
        if source >= 0:
            polygon.material_index, polygon.use_smooth = looks[source]
