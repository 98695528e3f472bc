# SPDX-License-Identifier: GPL-3.0-or-later
"""A pattern is sewn back together, and what others wrote too."""

import tempfile
import unittest
from pathlib import Path

import numpy as np
import toile
from support import grid


class Proofs(unittest.TestCase):
    def setUp(self) -> None:
        self.flat = toile.garment(*grid(6, bump=3), unit="mm").flatten()

    def test_its_own_pattern_lies_on_the_design(self) -> None:
        said: list[float] = []
        proof = self.flat.prove(edge=10, threads=1, progress=said.append)
        self.assertEqual(proof.faults, [])
        self.assertTrue(proof.has_settled)
        self.assertLess(proof.gap["mean"], 2)
        self.assertLessEqual(proof.gap["mean"], proof.gap["max"])
        piece = proof.pieces[0]
        vertices = self.flat[0].piece.vertices
        self.assertEqual(piece.sewn.shape, vertices.shape)
        self.assertEqual(piece.gap.shape, (len(vertices),))
        self.assertEqual(piece.strain.shape, (len(vertices),))
        self.assertLess(np.linalg.norm(piece.sewn - vertices, axis=1).max(), 10)
        self.assertAlmostEqual(proof.report()["gap_mm"]["mean"], proof.gap["mean"], places=4)
        self.assertIn("mm", str(proof))

    def test_a_pattern_of_a_file(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "sheet.dxf"
            self.flat.write(path)
            proof = self.flat.prove(pattern=path, edge=10)
            self.assertEqual(proof.faults, [])
            self.assertEqual(proof.notes, [])
            dxf = path.read_text()
            at = dxf.rindex("0", 0, dxf.rindex("ENDSEC"))
            path.write_text(dxf[:at] + "0\nIMAGE\n340\n1A\n" + dxf[at:])
            notes = self.flat.prove(pattern=path, edge=10).notes
            self.assertEqual(len(notes), 1)
            self.assertIn("1 IMAGE", notes[0])
            with self.assertRaises(toile.FileError):
                self.flat.prove(pattern=Path(folder) / "none.dxf")

    def test_a_body_elsewhere_is_refused(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            body = Path(folder) / "far.obj"
            body.write_text("v 9e6 0 0\nv 9e6 9 0\nv 9e6 0 9\nf 1 2 3\n")
            with self.assertRaises(toile.UsageError) as caught:
                self.flat.prove(body=body, body_unit="mm")
            self.assertEqual(caught.exception.subject, str(body))
            self.assertEqual(caught.exception.code, "not-proved")
            with self.assertRaises(toile.FileError) as caught:
                self.flat.prove(body=Path(folder) / "none.obj")
            self.assertEqual(caught.exception.code, "file-unreadable")

    def test_a_smaller_one_is_smaller_when_sewn(self) -> None:
        widths = [
            np.ptp(self.flat.prove(edge=10, scale=scale).pieces[0].sewn[:, 0])
            for scale in (1, 0.9)
        ]
        self.assertLess(widths[1], 0.95 * widths[0])


if __name__ == "__main__":
    unittest.main()
