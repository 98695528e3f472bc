# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays in and out: shapes, units, who owns the memory."""

import gc
import unittest

import numpy as np
import toile
from support import grid, sample


class ArraysIn(unittest.TestCase):
    def test_any_numbers_give_the_same_garment(self) -> None:
        points, faces = grid(bump=8)
        expected = toile.garment(points, faces, unit="mm").flatten()[0].positions
        for vertices, corners in (
            (points.tolist(), faces.tolist()),
            (np.asfortranarray(points), faces.astype(np.int64)),
            (points[:, ::-1].copy()[:, ::-1], np.asfortranarray(faces)),
            (points, faces.astype(np.uint16)),
        ):
            flat = toile.garment(vertices, corners, unit="mm").flatten()
            np.testing.assert_array_equal(flat[0].positions, expected)

    def test_polygons_of_several_sizes(self) -> None:
        points = [[0, 0, 0], [10, 0, 0], [20, 0, 0], [0, 10, 0], [10, 10, 0]]
        made = toile.garment(points, [[0, 1, 4, 3], [1, 2, 4]], unit="mm")
        self.assertEqual(len(made[0].faces), 3)
        self.assertAlmostEqual(made[0].area, 150)
        np.testing.assert_array_equal(np.unique(made[0].source_faces), [0, 1])

    def test_a_polygon_without_corners_is_no_face(self) -> None:
        points, faces = grid(2)
        made = toile.garment(points, [*faces.tolist(), []], unit="mm")
        self.assertEqual(len(made[0].faces), len(faces))
        with self.assertRaises(toile.Error) as caught:
            toile.garment(points, [[], []], unit="mm")
        self.assertEqual(caught.exception.code, "no-geometry")

    def test_more_corners_than_can_be_counted_are_refused(self) -> None:
        many = np.broadcast_to(np.zeros((1, 3), np.int32), (1 << 30, 3))
        with self.assertRaises(ValueError) as caught:
            toile.garment(np.zeros((3, 3)), many)
        self.assertIn(str(3 << 30), str(caught.exception))

    def test_a_unit_scales(self) -> None:
        points, faces = grid()
        self.assertAlmostEqual(toile.garment(points, faces, unit="cm")[0].area, 160000)
        self.assertEqual(toile.garment(points, faces, unit="12.5mm").unit, 12.5)

    def test_names_divide(self) -> None:
        points, faces = grid()
        names = ["left" if points[f, 0].mean() < 20 else "right" for f in faces]
        made = toile.garment(points, faces, groups=names, split="groups", unit="mm")
        self.assertEqual([piece.name for piece in made.pieces], ["left", "right"])
        self.assertEqual(made["right"].name, "right")
        self.assertEqual(made[-1].name, "right")
        numbers = toile.garment(points, faces, groups=points[faces[:, 0], 1] // 20, split="groups")
        self.assertEqual([piece.name for piece in numbers.pieces], ["0.0", "1.0"])

    def test_a_uv_map_divides(self) -> None:
        points, faces = grid(2)
        vt = np.concatenate([points[:, :2], points[:, :2] + 100]) / 200
        right = points[faces].mean(axis=1)[:, :1] > 10
        made = toile.garment(points, faces, vt=vt, ft=faces + 9 * right, split="uv", unit="mm")
        self.assertEqual(len(made), 2)

    def test_names_are_text_however_they_come(self) -> None:
        points, faces = grid()
        names = ["é" if points[f, 0].mean() < 20 else "b" for f in faces]
        for given in (
            [name.encode() for name in names],
            np.char.encode(np.array(names)),
            np.array(names)[:, None],
            np.ma.array(names),
        ):
            made = toile.garment(points, faces, groups=given, split="groups", unit="mm")
            self.assertEqual([piece.name for piece in made.pieces], ["é", "b"])

    def test_rows_may_be_filled_up(self) -> None:
        points = [[0, 0, 0], [10, 0, 0], [20, 0, 0], [0, 10, 0], [10, 10, 0]]
        filled, polygons = [[0, 1, 4, 3], [1, 2, 4, -1]], [[0, 1, 4, 3], [1, 2, 4]]
        vt = np.array(points)[:, :2] / 20
        expected = toile.garment(points, polygons, vt=vt, ft=polygons, unit="mm", split="uv")
        for faces, ft in (
            (filled, None),
            (np.array(filled), np.array(filled)),
            (np.array(filled), polygons),
            (polygons, np.array(filled)),
        ):
            made = toile.garment(points, faces, vt=vt, ft=ft, unit="mm", split="uv")
            np.testing.assert_array_equal(made[0].faces, expected[0].faces)
            np.testing.assert_array_equal(made[0].reference, expected[0].reference)
            self.assertEqual([str(problem) for problem in made.problems], [])
        # Neither three corners behind which nothing is, nor a gap between corners.
        for wrong in ([0, 1, -1, -1], [0, -1, 4, 3], [-1, 0, 1, 4]):
            made = toile.garment(points, [filled[0], wrong], unit="mm")
            self.assertIn("index-out-of-range", [problem.code for problem in made.problems])
        # A corner without a place on the UV map is none that is filled up.
        made = toile.garment(points, [[0, 1, 4, 3]], vt=vt, ft=[[0, 1, 4, -1]], unit="mm")
        self.assertAlmostEqual(made[0].area, 100)

    def test_what_is_no_array_is_told_in_a_sentence(self) -> None:
        points, faces = grid(1)
        ragged = np.empty(2, object)
        ragged[:] = [[0, 1, 3, 2], [0, 1, 3]]
        for wrong, says, arguments in (
            (TypeError, "vertices is masked in places", (np.ma.masked_less(points, 5), faces)),
            (TypeError, "faces is masked in places", (points, np.ma.masked_equal(faces, 3))),
            (TypeError, "list(vertices)", (iter(points), faces)),
            (TypeError, "list(faces)", (points, (face for face in faces))),
            (TypeError, "row 1 has 3)", (points, ragged)),
            (TypeError, "faces[1] is 2.0", (points, [[0, 1, 2], 2.0])),
            (ValueError, "rows of several lengths", ([[0, 0, 0], [1, 1]], faces)),
            (ValueError, "rows within rows", (points, [[0, 1, 2], [[0], [1]]])),
            (ValueError, "shape ()", (4.0, faces)),
        ):
            with self.assertRaises(wrong) as caught:
                toile.garment(*arguments)
            self.assertIn(says, str(caught.exception))
        for wrong, says, names in (
            (TypeError, "list(groups)", (name for name in "ab")),
            (TypeError, "groups is masked", np.ma.masked_equal([1, 2], 2)),
            (ValueError, "groups[1] holds half a character", ["a", "\ud800"]),
            (ValueError, "groups[0] is ['a'], not one name", [["a"], ["b"]]),
            (ValueError, "groups has the shape (1, 2)", np.array([["a", "b"]])),
            (ValueError, "one name for each of 2", {"a", "b"}),
            (ValueError, "one name for each of 2", 7),
        ):
            with self.assertRaises(wrong) as caught:
                toile.garment(points, faces, groups=names)
            self.assertIn(says, str(caught.exception))
        for decimals in (99, -1, 6.5, "6"):
            with self.assertRaises(ValueError):
                toile.garment(points, faces, decimals=decimals)
        whole = toile.garment(np.ma.array(points), faces, unit="mm", decimals=np.int64(6))
        np.testing.assert_array_equal(whole[0].vertices, points)

    def test_a_unit_is_taken_again(self) -> None:
        points, faces = grid()
        made = toile.garment(points, faces, unit="in")
        for unit in (made.unit, np.float64(made.unit), "25.4mm"):
            self.assertEqual(toile.garment(points, faces, unit=unit).unit, 25.4)
        self.assertEqual(toile.garment(points, faces, unit=10).unit, 10)
        with self.assertRaises(toile.UsageError) as caught:
            toile.garment(points, faces, unit="25.4")
        self.assertIn("such as 25.4mm", str(caught.exception))

    def test_what_is_out_of_range_is_left_out_and_listed(self) -> None:
        points, faces = grid()
        for wrong in (-1, 25, 2**40):
            bad = np.vstack([faces.astype(np.int64), [0, 1, wrong]])
            made = toile.garment(points, bad, unit="mm")
            self.assertIn("index-out-of-range", [problem.code for problem in made.problems])
            self.assertEqual(len(made[0].faces), len(faces))

    def test_other_shapes_are_refused(self) -> None:
        points, faces = grid()
        for arguments, wrong in (
            ((points[:, :2], faces), ValueError),
            ((points, faces.astype(float)), TypeError),
            ((points.astype(str), faces), TypeError),
            ((points, faces[0]), ValueError),
        ):
            with self.assertRaises(wrong):
                toile.garment(*arguments)
        with self.assertRaises(ValueError):
            toile.garment(points, faces, vt=points[:, :2], ft=faces[:3])
        with self.assertRaises(ValueError):
            toile.garment(points, faces, groups=["one"])
        with self.assertRaises(ValueError):
            toile.garment(points, faces, decimals=99)

    def test_the_arrays_given_may_change_afterwards(self) -> None:
        points, faces = grid(bump=8)
        made = toile.garment(points, faces, unit="mm")
        before = made[0].vertices.copy()
        points[:] = 0
        np.testing.assert_array_equal(made[0].vertices, before)


class ArraysOut(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.garment = toile.load(sample("tshirt.obj"), unit="mm")
        cls.flat = cls.garment.flatten(pattern=True)

    def test_shapes_and_kinds(self) -> None:
        for piece, flat in zip(self.garment.pieces, self.flat.pieces):
            vertices, faces = len(piece.vertices), len(piece.faces)
            self.assertEqual(piece.vertices.shape, (vertices, 3))
            self.assertEqual(piece.vertices.dtype, np.float64)
            self.assertEqual(piece.faces.shape, (faces, 3))
            self.assertEqual(piece.faces.dtype, np.int32)
            self.assertEqual(piece.source_vertices.shape, (vertices,))
            self.assertEqual(piece.source_faces.shape, (faces,))
            self.assertEqual(flat.positions.shape, (vertices, 2))
            self.assertEqual(flat.strain.shape, (faces, 2))
            self.assertTrue((flat.strain[:, 0] >= flat.strain[:, 1]).all())
            self.assertIsNone(flat.error)
            self.assertEqual(flat.status, "flat")

    def test_nobody_writes_to_what_is_shared(self) -> None:
        for array in (
            self.garment[0].vertices,
            self.garment[0].faces,
            self.flat[0].positions,
            self.flat.pattern.pieces[0].outline,
        ):
            self.assertFalse(array.flags.owndata)
            with self.assertRaises(ValueError):
                array[0] = 0
            with self.assertRaises(ValueError):
                array.flags.writeable = True

    def test_a_view_keeps_what_it_shows(self) -> None:
        flat = toile.load(sample("cap.obj"), unit="mm").flatten(pattern=True)
        views = [flat[0].positions, flat[0].piece.vertices, flat.pattern.pieces[0].outline]
        views += [seam.left_line for seam in flat.seams] + [flat[0].strain]
        copies = [view.copy() for view in views]
        del flat
        gc.collect()
        for view, copy in zip(views, copies):
            np.testing.assert_array_equal(view, copy)

    def test_the_strain_is_that_of_the_triangles(self) -> None:
        flat = self.flat[0]
        worn = flat.piece.vertices[flat.piece.faces]
        drawn = flat.positions[flat.piece.faces]
        area3d = np.linalg.norm(np.cross(worn[:, 1] - worn[:, 0], worn[:, 2] - worn[:, 0]), axis=1)
        first, second = drawn[:, 1] - drawn[:, 0], drawn[:, 2] - drawn[:, 0]
        area2d = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
        np.testing.assert_allclose((1 + flat.strain).prod(axis=1), area3d / area2d, rtol=1e-9)

    def test_seams_sew(self) -> None:
        self.assertEqual(len(self.flat.seams), len(self.garment.seams))
        exact = self.garment.flatten()
        for seam in exact.seams:
            if seam.kind == "free":
                self.assertIsNone(seam.error)
                self.assertIsNone(seam.right_length)
            else:
                self.assertLess(abs(seam.error), 1e-6)
                self.assertEqual((seam.ease, seam.seam.ease), (0, 0))
            line = seam.left_line
            length = np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
            self.assertAlmostEqual(length, seam.left_length, places=6)
            self.assertAlmostEqual(seam.seam.left_length, seam.left_length, places=6)
            if seam.kind == "free":
                self.assertIsNone(seam.right_line)
            else:
                self.assertGreater(len(seam.seam.matches), 1)

    def test_the_pattern_is_round_its_pieces(self) -> None:
        pattern = self.flat.pattern
        width, height = pattern.size
        for piece in pattern.pieces:
            outline, cut = piece.outline, piece.cutting_line
            self.assertGreater(_area(cut), _area(outline))
            self.assertGreater(len(piece.notches), 0)
            for notch in piece.notches:
                away = np.linalg.norm(outline - notch["point"], axis=1).min()
                self.assertLess(away, 20)
                self.assertAlmostEqual(np.linalg.norm(notch["outward"]), 1)
            at = cut @ piece.place[:, :2].T + piece.place[:, 2]
            self.assertGreater(at.min(), -1e-6)
            self.assertLess((at - [width, height]).max(), 1e-6)
            self.assertIsNotNone(piece.grain)
            self.assertEqual({segment["kind"] for segment in piece.segments} - {"seam", "free",
                             "dart", "fold"}, set())


def _area(line: np.ndarray) -> float:
    x, y = line.T
    return 0.5 * float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


if __name__ == "__main__":
    unittest.main()
