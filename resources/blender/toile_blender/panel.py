# SPDX-License-Identifier: GPL-3.0-or-later
"""The page in the sidebar of the 3D view."""

from __future__ import annotations

import textwrap

import bpy

MATCHES = 0.5  # mm, less than scissors can tell
SENTENCE_WIDTH = 30  # letters that a narrow sidebar has room for
WIDE = 340  # pixels


class TOILE_UL_seams(bpy.types.UIList):
    """Name and error of each seam, and both lengths where the sidebar is wide enough."""

    def draw_item(
        self, context, layout, data, item, icon, active_data, active_property, index=0, flag=0
    ) -> None:
        row = layout.split(factor=0.5 if is_wide(context) else 0.72)
        row.label(text=item.short)
        figures = row.row()
        figures.alert = abs(item.error) > MATCHES
        figures.alignment = "RIGHT"
        if is_wide(context):
            for length in (item.left, item.right):
                figures.label(text=f"{length:.1f}")
        figures.label(text=millimetres(item.error))


def is_wide(context: bpy.types.Context) -> bool:
    return context.region.width > WIDE * context.preferences.system.ui_scale


def millimetres(value: float) -> str:
    return f"{value + 0.0:.2f}".replace("-0.00", "0.00")


class TOILE_PT_pattern(bpy.types.Panel):
    bl_label = "Toile"
    bl_idname = "TOILE_PT_pattern"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Toile"

    def draw(self, context: bpy.types.Context) -> None:
        settings = context.scene.toile
        layout = self.layout
        column = layout.column()
        column.enabled = not settings.runs
        column.prop(settings, "auto_cut")
        column.prop(settings, "is_fitted")
        column.label(text="Pattern files beside the .blend:")
        column.row().prop(settings, "formats")
        column.label(text="Options, as of toile flatten:")
        column.prop(settings, "options", text="")
        if settings.runs:
            row = layout.row()
            row.prop(settings, "progress", slider=True, text="Flattening")
            row.operator("toile.cancel", text="", icon="X")
        else:
            row = layout.row()
            row.scale_y = 1.4
            row.operator("toile.flatten")
        if settings.said:
            self._draw_sentences(layout.box(), settings)
        if len(settings.seams):
            self._draw_ledger(layout, settings)

    def _draw_ledger(self, layout: bpy.types.UILayout, settings) -> None:
        layout.label(text="Seams and their errors, mm:")
        layout.template_list("TOILE_UL_seams", "", settings, "seams", settings, "seam", rows=6)
        if settings.seam < len(settings.seams):
            seam = settings.seams[settings.seam]
            box = layout.box().column(align=True)
            box.label(text=seam.name)
            box.label(text=f"Left {seam.left:.2f} mm")
            box.label(text=f"Right {seam.right:.2f} mm")

    def _draw_sentences(self, box: bpy.types.UILayout, settings) -> None:
        box.scale_y = 0.7
        for sentence in settings.said.split("\n"):
            for i, line in enumerate(textwrap.wrap(sentence, SENTENCE_WIDTH)):
                kind = "ERROR" if settings.failed else "INFO"
                box.label(text=line, icon=kind if i == 0 else "BLANK1")


CLASSES = (TOILE_UL_seams, TOILE_PT_pattern)


def register() -> None:
    for each in CLASSES:
        bpy.utils.register_class(each)


def unregister() -> None:
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
