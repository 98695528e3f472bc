# SPDX-License-Identifier: GPL-3.0-or-later
"""From Python come the bytes of the command line."""

import tempfile
import unittest
from pathlib import Path

import numpy as np
import toile
from support import SAMPLES, SOURCE, arrays_of, program, run_program, sample, shared

NAMES = ("pattern.obj", "pattern.svg", "pattern.dxf")


class SameBytes(unittest.TestCase):
    def setUp(self) -> None:
        program()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def expect_same(self, path: Path, words: list[str], flatten: dict, **reading: object) -> None:
        """Of a file, and of its arrays."""
        own = self.folder / path.stem
        there, loaded, arrays = (own / name for name in ("cli", "loaded", "arrays"))
        for folder in (there, loaded, arrays):
            folder.mkdir(parents=True)
        outputs = [word for name in NAMES for word in ("-o", there / name)]
        run_program("flatten", path, *words, *outputs)
        given = arrays_of(path)
        vertices, faces = given.pop("vertices"), given.pop("faces")
        for garment, folder in (
            (toile.load(path, **reading), loaded),
            (toile.garment(vertices, faces, **given, **reading), arrays),
        ):
            written = garment.flatten(**flatten).write(*(folder / name for name in NAMES))
            self.assertEqual(len(written), len(NAMES))
            for name in NAMES:
                self.assertEqual(
                    (folder / name).read_bytes(),
                    (there / name).read_bytes(),
                    f"{folder.name}/{name} of {path.name}",
                )

    def test_samples(self) -> None:
        paths = sorted(SAMPLES.glob("*.obj"))
        self.assertGreater(len(paths), 4)
        for path in paths:
            with self.subTest(path.name):
                self.expect_same(path, ["--unit", "mm"], {}, unit="mm")

    def test_with_options(self) -> None:
        self.expect_same(
            sample("bodice.obj"),
            ["--unit=mm", "--method=curvature", "--pattern", "--fair", "0.5,40", "--half"],
            {"method": "curvature", "pattern": True, "fair": (0.5, 40), "half": True},
            unit="mm",
        )

    def test_tee_sim(self) -> None:
        path = shared("garments/tee_sim.obj")
        self.expect_same(path, ["--unit", "cm", "--auto-cut"], {}, unit="cm", auto_cut=True)

    def test_digits_are_the_only_thing_that_arrays_lack(self) -> None:
        given = arrays_of(sample("cap.obj"))
        given.pop("decimals")
        flat = toile.garment(given.pop("vertices"), given.pop("faces"), unit="mm", **given)
        flat.flatten().write(self.folder / "own.obj")
        toile.load(sample("cap.obj"), unit="mm").flatten().write(self.folder / "file.obj")
        own, file = (
            (self.folder / name).read_text().splitlines() for name in ("own.obj", "file.obj")
        )
        self.assertEqual(len(own), len(file))
        for mine, theirs in zip(own, file):
            if mine.startswith("v "):
                same = np.array(mine.split()[1:], float) == np.array(theirs.split()[1:], float)
                self.assertTrue(same.all())
            else:
                self.assertEqual(mine, theirs)


class Projects(unittest.TestCase):
    def test_a_project_says_how_it_is_read(self) -> None:
        project = SOURCE / "tests" / "data" / "sample.toile"
        flat = toile.load(project).flatten()
        with tempfile.TemporaryDirectory() as folder:
            there, here = (Path(folder) / name for name in ("cli.svg", "python.svg"))
            run_program("flatten", project, "-o", there)
            flat.write(here)
            self.assertEqual(here.read_bytes(), there.read_bytes())


if __name__ == "__main__":
    unittest.main()
