#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gathers the records of `toile batch` into a table and a page (docs/batch.md).

summary.py WHERE... --csv FILE.csv --html FILE.html
summary.py WHERE... --plan 100000 --cores 100

WHERE is a file of records, .jsonl, or a folder of them. A garment that several files name is one.
Tables are in the order of names, and but for the last three columns the same at every run.
"""
import argparse
import csv
import io
import sys
from pathlib import Path
from typing import Any

sys.dont_write_bytecode = True  # beside the scripts
from page import page
from records import COSTS, Record, mean, numbers, peak, processor, quantile, records_of, wall

FIELDS = [
    "name", "input", "hash", "options", "toile", "status", "code", "subject", "message", "pieces",
    "failed_pieces", "triangles", "seams", "worst_seam_mm", "strain_mean", "strain_max", "flipped",
    "crossings", "fingerprint", "doubts", "outputs",
]  # fmt: skip


def cell(value: Any) -> str:
    if value is None:
        return ""
    return " ".join(map(str, value)) if isinstance(value, list) else str(value)


def row(record: Record) -> list[str]:
    flat = record | (record["error"] or {})
    return [cell(flat.get(field)) for field in FIELDS] + [
        f"{record['cost'][cost]:.3f}" for cost in COSTS
    ]


def table(records: list[Record]) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(FIELDS + COSTS)
    writer.writerows(map(row, records))
    return out.getvalue()


def plan(records: list[Record], count: int, cores: int) -> str:
    """What so many garments of the same kinds would take on so many cores, as Markdown. By
    processor time, which counts alike on a machine that has other things to do."""
    walls, peaks = numbers(records, wall), numbers(records, peak)
    time = numbers(records, processor)
    hours = mean(time) * count / cores / 3600
    failed = [record for record in records if record["status"] == "failed"]
    some = [record for record in records if record["status"] == "some-failed"]
    triangles = numbers(records, lambda record: record["triangles"])
    rows = [
        ("garments measured", f"{len(records)}"),
        ("triangles of one: mean, largest", f"{mean(triangles):.0f}, {quantile(triangles, 1):.0f}"),
        (
            "processor time of one: mean, half below, 99 % below",
            f"{mean(time):.2f} s, {quantile(time, 0.5):.2f} s, {quantile(time, 0.99):.2f} s",
        ),
        ("by the clock: mean, longest", f"{mean(walls):.2f} s, {quantile(walls, 1):.1f} s"),
        (
            "peak memory: half below, largest",
            f"{quantile(peaks, 0.5):.0f} MiB, {quantile(peaks, 1):.0f} MiB",
        ),
        (
            "failed, with failed pieces",
            f"{100 * len(failed) / len(records):.1f} %, {100 * len(some) / len(records):.1f} %",
        ),
        (f"processor time of {count} garments", f"{mean(time) * count / 3600:.1f} h"),
        (f"on {cores} cores", f"{60 * hours:.1f} min"),
        ("the same, and half as much for starts, retries, a shared disk", f"{90 * hours:.1f} min"),
    ]
    return "| | |\n|---|---:|\n" + "".join(f"| {what} | {value} |\n" for what, value in rows)


def positive(text: str) -> int:
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text} is no whole number above 0")
    return int(text)


def main() -> int:
    parser = argparse.ArgumentParser(description="Gathers the records of toile batch.")
    parser.add_argument("places", nargs="+", type=Path, metavar="WHERE", help=".jsonl or folder")
    parser.add_argument("--csv", type=Path, help="table to write")
    parser.add_argument("--html", type=Path, help="page to write")
    parser.add_argument("--plan", type=positive, metavar="N", help="print what N would take")
    parser.add_argument("--cores", type=positive, default=100, help="of the plan [100]")
    typed = parser.parse_args()
    missing = [place for place in typed.places if not place.exists()]
    if missing:
        parser.error(f"there is no {missing[0]}")
    if not (typed.csv or typed.html or typed.plan):
        parser.error("nothing is asked for; give --csv, --html or --plan")
    try:
        records = records_of(typed.places)
        if typed.csv:
            typed.csv.write_text(table(records), encoding="utf-8")
        if typed.html:
            typed.html.write_text(page(records), encoding="utf-8")
    except OSError as error:
        sys.exit(f"summary.py: {error.filename}: {error.strerror}")
    if typed.plan:
        if not records:
            parser.error("no garment has been measured")
        print(plan(records, typed.plan, typed.cores), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
