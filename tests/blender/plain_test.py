# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of the Blender add-on that need no Blender: TOILE_PROGRAM=build/toile plain_test.py."""

from __future__ import annotations

import math
import os
import pathlib
import sys
import tempfile
import unittest
import unittest.mock
import zipfile
from contextlib import closing

sys.dont_write_bytecode = True  # beside the sources
HERE = pathlib.Path(__file__).resolve().parent
BLENDER = HERE.parents[1] / "resources" / "blender"
sys.path[:0] = [str(HERE), str(BLENDER)]

import shapes  # noqa: E402
from make_zip import make_zip  # noqa: E402
from toile_blender import bl_info  # noqa: E402
from toile_blender.flattening import Flattening, Wishes  # noqa: E402
from toile_blender.garment_mesh import (  # noqa: E402
    SourceMesh,
    in_file,
    in_scene,
    left_out,
    metres_per_unit,
    parted,
    short_name,
    strain_colour,
    written,
)
from toile_blender.program import Requests, ToileError, program_path  # noqa: E402

PROGRAM = os.environ["TOILE_PROGRAM"]


def skirt(*columns: int, rows: int = shapes.ROWS) -> SourceMesh:
    places, faces = shapes.tube()
    seams = set().union(*(shapes.upright_edges(column, rows) for column in columns))
    return SourceMesh("skirt", [tuple(1000 * x for x in at) for at in places], faces, seams)


def run(mesh: SourceMesh, **wishes):
    with closing(Flattening([mesh], Wishes(PROGRAM, **wishes))) as work:
        work.requests.wait()
        return work.outcome()


class Parting(unittest.TestCase):
    def test_without_seams_the_mesh_stays_what_it_is(self):
        mesh = skirt()
        was, faces = parted(mesh)
        self.assertEqual(len(was), len(mesh.places))
        self.assertEqual([tuple(was[v] for v in face) for face in faces], mesh.faces)

    def test_a_seam_doubles_its_vertices_and_nothing_else(self):
        was, faces = parted(skirt(0))
        self.assertEqual(len(was), shapes.ROUND * (shapes.ROWS + 1) + shapes.ROWS + 1)
        self.assertEqual([tuple(was[v] for v in face) for face in faces], skirt().faces)

    def test_a_seam_that_ends_inside_is_a_slit(self):
        was, _ = parted(skirt(0, rows=4))
        self.assertEqual(len(was), shapes.ROUND * (shapes.ROWS + 1) + 4)

    def test_faces_that_meet_in_a_vertex_alone_are_parted(self):
        was, _ = parted(SourceMesh("bow", [(0, 0, 0)] * 5, [(0, 1, 2), (0, 3, 4)]))
        self.assertEqual(len(was), 6)

    def test_all_digits_are_written(self):
        text = written([SourceMesh("two  words", [(1 / 3, 0, 0)] * 3, [(0, 1, 2)])]).text
        self.assertIn("o two words\nv 0.3333333333333333 0", text)

    def test_seams_part_the_map_and_no_places(self):
        garment = written([skirt(0)])
        self.assertEqual(garment.faces, written([skirt()]).faces)
        self.assertEqual(garment.text.count("\nv "), len(skirt().places))
        self.assertEqual(garment.text.count("\nvt "), len(parted(skirt(0))[0]))


class Figures(unittest.TestCase):
    def test_colours_are_white_at_rest_and_full_from_the_limit_on(self):
        self.assertEqual(strain_colour(0, 0.05), (1, 1, 1, 1))
        self.assertEqual(strain_colour(0.5, 0.05), (1, 0, 0, 1))
        self.assertEqual(strain_colour(-0.05, 0.05), (0, 0, 1, 1))

    def test_parts_of_one_mesh_go_by_their_numbers(self):
        parts = ["Tee", "Tee 2", "Tee 10"]
        self.assertEqual(short_name("Tee / Tee 10, seam 1", parts), "1 / 10, seam 1")
        self.assertEqual(short_name("Tee 2 / itself", parts), "2 / itself")
        self.assertEqual(short_name("back / front", ["front", "back"]), "back / front")
        self.assertEqual(short_name("Tee / Teeth", ["Tee", "Teeth"]), "Tee / Teeth")
        self.assertEqual(short_name("Tee / itself", ["Tee"]), "Tee / itself")

    def test_a_unit_is_a_metre_or_the_whole_pattern(self):
        self.assertEqual(metres_per_unit([(3000, 20)], False), 1)
        self.assertEqual(metres_per_unit([(3000, 20)], True), 3)

    def test_places_in_sentences_are_those_of_the_scene(self):
        words = "1.0, 2.0, 3.0 mm"  # a piece may have such a name
        said = {
            "message": f"{words}: cut from {words} to ({words}), {words} long",
            "places": [
                {"words": words, "at": [0, -1, 0]},
                {"words": f"({words})", "at": [1e6, 2, 3]},
            ],
        }
        self.assertEqual(
            in_scene(said, 1000),
            f"{words}: cut from (0.0000, 0.0000, -0.0010) to (1000.0000, -0.0030, 0.0020), "
            f"{words} long",
        )
        self.assertEqual(in_scene({"message": said["message"]}, 1000), said["message"])
        said = {"message": "at X", "places": [{"words": "X", "at": [50.8, 0.0001, 0.0]}]}
        self.assertEqual(in_scene(said, 25.4), "at (2.000, 0.000, 0.000)")
        self.assertEqual(in_scene(said, 0.1), "at (508, 0, 0)")


