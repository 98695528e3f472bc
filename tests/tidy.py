#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs clang-tidy (.clang-tidy) on the lines that changed since the merge base with main; in a clone
without main, and on main itself, since the last commit. Exits with 1 if there is a warning.

    tests/tidy.py                lines that changed, committed or not; without the static analyzer
    tests/tidy.py --all          every file of core and app, with the analyzer
    tests/tidy.py FILE.cpp...    these files, with the analyzer

Files of one folder are checked as one translation unit, since most of the time goes into the headers
that they share; a header is checked through one .cpp that includes it. Nothing is built, only configured
(in build/tidy, or $BUILD). Errors of Clang outside the changed lines are not shown; ./test.sh --sanitize
finds them.
"""
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(os.environ.get("BUILD", ROOT / "build" / "tidy")).resolve()
AT_ONCE = 12  # files of one translation unit: more need more memory and report nothing sooner
PLAIN = ["-DTOILE_UNITY=OFF", "-DBUILD_TESTING=OFF", "-DTOILE_PYTHON=ON",
         "-DCMAKE_CXX_COMPILER_LAUNCHER="]


def output(*command):
    """The lines that a command prints; none if it fails."""
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True).stdout.split("\n")[:-1]


def changed():
    """{file: [[first, last], ...]}: the lines of core and app that changed."""
    head = "".join(output("git", "rev-parse", "HEAD"))
    if not head:
        return {}  # an archive, not a clone
    base = [line for branch in ("origin/main", "main")
            for line in output("git", "merge-base", "HEAD", branch)]
    if not base or base[0] == head:
        base = output("git", "rev-parse", "--verify", "-q", "HEAD~1") or [head]
    lines = collections.defaultdict(list)
    for line in output("git", "diff", "-U0", "--no-color", "--diff-filter=d", base[0], "--", "core", "app"):
        if line.startswith("+++ b/"):
            file = line[6:]
        elif match := re.match(r"@@ -\S+ \+(\d+)(?:,(\d+))? @@", line):
            first, count = int(match[1]), int(match[2] or 1)
            if count and file.endswith((".cpp", ".h")):
                lines[file].append([first, first + count - 1])
    return lines


def unit_of(header, known, tries=3):
    """The .cpp of a header's name, else one that includes it, be it through other headers."""
    if header[:-2] + ".cpp" in known:
        return header[:-2] + ".cpp"
    users = output("git", "grep", "-lF", f'#include "{header}"', "--", "core", "app")
    through = [unit_of(user, known, tries - 1) for user in users if user.endswith(".h") and tries]
    return next((user for user in users + through if user in known), None)


def tidy(files, command, directory, options):
    """The warnings of clang-tidy for files as one translation unit."""
    name = re.sub(r"\W", "_", files[0])
    unit = BUILD / "units" / f"{name}_{len(files)}.cpp"
    unit.parent.mkdir(exist_ok=True)
    unit.write_text("".join(f'#include "{ROOT / file}"\n' for file in files))
    ran = subprocess.run(
        ["clang-tidy", "--quiet", f"--config-file={ROOT / '.clang-tidy'}", "--warnings-as-errors=*",
         *options,
         f"--header-filter={re.escape(str(ROOT))}/(core|app)/", str(unit), "--", *command,
         "-Wno-unknown-warning-option"], cwd=directory, capture_output=True, text=True)
    if len(files) > 1 and "[clang-diagnostic-error" in ran.stdout:  # their names collide
        return "".join(tidy([file], command, directory, options) for file in files)
    return ran.stdout or (ran.stderr if ran.returncode else "")


def main():
    BUILD.mkdir(parents=True, exist_ok=True)
    configured = subprocess.run(["cmake", "-S", ROOT, "-B", BUILD, "-G", "Ninja", *PLAIN],
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if configured.returncode:
        sys.exit(configured.stdout)
    known = {}
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["file"])
        if ROOT in path.parents and BUILD not in path.parents:
            words = shlex.split(entry["command"])[1:]
            known[str(path.relative_to(ROOT))] = (words[:words.index("-o")], entry["directory"])
    wanted, checks = set(sys.argv[1:]), "-bugprone-suspicious-include"
    options = []
    if not wanted:
        lines = changed()
        wanted = set(lines)
        checks += ",-clang-analyzer-*"
        options = ["--line-filter=" + json.dumps(
            [{"name": file, "lines": ranges} for file, ranges in sorted(lines.items())])]
    options.append(f"--checks={checks}")
    if "--all" in wanted:
        wanted = {file for file in known if file.startswith(("core/", "app/"))}
    wanted |= {unit_of(file, known) for file in wanted if file.endswith(".h")}
    groups = collections.defaultdict(list)
    for file in sorted(file for file in wanted if file in known):
        command, directory = known[file]
        groups[os.path.dirname(file), tuple(command), directory].append(file)
    jobs = [(files[i:i + AT_ONCE], command, directory)
            for (_, command, directory), files in groups.items()
            for i in range(0, len(files), AT_ONCE)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        warnings = [text for text in pool.map(lambda job: tidy(*job, options), jobs) if text.strip()]
    print("".join(warnings), end="")
    print(f"clang-tidy: {sum(len(job[0]) for job in jobs)} files, "
          f"{'warnings above' if warnings else 'no warning'}")
    return 1 if warnings else 0


sys.exit(main())
