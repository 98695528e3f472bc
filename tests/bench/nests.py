#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lays the published instances by the clock and writes the table of docs/marker.md.

    tests/bench/nests.py build/release/app/toile ../shared/data/nesting

Leave the machine alone meanwhile: it takes 65 seconds an instance, on two threads. With --seconds S it
is a try: S seconds instead of 5 and 60, and the table is only shown.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

# Means over 20 minutes that [GVW25] reports, in per cent.
PUBLISHED = {"shirts": 89.7, "trousers": 91.7, "swim": 78.3, "albano": 89.5, "dagli": 89.3}
PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "marker.md"
BEGIN, END = "<!-- written by tests/bench/nests.py -->\n", "<!-- until here -->\n"


def laid(program, instance, folder, *until):
    """Use in per cent and rounds, of a nest that is valid."""
    report = pathlib.Path(folder) / "nest.json"
    subprocess.run([program, "marker", instance, "--threads", "2", "--report", report, *until],
                   check=True, stdout=subprocess.DEVNULL)
    nest = json.loads(report.read_text())
    if not nest["valid"]:
        sys.exit(f"{instance}: the nest is not valid")
    return 100 * nest["use"], nest["rounds"]


def main():
    options = argparse.ArgumentParser(description=__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("instances", type=pathlib.Path)
    options.add_argument("--seconds", type=float, help="a try")
    typed = options.parse_args()
    times = [typed.seconds] if typed.seconds else [5, 60]
    heads = ["Instance", "First nest", *(f"{time:g} s" for time in times), "[GVW25]"]
    lines = ["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    with tempfile.TemporaryDirectory() as folder:
        for name, published in PUBLISHED.items():
            instance = typed.instances / f"{name}.json"
            cells = [name, f"{laid(typed.program, instance, folder, '--rounds', '0')[0]:.2f}"]
            for time in times:
                use, rounds = laid(typed.program, instance, folder, "--time", str(time))
                cells.append(f"{use:.2f} ({rounds})")
            lines.append("| " + " | ".join([*cells, f"{published}"]) + " |")
            print(lines[-1], flush=True)
    table = "\n".join(lines) + "\n"
    if typed.seconds:
        print(table, end="")
        return
    page = PAGE.read_text()
    begin, end = page.index(BEGIN) + len(BEGIN), page.index(END)
    PAGE.write_text(page[:begin] + table + page[end:])


if __name__ == "__main__":
    main()
