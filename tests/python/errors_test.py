# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong has a code, a subject and a sentence."""

import os
import signal
import tempfile
import threading
import time
import types
import unittest
from pathlib import Path

import numpy as np
import toile
from support import grid, sample


class Errors(unittest.TestCase):
    def test_a_file_that_is_not_there(self) -> None:
        with self.assertRaises(toile.FileError) as caught:
            toile.load("nowhere.obj")
        self.assertEqual(caught.exception.code, "file-unreadable")
        self.assertIn("nowhere.obj", caught.exception.subject)
        self.assertIn("nowhere.obj", str(caught.exception))
        self.assertIsInstance(caught.exception, toile.Error)
        self.assertTrue(caught.exception.again)  # it may be there by then

    def test_a_project_that_is_none(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "none.toile"
            path.write_text("{}")
            with self.assertRaises(toile.FileError) as caught:
                toile.load(path)
            self.assertEqual(caught.exception.code, "malformed-project")
            self.assertFalse(caught.exception.again)
            with self.assertRaises(toile.UsageError):
                toile.load(path, unit="cm")

    def test_no_geometry(self) -> None:
        with self.assertRaises(toile.Error) as caught:
            toile.garment(np.zeros((3, 3)), [])
        self.assertEqual(caught.exception.code, "no-geometry")
        self.assertEqual(caught.exception.subject, "garment")

    def test_options_are_those_of_the_command_line(self) -> None:
        points, faces = grid()
        made = toile.garment(points, faces, unit="mm")
        flat = made.flatten()
        for call in (
            lambda: toile.garment(points, faces, unit="furlong"),
            lambda: toile.garment(points, faces, no_such_option=1),
            lambda: toile.garment(points, faces, json=True),
            lambda: toile.load(sample("cap.obj"), method="lscm"),
            lambda: toile.load(),
            lambda: made.flatten(method="magic"),
            lambda: made.flatten(unit="cm"),
            lambda: made.flatten(output="a.svg"),
            lambda: made.flatten(paper="a4"),
            lambda: made.flatten(allowance=-1),
            lambda: made.flatten(pattern="yes"),
            lambda: made.flatten(half=1),
            lambda: made.flatten(threads="2"),
            lambda: made.flatten(threads=1.0),
            lambda: made.flatten(threads=None),
            lambda: made.flatten(threads=-2),
            lambda: made.flatten(threads=10**30),
            lambda: made.flatten(progress=5),
            lambda: toile.load(sample("cap.obj"), progress="bar"),
            lambda: flat.write("pattern.xyz"),
            lambda: flat.write("pattern.svg", paper="a17"),
            lambda: flat.write("pattern.svg", method="lscm"),
            lambda: flat.prove(scale=9),
            lambda: flat.prove(rounds=3),
            lambda: flat.prove(unit="cm"),
            lambda: made.flatten(threads=65),
            lambda: made.flatten(threads=-1),
            lambda: made.flatten(ledger=True),
            lambda: made.flatten(help=True),
            lambda: flat.write("pattern.svg", report="report.json"),
        ):
            with self.assertRaises(toile.UsageError) as caught:
                call()
            self.assertEqual(caught.exception.code, "wrong-usage")
            self.assertIsInstance(caught.exception, ValueError)
            self.assertNotIn("toile --help", str(caught.exception))

    def test_a_refused_proof_has_the_code_that_other_programs_are_told(self) -> None:
        with self.assertRaises(toile.UsageError) as caught:
            toile.garment(*grid(), unit="mm").flatten().prove(reference="uv")
        self.assertEqual(caught.exception.code, "not-proved")

    def test_any_name_is_one(self) -> None:
        for name in ("", "flatten", "--unit", "-", "a b.toile"):
            made = toile.garment(*grid(), unit="mm", name=name)
            self.assertEqual(len(made.flatten(threads=64)), 1)

    def test_a_keyword_is_one_option(self) -> None:
        made = toile.garment(*grid(), unit="mm")
        with tempfile.TemporaryDirectory() as folder:
            other = Path(folder) / "other.svg"
            for keyword in (f"output={other}", "_", "__", "_output", "dxf-preset", ""):
                for call in (made.flatten, made.flatten().prove):
                    with self.assertRaises(toile.UsageError):
                        call(**{keyword: True})
                with self.assertRaises(toile.UsageError):
                    made.flatten().write(Path(folder) / "one.svg", **{keyword: True})
            self.assertEqual(os.listdir(folder), [])

    def test_arrays_say_what_tuples_say(self) -> None:
        made = toile.garment(*grid(bump=8), unit="mm")
        expected = made.flatten(fair=(0.5, 40), allowance=7).pattern.pieces[0].cutting_line
        for fair in ([0.5, 40], np.array([0.5, 40]), (np.float64(0.5), np.int64(40))):
            flat = made.flatten(fair=fair, allowance=np.int32(7), pattern=np.False_)
            np.testing.assert_array_equal(flat.pattern.pieces[0].cutting_line, expected)

    def test_a_zero_byte_is_refused(self) -> None:
        made = toile.garment(*grid(), unit="mm")
        with tempfile.TemporaryDirectory() as folder:
            for call in (
                lambda: toile.load(f"{sample('cap.obj')}\0.obj", unit="mm"),
                lambda: made.flatten(method="lscm\0"),
                lambda: made.flatten().write(f"{folder}/a.svg\0.dxf"),
                lambda: toile.garment(*grid(), unit="mm", name="tee\0.obj"),
            ):
                with self.assertRaises(toile.UsageError):
                    call()
            self.assertEqual(os.listdir(folder), [])

    def test_a_name_of_a_mesh_may_be_any(self) -> None:
        for name in ("[a,b]", "-o", "--unit=in", "a,b", ""):
            self.assertEqual(len(toile.garment(*grid(), unit="mm", name=name).pieces), 1)

    def test_where_nothing_lies_flat_a_report_says_why(self) -> None:
        # A closed ball has no outline.
        points = np.array([[0, 0, 0], [9, 0, 0], [0, 9, 0], [0, 0, 9]])
        faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
        flat = toile.garment(points, faces, unit="mm").flatten()
        with tempfile.TemporaryDirectory() as folder:
            files = [f"{folder}/ball.{ending}" for ending in ("csv", "html", "json")]
            with self.assertRaises(toile.Error) as caught:
                flat.write(files[0], f"{folder}/ball.svg")
            self.assertEqual(caught.exception.code, "not-flat")
            self.assertEqual(os.listdir(folder), [])
            flat.write(*files)
            self.assertIn(flat.pieces[0].error.code, Path(files[2]).read_text())

    def test_names_of_files_need_not_be_text(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            name = os.fsencode(folder) + b"/\xff.obj"
            for path in (name, os.fsdecode(name)):
                with self.assertRaises(toile.FileError) as caught:
                    toile.load(path)
                self.assertEqual(os.fsencode(caught.exception.subject), name)
                self.assertTrue(str(caught.exception))
            Path(os.fsdecode(name)).write_bytes(sample("cap.obj").read_bytes())
            made = toile.load(name, unit="mm")
            expected = toile.load(sample("cap.obj"), unit="mm")
            self.assertEqual(len(made), len(expected))
            self.assertTrue(all(piece.name and repr(piece) for piece in made.pieces))
            (written,) = made.flatten().write(name[:-4] + b".svg")
            self.assertEqual([os.fsencode(path) for path in written.files], [name[:-4] + b".svg"])
            self.assertTrue(str(written) and repr(written))
            self.assertTrue(os.path.exists(name[:-4] + b".svg"))
            toile.garment(*grid(), unit="mm", name=b"\xff.obj").flatten().report()

    def test_an_input_is_not_overwritten(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "cap.obj"
            path.write_bytes(sample("cap.obj").read_bytes())
            with self.assertRaises(toile.UsageError):
                toile.load(path, unit="mm").flatten().write(path)
            self.assertEqual(path.read_bytes(), sample("cap.obj").read_bytes())

    def test_a_file_that_cannot_be_written(self) -> None:
        flat = toile.garment(*grid(), unit="mm").flatten()
        with self.assertRaises(toile.FileError) as caught:
            flat.write("/nowhere/at/all/pattern.svg")
        self.assertEqual(caught.exception.code, "file-unwritable")
        self.assertTrue(caught.exception.again)

    def test_a_piece_that_fails_leaves_the_others(self) -> None:
        sheet, faces = grid()
        corners = np.array([[0, 0, 0], [9, 0, 0], [0, 9, 0], [0, 0, 9]]) + 100.0
        solid = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]) + len(sheet)
        made = toile.garment(
            np.vstack([sheet, corners]), np.vstack([faces, solid]), unit="mm", as_="sheet"
        )
        flat = made.flatten()
        self.assertEqual([piece.status for piece in flat.pieces], ["flat", "failed"])
        self.assertEqual(flat[1].error.code, "closed-surface")
        self.assertEqual(flat[1].error.code, made[1].defect.code)
        self.assertEqual(flat[1].error.subject, made[1].name)
        self.assertFalse(flat[1].error.again)
        self.assertIsNone(flat[1].positions)
        self.assertIsNone(flat[1].strain)
        self.assertIn("closed-surface", [problem.code for problem in flat.problems])
        for problem in flat.problems:
            self.assertTrue(str(problem))

    def test_names_and_indices(self) -> None:
        made = toile.garment(*grid(), unit="mm")
        with self.assertRaises(KeyError):
            made["sleeve"]
        for index in (1, -2):
            with self.assertRaises(IndexError):
                made[index]
        for of in (made, made.flatten()):
            self.assertEqual(of[np.int64(-1)].name, of[0].name)
            for huge in (2**80, -(2**80)):
                with self.assertRaises(IndexError):
                    of[huge]
            for key in (1.0, None, b"garment"):
                with self.assertRaises(TypeError):
                    of[key]
                self.assertNotIn(key, of)
        self.assertEqual(len(list(made.flatten())), 1)

    def test_seams_may_be_a_dictionary(self) -> None:
        points, faces = grid()
        line = [[20.0, y, 0.0] for y in (-1.0, 20.0, 41.0)]
        cut = {"name": "middle", "kind": "path", "points": line}
        seams = {"version": 1, "unit": "mm", "cuts": [cut]}
        made = toile.garment(points, faces, unit="mm", up="y", seams=seams)
        self.assertEqual(len(made), 2)
        mapping = types.MappingProxyType(
            seams | {"cuts": [types.MappingProxyType(cut | {"points": np.array(line)})]}
        )
        self.assertEqual(len(toile.garment(points, faces, unit="mm", up="y", seams=mapping)), 2)
        with self.assertRaises(TypeError):
            toile.garment(points, faces, seams={"cuts": {1, 2}})
        with self.assertRaises(toile.FileError) as caught:
            toile.garment(points, faces, seams={"cuts": 7})
        self.assertEqual(caught.exception.code, "malformed-file")


class Progress(unittest.TestCase):
    def test_it_rises_to_the_end(self) -> None:
        told: list[float] = []
        made = toile.load(sample("tshirt.obj"), unit="mm", progress=told.append)
        for call in (
            lambda: made,
            lambda: toile.garment(*grid(), unit="mm", progress=told.append),
            lambda: made.flatten(threads=np.int64(1), progress=told.append),
        ):
            call()
            self.assertEqual(told[-1], 1)
            self.assertEqual(told, sorted(told))
            told.clear()
        with self.assertRaises(toile.FileError):
            toile.load("nowhere.obj", progress=told.append)
        self.assertNotIn(1, told)


class Cancelling(unittest.TestCase):
    """Within a moment of Ctrl-C the call is back, and nothing is broken."""

    def setUp(self) -> None:
        points, faces = grid(120, bump=400)
        self.garment = toile.garment(points, faces, unit="mm")

    def test_ctrl_c_ends_a_flattening(self) -> None:
        # A shell has what it starts in the background ignore it.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        threading.Timer(0.15, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            while True:
                self.garment.flatten()
        self.assertEqual(len(toile.garment(*grid(), unit="mm").flatten()), 1)

    def test_an_exception_of_progress_cancels(self) -> None:
        class Enough(Exception):
            pass

        def stop(fraction: float) -> None:
            self.assertTrue(0 <= fraction <= 1)
            raise Enough

        with self.assertRaises(Enough):
            self.garment.flatten(progress=stop)

    def test_other_threads_run_meanwhile(self) -> None:
        worker = threading.Thread(target=self.garment.flatten)
        worker.start()
        turns = 0
        while worker.is_alive():
            turns += 1
            time.sleep(0.001)
        self.assertGreater(turns, 3)


if __name__ == "__main__":
    unittest.main()
