# SPDX-License-Identifier: GPL-3.0-or-later
"""Records of `toile batch`, and figures of them (docs/batch.md)."""
import json
import math
import sys
from pathlib import Path
from typing import Any, Callable

Record = dict[str, Any]
Of = Callable[[Record], float | None]

COSTS = ["wall_s", "processor_s", "peak_mib"]
STATUSES = ["failed", "some-failed", "done"]  # from bad to good
# What the page cannot do without.
NEEDED = {"name", "toile", "status", "error", "pieces", "triangles", "worst_seam_mm", "strain_mean",
          "strain_max", "doubts", "cost"}  # fmt: skip


def record_of(line: str) -> Record | None:
    """None where the line is no record, or cut off."""
    try:
        record = json.loads(line)
    except ValueError:
        return None
    is_one = isinstance(record, dict) and NEEDED <= record.keys() and record["status"] in STATUSES
    return record if is_one and set(COSTS) <= set(record["cost"]) else None


def records_of(places: list[Path]) -> list[Record]:
    """In the order of names and paths. Of two records of a garment the one that came further counts.
    Ends the program with a sentence where one cannot be read."""
    found: dict[tuple[str, str], Record] = {}
    for place in places:
        files = sorted(place.glob("*.jsonl")) if place.is_dir() else [place]
        if not files:
            sys.exit(f"summary.py: {place} holds no records (.jsonl); give the folder of the batch")
        for path in files:
            with open(path, encoding="utf-8", errors="replace") as lines:
                for number, line in enumerate(lines, 1):
                    record = record_of(line)
                    if not record:
                        sys.exit(
                            f"summary.py: {path}, line {number}: no record of toile batch; run the "
                            "batch again, which writes it anew"
                        )
                    # Garments of equal content share a name, and have a path each.
                    which = record["name"], str(record.get("input"))
                    other = found.get(which)
                    if not other or further(record) > further(other):
                        found[which] = record
    return [found[which] for which in sorted(found)]


def further(record: Record) -> int:
    return STATUSES.index(record["status"])


def numbers(records: list[Record], of: Of) -> list[float]:
    return sorted(value for value in map(of, records) if value is not None)


def quantile(values: list[float], share: float) -> float:
    """Of sorted values, between neighbours; 0 of none."""
    if not values:
        return 0.0
    place = share * (len(values) - 1)
    low = math.floor(place)
    high = min(low + 1, len(values) - 1)
    return values[low] + (place - low) * (values[high] - values[low])


def mean(values: list[float]) -> float:
    return math.fsum(values) / len(values) if values else 0.0


def wall(record: Record) -> float:
    return record["cost"]["wall_s"]


def processor(record: Record) -> float:
    return record["cost"]["processor_s"]


def peak(record: Record) -> float:
    return record["cost"]["peak_mib"]


def percent(field: str) -> Of:
    return lambda record: None if record[field] is None else 100 * record[field]


def thousands(record: Record) -> float | None:
    return None if record["triangles"] is None else record["triangles"] / 1000


def shown(value: float) -> str:
    """Three digits, as many as anybody reads."""
    if value == 0:
        return "0"
    digits = max(0, 2 - math.floor(math.log10(abs(value))))
    text = f"{value:.{digits}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def duration(seconds: float) -> str:
    for unit, length in (("h", 3600), ("min", 60)):
        if seconds >= 1.5 * length:
            return f"{shown(seconds / length)} {unit}"
    return f"{shown(seconds)} s"
