# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings, and flattening them by."""

from __future__ import annotations

import pathlib
from collections.abc import Callable

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from .flattening import Flattening, Wishes
from .garment_mesh import left_out, short_name
from .program import ToileError
from .scene_garment import (
    check_writable,
    fits,
    millimetres,
    object_mode,
    selected_meshes,
    show_cut_garment,
    source_of,
    write_onto,
)

SECONDS_BETWEEN = 0.1


class ToilePreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: StringProperty(
        name="Program", description="Empty: the toile in PATH", subtype="FILE_PATH"
    )

    def draw(self, context: bpy.types.Context) -> None:
        self.layout.prop(self, "program")


class ToileSeam(bpy.types.PropertyGroup):
    """A row of the ledger; lengths in the pattern, mm. Its name is the seam's."""

    short: StringProperty()  # name without what all pieces are called
    left: FloatProperty()
    right: FloatProperty()
    error: FloatProperty()


class Running:
    """What works in the background: of this Blender, never of the file, so that it is neither
    saved nor undone."""

    work: Flattening | None = None


def is_running(settings: bpy.types.PropertyGroup) -> bool:
    return Running.work is not None


class ToileSettings(bpy.types.PropertyGroup):
    auto_cut: BoolProperty(
        name="Cut where needed",
        description="Toile cuts open what marked seams leave closed; where its cuts run through "
        "faces the result is a new mesh",
    )
    is_fitted: BoolProperty(
        name="Fit UV to 0..1",
        description="Else a unit of the UV map is 1 m of cloth; the mesh's property "
        "toile_uv_metres says how many metres a unit is",
    )
    formats: EnumProperty(
        name="Pattern files",
        description="Written beside the .blend",
        items=[
            ("svg", "SVG", "Drawing in true scale"),
            ("pdf", "PDF", "Tiled on A4 sheets"),
            ("dxf", "DXF", "Pattern for CAD, ASTM D6673"),
        ],
        options={"ENUM_FLAG"},
        default=set(),
    )
    options: StringProperty(
        name="Options", description="More words of toile flatten, such as --pattern --method lscm"
    )
    seams: CollectionProperty(type=ToileSeam)
    seam: IntProperty(name="Seam")
    said: StringProperty()  # sentences, a line each
    failed: BoolProperty()
    progress: FloatProperty(min=0, max=1)
    runs: BoolProperty(get=is_running)


class TOILE_OT_flatten(bpy.types.Operator):
    """Flatten the selected meshes into a sewing pattern, which becomes their UV map"""

    bl_idname = "toile.flatten"
    bl_label = "Flatten with Toile"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return bool(selected_meshes(context)) and not context.scene.toile.runs

    def execute(self, context: bpy.types.Context) -> set[str]:
        """To the end; for scripts."""
        return self._finish(context, self._begin, self._take)

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        if bpy.app.background:
            return self.execute(context)
        try:
            self._begin(context)
        except ToileError as error:
            return self._refuse(context, error)
        self._timer = context.window_manager.event_timer_add(SECONDS_BETWEEN, window=context.window)
        context.window_manager.modal_handler_add(self)
        Running.work = self._work
        return {"RUNNING_MODAL"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        settings = context.scene.toile
        if event.type == "ESC":
            self._work.requests.cancel()
        if event.type != "TIMER":
            return {"RUNNING_MODAL"} if event.type == "ESC" else {"PASS_THROUGH"}
        requests = self._work.requests
        is_done = requests.poll()
        if settings.progress != requests.progress:
            settings.progress = requests.progress
            for area in context.screen.areas:
                area.tag_redraw()
        return self._finish(context, self._take) if is_done else {"PASS_THROUGH"}

    def _begin(self, context: bpy.types.Context) -> None:
        settings = context.scene.toile
        self._timer = self._work = None
        settings.said, settings.failed, settings.progress = "", False, 0
        settings.seams.clear()
        settings.seam = 0
        blend = bpy.data.filepath
        if settings.formats and not blend:
            raise ToileError("Save the .blend first: pattern files are written beside it.")
        ends = sorted(settings.formats)
        files = [str(pathlib.Path(blend).with_suffix(f".{end}")) for end in ends]
        preferences = context.preferences.addons[__package__].preferences
        objects = selected_meshes(context)
        check_writable(objects)
        self._notes = [
            f"{obj.name}: its modifiers are not applied; the mesh without them is flattened."
            for obj in objects
            if obj.modifiers
        ]
        unit = millimetres(context.scene)
        with object_mode(context):
            self._sources = [source_of(obj, unit) for obj in objects]
        program = bpy.path.abspath(preferences.program.strip())
        wishes = Wishes(program, settings.auto_cut, settings.options, files, unit)
        self._work = Flattening(self._sources, wishes)

    def _finish(self, context: bpy.types.Context, *steps: Callable[..., None]) -> set[str]:
        """Does what is left to do; whatever comes of it, nothing runs afterwards."""
        try:
            for step in steps:
                step(context)
        except ToileError as error:
            return self._refuse(context, error)
        finally:
            self.cancel(context)
        return {"FINISHED"}

    def cancel(self, context: bpy.types.Context) -> None:
        """Ends what runs; Blender calls it too, where another file is opened meanwhile."""
        if self._timer:
            context.window_manager.event_timer_remove(self._timer)
        if self._work:
            self._work.close()
        self._timer = self._work = Running.work = None

    def _take(self, context: bpy.types.Context) -> None:
        outcome = self._work.outcome()
        settings = context.scene.toile
        objects = [context.scene.objects.get(was.name) for was in self._sources]
        unit = millimetres(context.scene)
        with object_mode(context):
            if not all(obj and fits(obj, was, unit) for obj, was in zip(objects, self._sources)):
                raise ToileError("The meshes were changed meanwhile; flatten them again.")
            if outcome.is_cut:
                cut = show_cut_garment(context, objects, outcome, settings.is_fitted)
                self._notes.append(f"Cuts run through faces: the pattern is on {cut.name}.")
            else:
                write_onto(objects, outcome, settings.is_fitted)
                if outcome.pattern.lost:
                    self._notes.append(left_out(outcome.pattern.lost))
        for seam in outcome.seams:
            row = settings.seams.add()
            row.name = seam["name"]
            row.short = short_name(seam["name"], list(outcome.arrays))
            row.left, row.right = seam["length_2d_left"], seam["length_2d_right"]
            row.error = seam["error_mm"]
        wrote = [f"Wrote {pathlib.Path(file).name}." for file in outcome.files]
        settings.said = "\n".join([*self._notes, *outcome.sentences, *wrote])

    def _refuse(self, context: bpy.types.Context, error: ToileError) -> set[str]:
        context.scene.toile.said = str(error)
        context.scene.toile.failed = True
        self.report({"WARNING"}, str(error))
        return {"CANCELLED"}


class TOILE_OT_cancel(bpy.types.Operator):
    """Stop flattening"""

    bl_idname = "toile.cancel"
    bl_label = "Cancel"

    def execute(self, context: bpy.types.Context) -> set[str]:
        if Running.work:
            Running.work.requests.cancel()
        return {"FINISHED"}


CLASSES = (ToilePreferences, ToileSeam, ToileSettings, TOILE_OT_flatten, TOILE_OT_cancel)


def register() -> None:
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.types.Scene.toile = PointerProperty(type=ToileSettings)


def unregister() -> None:
    del bpy.types.Scene.toile
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