class WithTheProgram(unittest.TestCase):
    def test_a_seam_opens_a_skirt_and_is_sewn_again(self):
        outcome = run(skirt(0))
        self.assertFalse(outcome.is_cut)
        self.assertTrue(all(outcome.pattern.places))
        self.assertEqual(len(outcome.arrays), 1)
        self.assertEqual(len(outcome.seams), 1)
        length = math.hypot(shapes.HEIGHT, 0.3 * shapes.RADIUS) * 1000
        self.assertAlmostEqual(outcome.seams[0]["length_2d_left"], length, delta=1e-6)
        self.assertLess(abs(outcome.seams[0]["error_mm"]), 1e-6)
        self.assertLess(max(map(abs, outcome.pattern.strains)), 0.02)  # it unrolls

    def test_two_seams_make_two_pieces(self):
        outcome = run(skirt(0, 12))
        self.assertEqual((len(outcome.arrays), len(outcome.seams)), (2, 2))

    def test_a_seam_that_ends_in_the_cloth_is_a_dart(self):
        mesh = skirt(0)
        mesh.seams |= shapes.upright_edges(12, rows=4)
        outcome = run(mesh)
        self.assertEqual(len(outcome.arrays), 1)
        self.assertEqual(sorted(seam["kind"] for seam in outcome.seams), ["dart", "seam"])

    def test_what_stays_closed_is_said_and_cut_where_that_is_asked_for(self):
        with self.assertRaises(ToileError) as refused:
            run(skirt())
        self.assertIn("--auto-cut", str(refused.exception))
        outcome = run(skirt(), auto_cut=True)
        piece = next(iter(outcome.arrays.values()))
        self.assertIsNotNone(piece["sheet"])
        x, y, z = zip(*(in_file(place) for place in piece["vertices"]))
        self.assertAlmostEqual(min(z), -1000 * shapes.HEIGHT, delta=1e-6)
        self.assertAlmostEqual(max(z), 0, delta=1e-6)

    def test_files_and_options_are_those_of_the_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = f"{folder}/skirt.svg"
            outcome = run(skirt(0), files=[path], options="--method lscm --allowance 10")
            self.assertEqual(outcome.files, [path])
            self.assertTrue(pathlib.Path(path).read_text().startswith("<?xml"))
        for options, words in (
            ("--method lcsm", "lcsm not in"),
            ("'", "cannot be read"),
            ("--split objects", "says --split itself"),
            ("--up=y", "says --up=y itself"),
        ):
            with self.assertRaises(ToileError) as refused:
                run(skirt(0), options=options)
            self.assertEqual(refused.exception.code, "wrong-usage")
            self.assertIn(words, str(refused.exception))

    def test_pieces_are_what_seams_part_where_every_edge_is_one(self):
        """A closed cube too, whose faces would be taken for loose ones and joined."""
        places = [(100 * (k & 1), 50 * (k & 2), 25 * (k & 4)) for k in range(8)]
        faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        seams = {tuple(sorted(e)) for f in faces for e in zip(f, f[1:] + f[:1])}
        outcome = run(SourceMesh("box", places, faces, seams))
        self.assertEqual((len(outcome.arrays), len(outcome.seams)), (6, 12))
        self.assertTrue(all(outcome.pattern.places))
        self.assertEqual(outcome.sentences, [])
        self.assertEqual(min(outcome.arrays), "box")
        # Faces that share nothing, as in a file of loose triangles, are not joined either.
        loose = SourceMesh("box", [places[v] for f in faces for v in f], [])
        loose.faces = [tuple(range(4 * k, 4 * k + 4)) for k in range(6)]
        outcome = run(loose)
        self.assertEqual((len(outcome.arrays), len(outcome.seams)), (6, 12))
        self.assertTrue(all(outcome.pattern.places))
        self.assertEqual(outcome.sentences, [])

    def test_a_face_that_repair_takes_out_leaves_the_rest_on_the_mesh(self):
        places = [(0, 0, 0), (100, 0, 0), (100, 100, 0), (0, 100, 0), (200, 0, 0)]
        for auto_cut in (False, True):
            faces = [(0, 1, 2, 3), (1, 4, 2), (1, 4, 2)]
            outcome = run(SourceMesh("twice", places, faces), auto_cut=auto_cut)
            self.assertFalse(outcome.is_cut)
            self.assertEqual([bool(at) for at in outcome.pattern.places], [True, True, False])
            self.assertEqual(outcome.pattern.lost, 1)
            self.assertIn("duplicate faces are removed", "".join(outcome.sentences))
            self.assertIn("(0.1000, 0.0000, 0.0000)", "".join(outcome.sentences))
        self.assertIn("1 face is left out", left_out(1))
        self.assertIn("2 faces are left out", left_out(2))

    def test_a_place_that_is_no_number_is_said_by_its_vertex(self):
        mesh = skirt(0)
        mesh.places[7] = (0, math.nan, 0)
        with self.assertRaises(ToileError) as refused:
            run(mesh)
        self.assertIn("Vertex 7 of skirt lies nowhere", str(refused.exception))

    def test_nobody_hears_of_the_file_in_between(self):
        mesh = SourceMesh("a pair", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2), (0, 1, 1)])
        self.assertIn("a pair: ", "".join(run(mesh).sentences))
        with self.assertRaises(ToileError) as refused:
            run(mesh, options="--strict")
        self.assertTrue(str(refused.exception).startswith("a pair: "), refused.exception)

    def test_a_program_may_be_named_from_the_home_folder(self):
        with tempfile.TemporaryDirectory() as home:
            program = pathlib.Path(home, "toile")
            program.symlink_to(PROGRAM)
            with unittest.mock.patch.dict(os.environ, HOME=home):
                self.assertEqual(program_path(" ~/toile "), str(program))

    def test_what_is_closed_runs_no_longer(self):
        with closing(Flattening([skirt(0)], Wishes(PROGRAM))) as work:
            self.assertFalse(work.requests.is_done)
        with self.assertRaises(ToileError) as refused:
            work.requests.wait()
        self.assertEqual(refused.exception.code, "cancelled")

    def test_a_cancel_ends_it(self):
        with closing(Flattening([skirt(0)], Wishes(PROGRAM))) as work:
            work.requests.cancel()
            with self.assertRaises(ToileError) as refused:
                work.requests.wait()
        self.assertEqual(refused.exception.code, "cancelled")

    def test_a_program_that_is_not_there_or_ends_is_said(self):
        for program, code in (("/nowhere/toile", "no-program"), ("true", "ended")):
            with self.assertRaises(ToileError) as refused:
                with closing(Flattening([skirt(0)], Wishes(program))) as work:
                    work.requests.wait()
            self.assertEqual(refused.exception.code, code)

    def test_progress_grows_to_one(self):
        requests = Requests(PROGRAM, [{"do": "quit"}])
        requests.wait()
        self.assertEqual(requests.progress, 1)


class Package(unittest.TestCase):
    def test_the_zip_is_the_package_and_always_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.zip", "b.zip"):
                make_zip(f"{folder}/{name}")
            first = pathlib.Path(folder, "a.zip").read_bytes()
            self.assertEqual(first, pathlib.Path(folder, "b.zip").read_bytes())
            names = zipfile.ZipFile(f"{folder}/a.zip").namelist()
        self.assertIn("toile_blender/__init__.py", names)

    def test_nothing_is_called_that_later_blenders_have_not(self):
        gone = ("vertex_colors", "calc_normals", "use_auto_smooth", "import bgl", "is_property_set(")
        for path in (BLENDER / "toile_blender").glob("*.py"):
            text = path.read_text(encoding="utf-8")
            self.assertEqual([word for word in gone if word in text], [], path.name)
        self.assertEqual(bl_info["blender"], (3, 4, 0))

    def test_its_version_is_that_of_the_program(self):
        text = (HERE.parents[1] / "CMakeLists.txt").read_text(encoding="utf-8")
        self.assertIn("VERSION " + ".".join(map(str, bl_info["version"])) + " ", text)


if __name__ == "__main__":
    unittest.main()
