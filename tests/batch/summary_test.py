#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The summary of records that no program made: what is counted, in which order, and how shown."""
import csv
import json
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

SUMMARY = Path(__file__).resolve().parents[2] / "resources" / "batch" / "summary.py"


def record(name: str, status: str = "done", **other) -> dict:
    error = None
    if status != "done":
        code = other.pop("code", "crashed")
        error = {"code": code, "subject": None, "message": "broke <here> & so", "again": True}
    is_there = status != "failed"
    return {
        "name": name, "input": f"/in/{name}.obj", "hash": "xxh64:00", "options": ["--unit", "mm"],
        "toile": "0.1.0", "key": "xxh64:01", "status": status, "error": error,
        "pieces": 3 if is_there else None, "failed_pieces": 0 if is_there else None,
        "triangles": 1000 if is_there else None, "seams": 2 if is_there else None,
        "worst_seam_mm": 1e-13 if is_there else None, "strain_mean": 0.01 if is_there else None,
        "strain_max": 0.05 if is_there else None, "flipped": 0, "crossings": 0, "fingerprint": None,
        "doubts": [], "notes": [], "outputs": ["pattern.svg"],
        "cost": {"wall_s": 0.5, "processor_s": 0.25, "peak_mib": 20.0},
    } | other  # fmt: skip


class SummaryTest(unittest.TestCase):
    def setUp(self) -> None:
        self.kept = tempfile.TemporaryDirectory()
        self.addCleanup(self.kept.cleanup)
        self.folder = Path(self.kept.name)

    def summary(self, shards: list[list[dict]], *more: str) -> str:
        for number, records in enumerate(shards):
            lines = "".join(json.dumps(record) + "\n" for record in records)
            (self.folder / f"shard{number}.jsonl").write_text(lines)
        files = ["--csv", self.folder / "s.csv", "--html", self.folder / "s.html"]
        return subprocess.run(
            [sys.executable, SUMMARY, self.folder, *files, *more],
            check=True, capture_output=True, text=True,
        ).stdout  # fmt: skip

    def rows(self) -> list[dict[str, str]]:
        with open(self.folder / "s.csv", newline="") as lines:
            return list(csv.DictReader(lines))

    def page(self) -> str:
        return (self.folder / "s.html").read_text()

    def test_every_garment_is_one_row_in_the_order_of_names_however_they_were_dealt(self) -> None:
        garments = [record("b"), record("a"), record("c", "failed", code="timed-out")]
        self.summary([garments])
        together = (self.folder / "s.csv").read_bytes(), self.page()
        self.summary([[garments[2], garments[0]], [garments[1]]])
        self.assertEqual(((self.folder / "s.csv").read_bytes(), self.page()), together)
        self.assertEqual([row["name"] for row in self.rows()], ["a", "b", "c"])
        self.assertEqual([row["code"] for row in self.rows()], ["", "", "timed-out"])

    def test_garments_of_equal_content_are_a_row_each_however_they_were_dealt(self) -> None:
        twins = [record("a", input="y/a.obj"), record("a", input="x/a.obj")]
        for shards in ([twins], [twins[::-1]], [twins[:1], twins[1:]], [twins, twins]):
            self.summary(shards)
            self.assertEqual([row["input"] for row in self.rows()], ["x/a.obj", "y/a.obj"])

    def test_of_two_records_the_better_counts(self) -> None:
        self.summary([[record("a", "failed")], [record("a")]])
        self.assertEqual([row["status"] for row in self.rows()], ["done"])

    def test_the_page_needs_nothing_else_and_escapes_what_files_say(self) -> None:
        good = [record(f"g{k}", strain_mean=0.001 * k) for k in range(50)]
        self.summary([good, [record("x", "failed")]])
        page = self.page()
        self.assertIsNone(re.search(r"<script|https?://|url\(|@import|src=", page))
        self.assertIn("broke &lt;here&gt; &amp; so", page)
        drawings = re.findall(r"<svg.*?</svg>", page)
        self.assertEqual(len(drawings), 6)
        for drawing in drawings:
            heights = [
                int(title.text.rsplit(": ", 1)[1])
                for title in xml.etree.ElementTree.fromstring(drawing).iter("title")
            ]
            self.assertIn(sum(heights), (50, 51), "every garment is in a bar")

    def test_a_plan_follows_from_processor_time(self) -> None:
        records = [record("a"), record("b", "failed")]
        said = self.summary([records], "--plan", "144000", "--cores", "100")
        self.assertIn("| processor time of 144000 garments | 10.0 h |", said)
        self.assertIn("| on 100 cores | 6.0 min |", said)
        self.assertIn("| 50.0 %, 0.0 % |", said)

    def refused(self, *words: object) -> str:
        done = subprocess.run(
            [sys.executable, SUMMARY, *map(str, words)], capture_output=True, text=True
        )
        self.assertIn(done.returncode, (1, 2))
        self.assertNotIn("Traceback", done.stderr)
        return done.stderr

    def test_what_cannot_be_gathered_is_said_in_a_sentence(self) -> None:
        page = self.folder / "page.html"
        self.assertIn("holds no records", self.refused(self.folder, "--html", page))
        records = self.folder / "shard.jsonl"
        line = json.dumps(record("a"))
        records.write_text(f"{line}\n")
        self.assertIn("nothing is asked for", self.refused(records))
        self.assertIn("no whole number", self.refused(records, "--plan", "10", "--cores", "0"))
        self.assertIn("No such file", self.refused(records, "--csv", self.folder / "no" / "s.csv"))
        for cut in (line[:-20], "{}", "[1]", '"a"', line.replace('"done"', '"well"')):
            records.write_text(f"{line}\n{cut}\n")
            self.assertIn("line 2: no record", self.refused(records, "--html", page))
        self.assertFalse(page.exists())

    def test_seams_that_are_wrong_are_far_from_those_that_round(self) -> None:
        self.summary([[record("a"), record("b", worst_seam_mm=0.0), record("c", worst_seam_mm=3)]])
        self.assertIn("2 of 3 below a millionth mm, largest 3 mm: <b>c</b>", self.page())

    def test_nothing_is_a_summary_too(self) -> None:
        self.summary([[]])
        self.assertEqual(self.rows(), [])
        self.assertIn("<b>0</b>garments", self.page())


if __name__ == "__main__":
    unittest.main()
