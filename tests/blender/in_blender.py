# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on in the real Blender, in background mode:

TOILE_PROGRAM=... blender --background --factory-startup --python tests/blender/in_blender.py

The UV map is compared with positions that the command line writes, by another way: as the UV map of
an OBJ file. UV maps are of single precision: 24 bits of metres.
"""

from __future__ import annotations

import os
import pathlib
import subprocess
import sys
import tempfile
import traceback
import types
import unittest

import addon_utils
import bpy

sys.dont_write_bytecode = True  # beside the sources
HERE = pathlib.Path(__file__).resolve().parent
SOURCES = HERE.parents[1]
sys.path[:0] = [str(HERE), str(SOURCES / "resources" / "blender")]

import shapes  # noqa: E402
from make_zip import make_zip  # noqa: E402
from toile_blender.garment_mesh import READING, written  # noqa: E402
from toile_blender.scene_garment import fits, source_of  # noqa: E402

PROGRAM = os.environ["TOILE_PROGRAM"]
sys.modules["toile"] = types.ModuleType("toile")  # as where Toile's Python module is installed
SINGLE = 2.0**-24  # relative rounding of single precision


def emptied() -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon_utils.enable("toile_blender", default_set=True)
    bpy.context.preferences.addons["toile_blender"].preferences.program = PROGRAM


def add(name: str, places, faces, seams=()) -> bpy.types.Object:
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(places, [], faces)
    mesh.update()
    for each in mesh.edges:
        a, b = each.vertices
        each.use_seam = (min(a, b), max(a, b)) in seams
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    return obj


def skirt(*columns: int) -> bpy.types.Object:
    places, faces = shapes.tube()
    return add("skirt", places, faces, set().union(*map(shapes.upright_edges, columns)))


def read_obj(path: pathlib.Path):
    """Places, UVs and faces as (vertex, UV) by corner."""
    places, uvs, faces, names = [], [], [], []
    for line in path.read_text().splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            places.append(tuple(map(float, rest)))
        elif word == "vt":
            uvs.append(tuple(map(float, rest)))
        elif word == "f":
            corners = [[int(k) - 1 for k in corner.split("/")[:2]] for corner in rest]
            faces.append(corners)
    return places, uvs, faces


def flatten() -> None:
    result = bpy.ops.toile.flatten()
    said = bpy.context.scene.toile.said
    assert result == {"FINISHED"}, said


def uv_of(mesh: bpy.types.Mesh, name: str = "Toile") -> list[tuple[float, float]]:
    return [tuple(each.uv) for each in mesh.uv_layers[name].data]


class AddOn(unittest.TestCase):
    def setUp(self):
        emptied()

    def near(self, uv, metres):
        for a, b in zip(uv, metres):
            self.assertLessEqual(abs(a - b), SINGLE * max(1.0, abs(b)))

    def test_the_uv_map_of_the_t_shirt_is_our_pattern(self):
        """Its panels as one mesh, in metres; no seam is marked: they lie apart as they are."""
        sample = SOURCES / "resources" / "samples" / "tshirt.obj"
        places, _, faces = read_obj(sample)
        metres = [(x / 1000, -z / 1000, y / 1000) for x, y, z in places]
        obj = add("tshirt", metres, [[corner[0] for corner in face] for face in faces])
        flatten()
        with tempfile.TemporaryDirectory() as folder:
            source, target = pathlib.Path(folder, "a.obj"), pathlib.Path(folder, "b.obj")
            garment = written([source_of(obj, 1000)])  # vertices in this order: the same bytes
            source.write_text(garment.text)
            typed = [PROGRAM, "flatten", source, *READING, "-o", target]
            subprocess.run(typed, check=True, capture_output=True)
            _, uvs, found = read_obj(target)
        by_face = {frozenset(c[0] for c in face): dict(face) for face in found}
        uv = uv_of(obj.data)
        for polygon in obj.data.polygons:
            corners = garment.faces[polygon.index]
            ours = by_face[frozenset(corners)]
            for corner, vertex in zip(polygon.loop_indices, corners):
                self.near(uv[corner], [value / 1000 for value in uvs[ours[vertex]]])
        rows = bpy.context.scene.toile.seams
        self.assertGreaterEqual(len(rows), 7)
        self.assertTrue(all(abs(row.error) < 0.01 and row.left > 1 for row in rows))

    def test_marked_seams_open_a_mesh_and_its_lengths_are_kept(self):
        obj = skirt(0)
        flatten()
        mesh, uv = obj.data, uv_of(obj.data)
        rims = ({0}, {shapes.ROWS})
        outline = [
            each
            for each in mesh.edges
            if each.use_seam or {k // shapes.ROUND for k in each.vertices} in rims
        ]
        of_edge = {}
        for polygon in mesh.polygons:
            loops = list(polygon.loop_indices)
            for a, b in zip(loops, loops[1:] + loops[:1]):
                key = frozenset((mesh.loops[a].vertex_index, mesh.loops[b].vertex_index))
                of_edge.setdefault(key, []).append((uv[a], uv[b]))
        for each in outline:
            a, b = (mesh.vertices[k].co for k in each.vertices)
            sides = of_edge[frozenset(each.vertices)]
            self.assertEqual(len(sides), 2 if each.use_seam else 1)
            for p, q in sides:
                flat = ((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2) ** 0.5
                self.assertAlmostEqual(flat, (a - b).length, delta=4 * SINGLE)
        self.assertEqual(len(bpy.context.scene.toile.seams), 1)

    def test_strain_is_there_as_numbers_and_colours(self):
        obj = skirt(0, 12)
        flatten()
        strain, colour = obj.data.attributes["toile_strain"], obj.data.attributes["Toile strain"]
        self.assertEqual((strain.domain, strain.data_type), ("FACE", "FLOAT"))
        self.assertEqual((colour.domain, colour.data_type), ("CORNER", "FLOAT_COLOR"))
        self.assertTrue(all(abs(each.value) < 0.02 for each in strain.data))
        self.assertTrue(all(max(each.color) == 1 for each in colour.data))
        self.assertEqual(obj.data.color_attributes.active_color.name, "Toile strain")
        flatten()  # a second time writes over the first
        self.assertEqual(len(obj.data.uv_layers), 1)
        self.assertEqual(len(obj.data.color_attributes), 1)

    def test_scale_of_object_and_scene_count_and_a_mirrored_object_is_not_turned_over(self):
        skirt(0)
        flatten()
        plain = sorted(row.left for row in bpy.context.scene.toile.seams)
        emptied()
        obj = skirt(0)
        obj.scale = (-2, 2, 2)
        bpy.context.view_layer.update()
        bpy.context.scene.unit_settings.scale_length = 0.5
        flatten()
        self.assertAlmostEqual(bpy.context.scene.toile.seams[0].left, plain[0], delta=1e-3)
        uv = uv_of(obj.data)
        areas = []
        for polygon in obj.data.polygons:
            at = [uv[k] for k in polygon.loop_indices]
            areas.append(sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(at, at[1:] + at[:1])) / 2)
        # The mesh's own corners run clockwise as it stands.
        self.assertTrue(all(area < 0 for area in areas))

    def test_fitted_uvs_fill_the_unit_square_and_say_their_scale(self):
        obj = skirt(0)
        bpy.context.scene.toile.is_fitted = True
        flatten()
        values = [value for each in uv_of(obj.data) for value in each]
        self.assertAlmostEqual(max(values), 1, delta=1e-6)
        self.assertGreaterEqual(min(values), -1e-6)
        self.assertGreater(obj.data["toile_uv_metres"], 1)

    def test_a_skirt_of_two_objects_is_one_garment(self):
        places, faces = shapes.tube()
        half = shapes.ROUND // 2
        for name, k in (("front", 0), ("back", 1)):
            add(name, places, [f for i, f in enumerate(faces) if (i % shapes.ROUND) // half == k])
        flatten()
        self.assertEqual(len(bpy.context.scene.toile.seams), 2)
        names = {row.name.split(",")[0] for row in bpy.context.scene.toile.seams}
        self.assertEqual(names, {"back / front"})

    def test_what_stays_closed_is_said_and_cut_on_request_as_a_new_mesh(self):
        skirt()
        self.assertEqual(bpy.ops.toile.flatten(), {"CANCELLED"})
        settings = bpy.context.scene.toile
        self.assertTrue(settings.failed)
        self.assertIn("--auto-cut", settings.said)
        settings.auto_cut = True
        flatten()
        self.assertFalse(settings.failed)
        self.assert_is_the_pattern_of(bpy.data.objects["skirt"].data)
        # Lines on a sphere run through faces: the result is a mesh of its own, in the same place.
        emptied()
        bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=3, radius=0.1, location=(1, 2, 3))
        bpy.context.scene.toile.auto_cut = True
        bpy.context.scene.toile.options = "--cut-style tailor"  # gores
        flatten()
        self.assertIn("Cuts run through faces", bpy.context.scene.toile.said)
        self.assertNotIn("Toile", bpy.data.objects["Icosphere"].data.uv_layers)
        self.assert_is_the_pattern_of(bpy.data.objects["Icosphere cut"].data)

    def assert_is_the_pattern_of(self, cut: bpy.types.Mesh):
        """Area there, and the same in the plane; as large as the sphere or skirt it was."""
        uv = uv_of(cut)
        flat = 0.0
        for polygon in cut.polygons:
            at = [uv[k] for k in polygon.loop_indices]
            flat += sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(at, at[1:] + at[:1])) / 2
        worn = sum(polygon.area for polygon in cut.polygons)
        whole = sum(polygon.area for polygon in bpy.context.view_layer.objects.active.data.polygons)
        self.assertAlmostEqual(worn / whole, 1, delta=1e-4)
        self.assertAlmostEqual(flat / worn, 1, delta=0.05)
        self.assertTrue(all(abs(value) < 4 for vertex in cut.vertices for value in vertex.co))

    def test_a_cut_garment_takes_the_place_of_the_one_before_and_the_looks_of_its_mesh(self):
        bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=3, radius=0.1, location=(1, 2, 3))
        sphere = bpy.context.object
        for name in ("red", "blue"):
            sphere.data.materials.append(bpy.data.materials.new(name))
        for polygon in sphere.data.polygons:
            polygon.material_index = int(polygon.center.z > 0)
            polygon.use_smooth = True
        folder = bpy.data.collections.new("wardrobe")
        bpy.context.scene.collection.children.link(folder)
        bpy.context.scene.collection.objects.unlink(sphere)
        folder.objects.link(sphere)
        settings = bpy.context.scene.toile
        settings.auto_cut, settings.options = True, "--cut-style tailor"
        bpy.ops.object.mode_set(mode="EDIT")
        flatten()
        cut = bpy.context.object
        self.assertEqual((cut.name, cut.mode), ("Icosphere cut", "OBJECT"))
        self.assertEqual(bpy.context.selected_objects, [cut])
        self.assertEqual([each.name for each in cut.users_collection], ["wardrobe"])
        self.assertEqual([each.name for each in cut.data.materials], ["red", "blue"])
        self.assertTrue(all(polygon.use_smooth for polygon in cut.data.polygons))
        for polygon in cut.data.polygons:
            if abs(polygon.center.z - 3) > 0.02:
                self.assertEqual(polygon.material_index, int(polygon.center.z > 3))
        cut.location.x = 7
        cut.select_set(False)
        sphere.select_set(True)
        bpy.context.view_layer.objects.active = sphere
        flatten()
        self.assertEqual(sorted(each.name for each in bpy.data.objects), ["Icosphere", cut.name])
        self.assertEqual(sorted(each.name for each in bpy.data.meshes), ["Icosphere", cut.name])
        self.assertEqual((bpy.context.object, cut.location.x), (cut, 0))
        self.assert_is_the_pattern_of(cut.data)

    def test_a_linked_mesh_is_refused(self):
        skirt(0)
        with tempfile.TemporaryDirectory() as folder:
            bpy.ops.wm.save_as_mainfile(filepath=f"{folder}/lib.blend")
            emptied()
            with bpy.data.libraries.load(f"{folder}/lib.blend", link=True) as (_, wanted):
                wanted.objects = ["skirt"]
            linked = bpy.data.objects["skirt"]
            bpy.context.scene.collection.objects.link(linked)
            linked.select_set(True)
            bpy.context.view_layer.objects.active = linked
            self.assertEqual(bpy.ops.toile.flatten(), {"CANCELLED"})
            self.assertIn("skirt is linked from lib.blend", bpy.context.scene.toile.said)
            bpy.ops.object.make_local(type="SELECT_OBDATA")
            flatten()

    def test_whatever_is_changed_meanwhile_is_noticed(self):
        obj = skirt(0)
        was = source_of(obj, 1000)
        self.assertTrue(fits(obj, was, 1000))
        self.assertFalse(fits(obj, was, 500))
        for change in (
            lambda: setattr(obj.data.vertices[5].co, "x", 1),
            lambda: setattr(obj.data.edges[5], "use_seam", not obj.data.edges[5].use_seam),
            lambda: setattr(obj.scale, "x", 2),
            obj.data.flip_normals,
        ):
            before = source_of(obj, 1000)
            change()
            bpy.context.view_layer.update()
            self.assertFalse(fits(obj, before, 1000))

    def test_a_failure_leaves_no_ledger_of_what_was_before(self):
        skirt(0)
        flatten()
        settings = bpy.context.scene.toile
        self.assertEqual(len(settings.seams), 1)
        settings.options = "--method lcsm"
        self.assertEqual(bpy.ops.toile.flatten(), {"CANCELLED"})
        self.assertEqual(len(settings.seams), 0)

    def test_the_program_may_be_named_from_the_file(self):
        skirt(0)
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "toile").symlink_to(PROGRAM)
            bpy.ops.wm.save_as_mainfile(filepath=f"{folder}/a.blend")
            bpy.context.preferences.addons["toile_blender"].preferences.program = " //toile "
            flatten()

    def test_files_lie_beside_the_blend_and_modifiers_are_told_of(self):
        obj = skirt(0)
        obj.modifiers.new("thick", "SOLIDIFY")
        settings = bpy.context.scene.toile
        settings.formats = {"svg", "dxf"}
        self.assertEqual(bpy.ops.toile.flatten(), {"CANCELLED"})
        self.assertIn("Save the .blend", settings.said)
        with tempfile.TemporaryDirectory() as folder:
            bpy.ops.wm.save_as_mainfile(filepath=f"{folder}/my skirt.blend")
            flatten()
            for end in ("svg", "dxf"):
                self.assertTrue(pathlib.Path(folder, f"my skirt.{end}").is_file())
        self.assertIn("modifiers are not applied", settings.said)

    def test_errors_of_the_program_are_sentences(self):
        skirt(0)
        bpy.context.scene.toile.options = "--method lcsm"
        self.assertEqual(bpy.ops.toile.flatten(), {"CANCELLED"})
        self.assertIn("lcsm not in", bpy.context.scene.toile.said)
        bpy.context.preferences.addons["toile_blender"].preferences.program = "/nowhere/toile"
        self.assertEqual(bpy.ops.toile.flatten(), {"CANCELLED"})
        self.assertIn("/nowhere/toile", bpy.context.scene.toile.said)

    def test_a_mesh_without_room_for_the_pattern_is_refused(self):
        obj = skirt(0)
        for number in range(8):
            obj.data.uv_layers.new(name=f"map {number}")
        settings = bpy.context.scene.toile
        self.assertEqual(bpy.ops.toile.flatten(), {"CANCELLED"})
        self.assertIn("skirt has 8 UV maps", settings.said)
        obj.data.uv_layers.remove(obj.data.uv_layers["map 3"])
        flatten()
        flatten()  # its own map is one of the eight now
        other = bpy.data.objects.new("twin", obj.data)
        bpy.context.scene.collection.objects.link(other)
        other.select_set(True)
        self.assertEqual(bpy.ops.toile.flatten(), {"CANCELLED"})
        self.assertIn("skirt and twin share one mesh", settings.said)
        bpy.ops.object.make_single_user(object=True, obdata=True)
        self.assertIsNot(obj.data, other.data)
        other.location.x = 2
        bpy.context.view_layer.update()
        flatten()
        self.assertIn("Toile", other.data.uv_layers)

    def test_edit_mode_is_left_and_entered_again(self):
        obj = skirt(0)
        bpy.ops.object.mode_set(mode="EDIT")
        flatten()
        self.assertEqual(obj.mode, "EDIT")
        bpy.ops.object.mode_set(mode="OBJECT")
        self.assertIn("Toile", obj.data.uv_layers)


class Installing(unittest.TestCase):
    def test_the_zip_installs(self):
        with tempfile.TemporaryDirectory() as folder:
            os.environ["BLENDER_USER_SCRIPTS"] = folder  # not into a person's own
            make_zip(f"{folder}/toile.zip")
            pathlib.Path(folder, "addons").mkdir()
            bpy.ops.preferences.addon_install(filepath=f"{folder}/toile.zip", overwrite=True)
            installed = pathlib.Path(folder, "addons", "toile_blender")
            self.assertTrue((installed / "__init__.py").is_file())


if __name__ == "__main__":
    try:
        program = unittest.main(argv=["in_blender"], exit=False, verbosity=1)
        status = 0 if program.result.wasSuccessful() else 1
    except BaseException:
        traceback.print_exc()
        status = 1
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)  # Blender's own end would say 0
