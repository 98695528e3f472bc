# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on in a Blender with a window: it works in the background and can be stopped.

TOILE_PROGRAM=build/toile tests/app/own_display.sh blender --factory-startup \
    --python tests/blender/in_window.py
"""

from __future__ import annotations

import os
import pathlib
import sys
import tempfile
import time
import traceback

import addon_utils
import bpy

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "resources" / "blender")]

import shapes  # noqa: E402

MOST_SECONDS = 60


def steps():
    """Yields while Blender is to go on."""
    addon_utils.enable("toile_blender", default_set=True)
    preferences = bpy.context.preferences.addons["toile_blender"].preferences
    preferences.program = os.environ["TOILE_PROGRAM"]
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    places, faces = shapes.tube()
    mesh = bpy.data.meshes.new("skirt")
    mesh.from_pydata(places, [], faces)
    seams = shapes.upright_edges(0)
    for edge in mesh.edges:
        edge.use_seam = tuple(sorted(edge.vertices)) in seams
    obj = bpy.data.objects.new("skirt", mesh)
    bpy.context.scene.collection.objects.link(obj)
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    settings = bpy.context.scene.toile
    yield

    def invoke() -> set[str]:
        window = bpy.context.window_manager.windows[0]
        area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
        area.spaces.active.show_region_ui = True
        with bpy.context.temp_override(window=window, area=area):
            return bpy.ops.toile.flatten("INVOKE_DEFAULT")

    assert invoke() == {"RUNNING_MODAL"} and settings.runs
    bpy.ops.toile.cancel()
    while not settings.said:
        yield
    assert (settings.said, settings.failed) == ("Cancelled.", True), settings.said
    assert "Toile" not in mesh.uv_layers
    yield

    assert invoke() == {"RUNNING_MODAL"}
    while settings.runs:
        yield
    assert not settings.failed, settings.said
    assert "Toile" in mesh.uv_layers and len(settings.seams) == 1
    assert settings.progress == 1
    bpy.ops.ed.undo()
    yield
    bpy.ops.ed.redo()
    yield

    # What is changed while it runs is noticed: here no face, but where they lie.
    obj = bpy.data.objects["skirt"]
    assert invoke() == {"RUNNING_MODAL"}
    obj.scale.x = 2
    settings = bpy.context.scene.toile
    while settings.runs:
        yield
    assert settings.failed and "changed meanwhile" in settings.said, settings.said
    obj.scale.x = 1
    yield

    # A file saved while it runs does not say so, and opening one ends what runs.
    with tempfile.TemporaryDirectory() as folder:
        assert invoke() == {"RUNNING_MODAL"}
        bpy.ops.wm.save_as_mainfile(filepath=f"{folder}/runs.blend")
        bpy.ops.wm.open_mainfile(filepath=f"{folder}/runs.blend")
        yield
        settings = bpy.context.scene.toile
        assert not settings.runs
        assert invoke() == {"RUNNING_MODAL"}
        while settings.runs:
            yield
        assert not settings.failed, settings.said


def end(status: int) -> None:
    sys.stdout.flush()
    os._exit(status)


RUNNING, STARTED = steps(), time.monotonic()


def next_step() -> float:
    try:
        next(RUNNING)
        assert time.monotonic() < STARTED + MOST_SECONDS, "nothing came of it"
    except StopIteration:
        print("passed")
        end(0)
    except BaseException:
        traceback.print_exc()
        end(1)
    return 0.1


bpy.app.timers.register(next_step, first_interval=1.0, persistent=True)
