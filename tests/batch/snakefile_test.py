#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The workflow around `toile batch`, with a program in its place that takes no time."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BATCH = Path(__file__).resolve().parents[2] / "resources" / "batch"

# One garment is too slow until there is a file "calm".
PROGRAM = """#!/usr/bin/env python3
import json, pathlib, sys
shard, out = pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[4])
records = []
for name in shard.read_text().split():
    slow = name == "slow.obj" and not pathlib.Path("calm").exists()
    error = {"code": "timed-out", "subject": None, "message": "took long", "again": True}
    none = ["pieces", "triangles", "worst_seam_mm", "strain_mean", "strain_max"]
    records.append(dict.fromkeys(none) | {
        "name": name, "toile": "0", "status": "failed" if slow else "done",
        "error": error if slow else None,
        "doubts": [], "cost": {"wall_s": 0.1, "processor_s": 0.1, "peak_mib": 1},
    })
(out / f"{shard.stem}.jsonl").write_text("".join(json.dumps(each) + "\\n" for each in records))
with open("asked", "a") as asked:
    asked.write(shard.stem + "\\n")
sys.exit(any(each["error"] for each in records))
"""


class Scripts(unittest.TestCase):
    def setUp(self) -> None:
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = Path(kept.name) / "a folder"
        self.folder.mkdir()

    def script(self, name: str, text: str) -> Path:
        path = self.folder / name
        path.write_text(text)
        path.chmod(0o755)
        return path


@unittest.skipUnless(shutil.which("snakemake"), "there is no snakemake")
class WorkflowTest(Scripts):
    def setUp(self) -> None:
        super().setUp()
        shutil.copytree(BATCH, self.folder / "batch")
        self.script("program", PROGRAM)
        (self.folder / "list.txt").write_text("a.obj\nslow.obj\nb.obj\nc.obj\n# none\n  # none\n")

    def run_it(self, *config: str) -> subprocess.CompletedProcess[str]:
        command = ["snakemake", "-s", "batch/Snakefile", "-j2", "--nolock", "--config"]
        return subprocess.run(
            [*command, f"toile={self.folder}/program", "shards=2", "list=list.txt", "out=out"]
            + list(config),
            cwd=self.folder, capture_output=True, text=True,
            env=os.environ | {"XDG_CACHE_HOME": str(self.folder / "cache")},
        )  # fmt: skip

    def shards(self) -> list[str]:
        """Those that were under way since the last question."""
        asked = self.folder / "asked"
        found = sorted(asked.read_text().split()) if asked.exists() else []
        asked.unlink(missing_ok=True)
        return found

    def test_what_the_machine_was_to_blame_for_is_run_again_and_nothing_else(self) -> None:
        done = self.run_it()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.shards(), ["shard00000", "shard00001"])
        self.assertIn("timed-out", (self.folder / "out" / "summary.csv").read_text())
        (self.folder / "calm").touch()
        done = self.run_it()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.shards(), ["shard00001"])
        self.assertNotIn("timed-out", (self.folder / "out" / "summary.csv").read_text())
        self.assertIn("Nothing to be done", self.run_it().stderr)
        self.assertFalse((self.folder / "batch" / "__pycache__").exists())

    def test_shards_of_a_run_before_are_no_part_of_the_summary(self) -> None:
        (self.folder / "calm").touch()
        self.assertEqual(self.run_it("shards=3").returncode, 0)
        (self.folder / "out" / "own.jsonl").touch()  # of a list that was not dealt here
        (self.folder / "other.txt").write_text("d.obj\n")
        done = self.run_it("shards=1", "list=other.txt")
        self.assertEqual(done.returncode, 0, done.stderr)
        table = (self.folder / "out" / "summary.csv").read_bytes()
        self.assertEqual(table.count(b"\n"), 2)
        whole = [sys.executable, BATCH / "summary.py", "out", "--csv", "whole.csv"]
        subprocess.run(whole, cwd=self.folder, check=True)
        self.assertEqual((self.folder / "whole.csv").read_bytes(), table)
        self.assertTrue((self.folder / "out" / "own.jsonl").exists())

    def test_wrong_words_get_a_sentence(self) -> None:
        says = {"list=none.txt": "There is no list", "shards=few": "no whole number"}
        for config, sentence in says.items():
            done = self.run_it(config)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(sentence, done.stderr)
            self.assertNotIn("Traceback", done.stderr)
        (self.folder / "7").write_text("a.obj\n")
        done = self.run_it("list=7", "out=2024", "shards=0")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "2024" / "summary.csv").is_file())


class StatusTest(Scripts):
    """What the profile for Slurm tells Snakemake of a job."""

    def status(self, scontrol: str, sacct: str) -> str:
        self.script("scontrol", f"#!/bin/sh\n{scontrol}\n")
        self.script("sacct", f"#!/bin/sh\n{sacct}\n")
        script = BATCH / "slurm" / "status.py"
        self.script(
            "waitless.py",
            "import runpy, time\ntime.sleep = lambda _: None\n"
            f"runpy.run_path({str(script)!r}, run_name='__main__')\n",
        )
        path = f"{self.folder}:{os.environ['PATH']}"
        return subprocess.run(
            [sys.executable, self.folder / "waitless.py", "7;cluster"],
            check=True, capture_output=True, text=True, env=os.environ | {"PATH": path},
        ).stdout.strip()  # fmt: skip

    def test_a_job_has_failed_only_where_that_is_known(self) -> None:
        down = "echo 'slurm_load_jobs error: Unable to contact slurm controller' >&2; exit 1"
        forgotten = "echo 'slurm_load_jobs error: Invalid job id specified' >&2; exit 1"
        for scontrol, sacct, status in (
            ("echo JobId=7 JobState=RUNNING Reason=None", down, "running"),
            ("echo JobId=7 JobState=COMPLETED Reason=None", down, "success"),
            ("echo JobId=7 JobState=NODE_FAIL Reason=None", down, "failed"),
            (forgotten, "echo COMPLETED", "success"),
            (forgotten, "echo CANCELLED by 0", "failed"),
            (forgotten, down, "failed"),
            (down, down, "running"),
            (down, "echo COMPLETED", "success"),
            (down, "echo FAILED", "failed"),
        ):
            with self.subTest(scontrol=scontrol, sacct=sacct):
                self.assertEqual(self.status(scontrol, sacct), status)


if __name__ == "__main__":
    unittest.main()
