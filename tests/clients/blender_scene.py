# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender: opens files and writes what it sees of each as JSON beside it.

    blender --background --factory-startup --python blender_scene.py -- FILE...
"""
import json
import sys

import bpy
import numpy

numpy.bool = bool  # Debian's reader of glTF still asks for it


def corners(mesh):
    """Of each triangle in turn, and each of its corners: place and texture coordinates."""
    layer = mesh.uv_layers.active
    if not layer:
        return []
    return [[[*mesh.vertices[mesh.loops[k].vertex_index].co, *layer.data[k].uv]
             for k in polygon.loop_indices] for polygon in mesh.polygons]


def open_file(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if path.endswith(".glb"):
        bpy.ops.import_scene.gltf(filepath=path)
    else:
        bpy.ops.wm.obj_import(filepath=path, forward_axis="Y", up_axis="Z")
    return {item.name: {"corners": corners(item.data), "edges": len(item.data.edges)}
            for item in bpy.data.objects if item.type == "MESH"}


for name in sys.argv[sys.argv.index("--") + 1:]:
    with open(name + ".scene.json", "w", encoding="utf-8") as out:
        json.dump(open_file(name), out)
