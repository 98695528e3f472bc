# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of docs/blender.md, by Blender with a window (docs/make_pictures.sh blender):

blender --factory-startup --enable-event-simulate --window-geometry 0 0 1500 860 \
    --python docs/blender_picture.py -- TOILE PICTURE.png
"""

from __future__ import annotations

import pathlib
import sys
from collections import Counter

import bpy
from mathutils import Vector

sys.dont_write_bytecode = True
bpy.context.preferences.view.show_splash = False
SOURCES = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(SOURCES / "resources" / "blender"))

import addon_utils  # noqa: E402

PROGRAM, PICTURE = sys.argv[sys.argv.index("--") + 1 :]
FOURTH_TAB = 160  # pixels below the sidebar's top
CLOSER = 0.86
SHARED = 1e-6  # m: points of two panels that lie so near are one


def t_shirt() -> bpy.types.Object:
    """The sample as one skin, its seams marked where its panels meet."""
    places, faces = [], []
    sample = SOURCES / "resources" / "samples" / "tshirt.obj"
    for line in sample.read_text().splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            x, y, z = (float(value) / 1000 for value in rest)
            places.append((x, -z, y))
        elif word == "f":
            faces.append([int(corner.split("/")[0]) - 1 for corner in rest])
    number: dict[tuple[int, ...], int] = {}
    shared = [number.setdefault(tuple(round(x / SHARED) for x in at), len(number)) for at in places]
    skin = dict(zip(shared, places))
    edges = Counter(tuple(sorted(e)) for face in faces for e in zip(face, face[1:] + face[:1]))
    rims = Counter(
        tuple(sorted((shared[a], shared[b]))) for (a, b), count in edges.items() if count == 1
    )
    mesh = bpy.data.meshes.new("T-shirt")
    polygons = [[shared[v] for v in face] for face in faces]
    mesh.from_pydata([skin[v] for v in range(len(skin))], [], polygons)
    mesh.update()
    for edge in mesh.edges:
        edge.use_seam = rims[tuple(sorted(edge.vertices))] > 1
    obj = bpy.data.objects.new("T-shirt", mesh)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def the_window() -> bpy.types.Window:
    return bpy.context.window_manager.windows[0]


def area_of(kind: str) -> bpy.types.Area:
    return next(area for area in the_window().screen.areas if area.type == kind)


def region_of(area: bpy.types.Area, kind: str) -> bpy.types.Region:
    return next(region for region in area.regions if region.type == kind)


def close_areas() -> float:
    """But for the 3D view; one after the other, each joins its neighbour."""
    for kind in ("DOPESHEET_EDITOR", "OUTLINER", "PROPERTIES"):
        with bpy.context.temp_override(window=the_window(), area=area_of(kind)):
            bpy.ops.screen.area_close()
    return 0.5


def choose_colours() -> None:
    """Seams green on faint wires, for Blender's own are red, as strain is; UVs without dots."""
    theme = bpy.context.preferences.themes[0]
    theme.view_3d.wire_edit = (0.5, 0.5, 0.5)
    theme.view_3d.edge_seam = (0.0, 0.9, 0.1)
    theme.image_editor.vertex = theme.image_editor.face_dot = (0.8, 0.8, 0.8)
    theme.image_editor.vertex_size = theme.image_editor.facedot_size = 1


def prepare() -> float:
    choose_colours()
    window = the_window()
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    addon_utils.enable("toile_blender", default_set=True)
    bpy.context.preferences.addons["toile_blender"].preferences.program = PROGRAM
    obj = t_shirt()
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    view = area_of("VIEW_3D")
    with bpy.context.temp_override(window=window, area=view):
        bpy.ops.screen.area_split(direction="VERTICAL", factor=0.56)
    other = [a for a in window.screen.areas if a.type == "VIEW_3D" and a != view]
    left, right = sorted([view, *other], key=lambda area: area.x)
    right.ui_type = "UV"
    space = left.spaces.active
    space.show_region_ui = True
    space.show_region_toolbar = space.show_gizmo = False
    space.shading.type = "SOLID"
    space.shading.color_type = "VERTEX"
    space.overlay.show_floor = space.overlay.show_cursor = False
    space.overlay.show_axis_x = space.overlay.show_axis_y = False
    space.overlay.show_object_origins = False
    return 0.5


def flatten() -> float:
    left = area_of("VIEW_3D")
    window = the_window()
    with bpy.context.temp_override(window=window, area=left, region=region_of(left, "WINDOW")):
        result = bpy.ops.toile.flatten()
        print(result, bpy.context.scene.toile.said)
        bpy.ops.view3d.view_axis(type="FRONT")
        bpy.ops.view3d.view_orbit(angle=0.5, type="ORBITRIGHT")
        bpy.ops.view3d.view_orbit(angle=0.25, type="ORBITUP")
        bpy.ops.view3d.view_selected()
    camera = left.spaces.active.region_3d
    camera.view_distance *= CLOSER
    camera.view_location += camera.view_rotation @ Vector((0.2, 0, 0))  # from behind the sidebar
    return 1.0


def show_tab() -> float:
    """A click on the fourth tab of the sidebar: there is no other way to it in 3.4."""
    side = region_of(area_of("VIEW_3D"), "UI")
    at = {"x": side.x + side.width - 10, "y": side.y + side.height - FOURTH_TAB}
    window = the_window()
    window.event_simulate(type="MOUSEMOVE", value="NOTHING", **at)
    for value in ("PRESS", "RELEASE"):
        window.event_simulate(type="LEFTMOUSE", value=value, **at)
    return 1.0


def show_uvs() -> float:
    window = the_window()
    left, right = area_of("VIEW_3D"), area_of("IMAGE_EDITOR")
    with bpy.context.temp_override(window=window, area=left, region=region_of(left, "WINDOW")):
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_mode(type="FACE")
        bpy.ops.mesh.select_all(action="DESELECT")
        bpy.context.scene.tool_settings.use_uv_select_sync = True
    with bpy.context.temp_override(window=window, area=right, region=region_of(right, "WINDOW")):
        bpy.ops.uv.select_all(action="SELECT")
        bpy.ops.image.view_selected()
        bpy.ops.uv.select_all(action="DESELECT")
    right.spaces.active.uv_editor.edge_display_type = "WHITE"
    right.spaces.active.uv_editor.uv_opacity = 0.6
    return 1.5


def save() -> None:
    bpy.ops.screen.screenshot(filepath=PICTURE)
    bpy.ops.wm.quit_blender()


STEPS = [close_areas, prepare, flatten, show_tab, show_uvs, save]


def next_step() -> float | None:
    return STEPS.pop(0)() if STEPS else None


bpy.app.timers.register(next_step, first_interval=1.0)
