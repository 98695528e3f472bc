#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trials of `toile batch` and its workflow with many garments.

    tests/batch/trial.py local       Snakemake on two cores, workers killed at random
    tests/batch/trial.py slurm       the same through Slurm with one node, which it starts itself
    tests/batch/trial.py throughput  two cores against one by the clock; wants an idle machine

After each of the first two all must be as after a run that nothing disturbed: every garment once,
the same summary, the same bytes of patterns. Ends with 1 where it is not, with 77 where something
is not installed.
"""
import argparse
import contextlib
import csv
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator, Mapping
from pathlib import Path

from one_node_slurm import lacking, one_node_slurm

ROOT = Path(__file__).resolve().parents[2]
WORKFLOW = ROOT / "resources" / "batch"
SKIPPED = 77
DOCS = ROOT / "docs" / "batch.md"
PLAN_FROM, PLAN_TO = "<!-- plan: tests/batch/trial.py throughput --docs -->", "<!-- end of plan -->"
COSTS = 3  # columns at the end of the summary that are another at every run
RUNS = 4  # of a workflow, until all is done: what was killed too often is left to the next
OPTIONS = "--formats json,svg,obj"
# What a batch is for is a pattern that can be cut.
FULL_OPTIONS = "--pattern --formats json,svg,dxf"


class Killer(threading.Thread):
    """Kills, now and then, a process of one program."""

    def __init__(self, program: Path, most: int, seed: int = 1) -> None:
        super().__init__(daemon=True)
        self.program, self.most = str(program), most
        self.choice = random.Random(seed)
        self.killed = 0
        self.ended = threading.Event()

    def processes(self) -> list[int]:
        found = []
        for folder in Path("/proc").iterdir():
            with contextlib.suppress(OSError):
                if folder.name.isdigit() and os.readlink(folder / "exe") == self.program:
                    found.append(int(folder.name))
        return found

    def run(self) -> None:
        while self.killed < self.most and not self.ended.wait(self.choice.uniform(0.2, 1.5)):
            running = self.processes()
            if running:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(self.choice.choice(running), signal.SIGKILL)
                    self.killed += 1


@contextlib.contextmanager
def workers_killed(program: Path, most: int) -> Iterator[Killer]:
    killer = Killer(program, most)
    killer.start()
    try:
        yield killer
    finally:
        killer.ended.set()
        killer.join()


def workflow(
    work: Path,
    out: Path,
    program: Path,
    options: str,
    *more: str,
    env: Mapping[str, str] = os.environ,
) -> int:
    """@return how often it had to be run"""
    env = {**env, "XDG_CACHE_HOME": str(work / "cache")}  # Snakemake's own
    command = ["snakemake", "-s", str(WORKFLOW / "Snakefile"), "--directory", str(work), *more]
    command += ["--nolock", "--rerun-incomplete", "--config", f"list={work}/garments/list.txt"]
    command += [f"out={out}", f"toile={program}", "shards=20", f"options={options}"]
    for run in range(1, RUNS + 1):
        done = subprocess.run(command, env=env, capture_output=True, text=True)
        if done.returncode == 0:
            return run
    raise SystemExit(f"The workflow does not come to its end:\n{done.stderr[-5000:]}")


def lasting(summary: Path) -> list[list[str]]:
    with open(summary, encoding="utf-8", newline="") as lines:
        return [row[:-COSTS] for row in csv.reader(lines)]


def check_same(plain: Path, out: Path, count: int) -> None:
    """Every garment once, nothing half done, the same summary and patterns."""
    ours, theirs = lasting(out / "summary.csv"), lasting(plain / "summary.csv")
    names = [row[0] for row in ours[1:]]
    wrong = []
    if len(names) != count or len(set(names)) != count:
        wrong.append(f"{len(set(names))} garments of {count}")
    wrong += [f"{a[0]}: {a} instead of {b}" for a, b in zip(ours, theirs) if a != b][:5]
    wrong += [f"{path} is left" for path in out.glob("*.part")]
    folders = {path.name for path in out.iterdir() if (path / "garment.json").is_file()}
    if folders != set(names):
        wrong.append(f"other folders than records: {sorted(folders ^ set(names))[:5]}")
    for name in names:
        for path in (plain / name).iterdir():
            other = out / name / path.name
            if not other.is_file():
                wrong.append(f"{other} is not there")
            elif path.suffix != ".json" and path.read_bytes() != other.read_bytes():
                wrong.append(f"{other} is another")
    if wrong:
        raise SystemExit("\n".join(wrong[:20]))


def undisturbed(work: Path, program: Path, options: str) -> float:
    """@return how long it took by the clock"""
    start = time.monotonic()
    command = [program, "batch", work / "garments" / "list.txt", "-o", work / "plain"]
    done = subprocess.run([*command, *options.split()], stdout=subprocess.DEVNULL)
    if done.returncode not in (0, 1):
        raise SystemExit(f"toile batch ended with {done.returncode}")
    seconds = time.monotonic() - start
    summary(work / "plain")
    return seconds


def summary(folder: Path) -> None:
    files = ["--csv", folder / "summary.csv", "--html", folder / "summary.html"]
    subprocess.run([sys.executable, WORKFLOW / "summary.py", folder, *files], check=True)


def disturbed(
    work: Path,
    program: Path,
    count: int,
    name: str,
    *more: str,
    env: Mapping[str, str] = os.environ,
) -> None:
    seconds = undisturbed(work, program, OPTIONS)
    out = work / name
    with workers_killed(program, most=max(3, count // 20)) as killer:
        start = time.monotonic()
        runs = workflow(work, out, program, OPTIONS, *more, env=env)
        took = time.monotonic() - start
    check_same(work / "plain", out, count)
    print(
        f"{name}: {count} garments, {killer.killed} workers killed, workflow run {runs} times: "
        f"every garment once, all as in the undisturbed run "
        f"({took:.0f} s; that one {seconds:.0f} s)"
    )


def local(work: Path, program: Path, count: int) -> None:
    disturbed(work, program, count, "local", "-j2")


def slurm(work: Path, program: Path, count: int) -> None:
    with one_node_slurm(work / "slurm") as environment:
        profile = ["--profile", str(WORKFLOW / "slurm"), "--latency-wait", "10"]
        disturbed(work, program, count, "slurm-jobs", *profile, env=environment)


def throughput(work: Path, program: Path, count: int, docs: bool, least: float) -> None:
    one = undisturbed(work, program, FULL_OPTIONS)
    start = time.monotonic()
    workflow(work, work / "two", program, FULL_OPTIONS, "-j2")
    two = time.monotonic() - start
    check_same(work / "plain", work / "two", count)
    print(
        f"throughput: {count} garments, one core {one:.1f} s, Snakemake on two {two:.1f} s: "
        f"{one / two:.2f} times"
    )
    command = [sys.executable, WORKFLOW / "summary.py", work / "plain", "--plan", "100000"]
    plan = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    files = [path for path in (work / "plain").rglob("pattern.*")]
    size = sum(path.stat().st_size for path in files) / count
    plan += f"| files of one: mean | {size / 1e3:.0f} kB in {len(files) / count:.1f} files |\n"
    plan += f"| two cores by Snakemake, against one core | {one / two:.2f} times the garments |\n"
    print(plan, end="")
    if docs:
        page = DOCS.read_text(encoding="utf-8")
        before, after = page.split(PLAN_FROM)[0], page.split(PLAN_TO)[1]
        text = f"{before}{PLAN_FROM}\n\n{plan}\n{PLAN_TO}{after}"
        DOCS.write_text(text, encoding="utf-8")
    if one / two < least:
        raise SystemExit(f"Two cores do {one / two:.2f} times what one does, not {least} times.")


def main() -> int:
    trials = {"local": local, "slurm": slurm, "throughput": throughput}
    parser = argparse.ArgumentParser(description="Trials of toile batch with many garments.")
    parser.add_argument("trial", choices=trials)
    parser.add_argument("--count", type=int, help="of garments [500; throughput: 120]")
    parser.add_argument("--toile", type=Path, default=ROOT / "build" / "release" / "app" / "toile")
    parser.add_argument("--docs", action="store_true", help="throughput: the plan into the docs")
    parser.add_argument(
        "--least", type=float, default=0, help="throughput: what two cores are to do, of one's"
    )
    parser.add_argument("--keep", type=Path, help="folder for all of it, which stays")
    typed = parser.parse_args()
    count = typed.count or (120 if typed.trial == "throughput" else 500)
    missing = [] if shutil.which("snakemake") else ["snakemake"]
    missing += lacking() if typed.trial == "slurm" else []
    if missing:
        print(f"{typed.trial}: skipped, there is no {', '.join(missing)}")
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix="toile-batch-") as folder:
        work = typed.keep.resolve() if typed.keep else Path(folder)
        work.mkdir(parents=True, exist_ok=True)
        program = work / "toile"  # a copy, so that its processes are known
        shutil.copy2(typed.toile, program)
        maker = Path(__file__).with_name("make_garments.py")
        subprocess.run(
            [sys.executable, maker, work / "garments", str(count)], check=True
        )
        is_measured = typed.trial == "throughput"
        more = {"docs": typed.docs, "least": typed.least} if is_measured else {}
        trials[typed.trial](work, program, count, **more)
    return 0


if __name__ == "__main__":
    sys.exit(main())
