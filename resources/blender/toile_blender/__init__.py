# SPDX-License-Identifier: GPL-3.0-or-later
"""Toile in Blender: marked seams become cuts, the UV map becomes the sewing pattern.

The module is not called toile: that is Toile's Python module, which Blender may find first."""

bl_info = {
    "name": "Toile",
    "description": "Flattens garments into sewing patterns in true scale",
    "author": "The Toile contributors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D Viewport > Sidebar > Toile",
    "category": "UV",
}


def register() -> None:
    from . import operators, panel

    operators.register()
    panel.register()


def unregister() -> None:
    from . import operators, panel

    panel.unregister()
    operators.unregister()
