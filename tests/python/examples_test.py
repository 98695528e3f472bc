# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples do what they say."""

import csv
import importlib.util
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from support import SOURCE, sample

EXAMPLES = SOURCE / "resources" / "python"


class Examples(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_example(self, name: str, *words: object, needs: tuple[str, ...] = ()) -> str:
        for module in needs:
            if importlib.util.find_spec(module) is None:
                self.skipTest(f"{name} needs {module}")
        done = subprocess.run(
            [sys.executable, EXAMPLES / name, *map(str, words)],
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_batch(self) -> None:
        bad = self.folder / "bad.obj"
        bad.write_text("v 0 0 0\n")
        table = self.folder / "out" / "summary.csv"
        self.run_example("batch.py", sample("cap.obj"), bad, "-o", table.parent)
        with table.open(newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["garment"] for row in rows], ["cap", "bad"])
        self.assertEqual([row["error"] for row in rows], ["", "no-geometry"])
        self.assertGreater(int(rows[0]["pieces"]), 1)
        self.assertTrue((table.parent / "cap.svg").exists())

    def test_batch_keeps_namesakes_apart_and_names_what_failed(self) -> None:
        cap, other = sample("cap.obj"), self.folder / "other" / "cap.obj"
        other.parent.mkdir()
        # A triangle, and a band with half a turn, which has no right side.
        triangle = ["o flat", "f 1 2 3"]
        lines = ["v 0 0 9", "v 9 0 9", "v 0 9 9", *triangle]
        fields = 12
        for turn in (2 * math.pi * k / fields for k in range(fields)):
            for half in (-5, 5):
                out = 30 + half * math.cos(turn / 2)
                at = out * math.cos(turn), out * math.sin(turn), half * math.sin(turn / 2)
                lines.append("v {} {} {}".format(*at))
        rungs = [(4 + 2 * k, 5 + 2 * k) for k in range(fields)]
        lines.append("o band")
        for (a, b), (c, d) in zip(rungs, [*rungs[1:], rungs[0][::-1]]):
            lines += [f"f {a} {b} {c}", f"f {b} {d} {c}"]
        other.write_text("\n".join(lines) + "\n")
        band = self.folder / "band.obj"
        band.write_text("\n".join(line for line in lines if line not in triangle) + "\n")
        table = self.folder / "out" / "summary.csv"
        self.run_example("batch.py", cap, other, band, "-o", table.parent)
        with table.open(newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["garment"] for row in rows], ["cap", "cap 2", "band"])
        self.assertEqual((rows[1]["pieces"], rows[1]["flat"]), ("2", "1"))
        self.assertEqual((rows[2]["pieces"], rows[2]["flat"]), ("1", "0"))
        self.assertEqual([row["error"] for row in rows], ["", "not-orientable", "not-orientable"])
        self.assertTrue((table.parent / "cap 2.svg").exists())

    def test_meshio(self) -> None:
        out = self.folder / "flat.vtu"
        self.run_example("through_meshio.py", sample("cap.obj"), out, needs=("meshio",))
        import meshio

        self.assertIn("strain", meshio.read(out).cell_data)

    def test_pictures(self) -> None:
        out = self.folder / "pictures"
        said = self.run_example(
            "pictures.py", sample("bodice.obj"), "-o", out, needs=("matplotlib",)
        )
        self.assertIn("isometric", said)
        for name in ("strain.png", "methods.png"):
            self.assertGreater((out / name).stat().st_size, 10_000)


if __name__ == "__main__":
    unittest.main()
