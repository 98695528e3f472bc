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
import html
import io
import json
import math
import sys
from pathlib import Path
from typing import Any, Callable

Record = dict[str, Any]
Of = Callable[[Record], float | None]

FIELDS = [
    "name", "input", "hash", "options", "toile", "status", "code", "subject", "message", "pieces",
    "failed_pieces", "triangles", "seams", "worst_seam_mm", "strain_mean", "strain_max", "flipped",
    "crossings", "fingerprint", "doubts", "outputs",
]  # fmt: skip
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


# The page ---------------------------------------------------------------------------------------

WIDTH, HEIGHT = 440, 210
LEFT, RIGHT, BELOW, ABOVE = 44, 12, 40, 14  # margins of a chart
LEAST_POWER = -16  # of ten; what is less counts there
LEAST_POWERS, MOST_TICKS = 4, 9  # of a chart of powers
ROUNDING = 1e-6
STYLE = """
:root { color-scheme: light dark; --ink: #1d2530; --quiet: #5d6876; --line: #d9dee5;
        --ground: #f6f7f9; --card: #fff; --bar: #3d6fb6; --bad: #c2562d; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e9ee; --quiet: #9aa5b3; --line: #343c47;
        --ground: #15191f; --card: #1d232b; --bar: #6f9fe0; --bad: #e2865f; } }
body { font: 15px/1.5 system-ui, "Noto Sans", sans-serif; color: var(--ink);
       background: var(--ground); margin: 0; }
main { max-width: 960px; margin: 0 auto; padding: 32px 24px 64px; }
h1 { font-size: 26px; font-weight: 600; margin: 0 0 4px; }
h2 { font-size: 15px; font-weight: 600; margin: 0; }
.quiet, figcaption, svg text { color: var(--quiet); fill: var(--quiet); }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(130px, 1fr));
           gap: 12px; margin: 24px 0; }
.figures div, figure, section { background: var(--card); border: 1px solid var(--line);
           border-radius: 8px; }
.figures div { padding: 12px 16px; color: var(--quiet); font-size: 13px; }
.figures b { display: block; white-space: nowrap; font-size: 24px; font-weight: 600;
             line-height: 1.25; color: var(--ink); }
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(380px, 100%), 1fr));
          gap: 16px; }
figure { margin: 0; padding: 16px; min-width: 0; }
figcaption { font-size: 13px; margin-bottom: 4px; overflow-wrap: anywhere; }
figcaption b { display: inline-block; max-width: 100%; font-weight: inherit; }
svg { display: block; width: 100%; height: auto; }
svg text { font-size: 11px; font-family: inherit; }
section { margin-top: 16px; padding: 16px; overflow-x: auto; }
table { border-collapse: collapse; width: 100%; margin-top: 8px; font-size: 13px; }
th { text-align: left; font-weight: 600; color: var(--quiet); }
th, td { padding: 5px 12px 5px 0; border-bottom: 1px solid var(--line); vertical-align: top; }
table.narrow { width: auto; min-width: 40%; }
tr:last-child td { border-bottom: 0; }
td:first-child { white-space: nowrap; }
.count { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.axis { stroke: var(--line); } .bar { fill: var(--bar); } .bad { fill: var(--bad); }
"""


def nice_step(span: float, parts: int) -> float:
    """1, 2 or 5 times a power of ten, so that `span` has at most so many."""
    rough = span / parts
    power = 10 ** math.floor(math.log10(rough))
    return next(power * factor for factor in (1, 2, 5, 10) if power * factor >= rough * 0.999999)


def chart(
    title: str,
    caption: str,
    bars: list[tuple[int, str]],
    ticks: list[tuple[float, str]],
    axis: str,
    last_is_open: bool = False,
) -> str:
    """Bars beside each other. A bar is a height and what it counts, a tick a place and its text."""
    most = max(height for height, _ in bars)
    across = (WIDTH - LEFT - RIGHT) / len(bars)
    up = (HEIGHT - BELOW - ABOVE) / most
    ground = HEIGHT - BELOW
    parts = [f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{html.escape(title)}">']
    for height in range(0, most + 1, max(1, round(nice_step(most, 4)))):
        y = ground - height * up
        parts.append(
            f'<line class="axis" x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{y:.1f}" y2="{y:.1f}"/>'
            f'<text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{height}</text>'
        )
    for k, (height, label) in enumerate(bars):
        kind = "bad" if last_is_open and k == len(bars) - 1 else "bar"
        parts.append(
            f'<rect class="{kind}" x="{LEFT + k * across + 1:.1f}" width="{across - 2:.1f}" '
            f'y="{ground - height * up:.1f}" height="{height * up:.1f}" rx="1">'
            f"<title>{html.escape(label)}: {height}</title></rect>"
        )
    for place, text in ticks:
        parts.append(
            f'<text x="{LEFT + place * across:.1f}" y="{ground + 16}" text-anchor="middle">{text}'
            "</text>"
        )
    parts.append(
        f'<text x="{(LEFT + WIDTH - RIGHT) / 2:.0f}" y="{HEIGHT - 6}" text-anchor="middle">{axis}'
        "</text></svg>"
    )
    return (
        f"<figure><h2>{html.escape(title)}</h2><figcaption>{caption}</figcaption>{''.join(parts)}"
        "</figure>"
    )


def largest(records: list[Record], of: Of) -> str:
    """The name of the garment that one would want to look at."""
    having = [record for record in records if of(record) is not None]
    return f"<b>{html.escape(max(having, key=of)['name'])}</b>"


def histogram(title: str, unit: str, records: list[Record], of: Of) -> str:
    """Bars of even width up to the value that a hundredth exceeds; the rest is one bar more."""
    values = numbers(records, of)
    if not values:
        return ""
    top = quantile(values, 0.99) or values[-1] or 1.0
    step = nice_step(top, 24)
    count = max(1, math.ceil(top / step - 1e-9))
    bins = [0] * (count + 1)
    for value in values:
        bins[min(count, int(value / step))] += 1
    is_open = bins[count] > 0
    bars = [(n, f"{shown(k * step)} to {shown((k + 1) * step)} {unit}") for k, n in enumerate(bins)]
    bars[count] = (bins[count], f"{shown(count * step)} {unit} and more")
    ticks = [(k, shown(k * step)) for k in range(0, count + 1, max(1, math.ceil(count / 6)))]
    axis = f"{unit}; the last bar is all beyond" if is_open else unit
    half, most = (shown(quantile(values, share)) for share in (0.5, 0.9))
    caption = (
        f"half below {half} {unit}, nine tenths below {most} {unit}, "
        f"largest {shown(values[-1])} {unit}: {largest(records, of)}"
    )
    return chart(title, caption, bars if is_open else bars[:count], ticks, axis, is_open)


def histogram_of_powers(title: str, unit: str, records: list[Record], of: Of) -> str:
    """A bar for each power of ten, for what is rounding here and a fault there."""
    values = numbers(records, of)
    if not values:
        return ""
    powers = [LEAST_POWER if v < 10**LEAST_POWER else math.floor(math.log10(v)) for v in values]
    low = min(powers)
    top = max(*powers, low + LEAST_POWERS - 1)
    bars = []
    for power in range(low, top + 1):
        label = f"below 10^{power + 1} {unit}"
        label = label if power == LEAST_POWER else f"10^{power} and more, {label}"
        bars.append((powers.count(power), label))
    ticks = [
        (power - low, f'10<tspan dy="-4" font-size="8">{power}</tspan>')
        for power in range(low + 1, top + 1, 1 if top - low < MOST_TICKS else 2)
    ]
    exact = sum(value < ROUNDING for value in values)
    caption = (
        f"{exact} of {len(values)} below a millionth {unit}, "
        f"largest {values[-1]:.2g} {unit}: {largest(records, of)}"
    )
    return chart(title, caption, bars, ticks, unit)


def counted(records: list[Record], of: Callable[[Record], list[str]]) -> list[tuple[str, int]]:
    counts: dict[str, int] = {}
    for record in records:
        for word in of(record):
            counts[word] = counts.get(word, 0) + 1
    return sorted(counts.items(), key=lambda item: (-item[1], item[0]))


def failures(records: list[Record]) -> str:
    bad = [record for record in records if record["error"]]
    if not bad:
        return "<section><h2>Failures</h2><p class=quiet>None.</p></section>"
    rows = []
    for code, count in counted(bad, lambda record: [record["error"]["code"]]):
        first = next(record for record in bad if record["error"]["code"] == code)
        rows.append(
            f"<tr><td>{html.escape(code)}</td><td class=count>{count}</td>"
            f"<td class=count>{100 * count / len(records):.1f} %</td>"
            f"<td>{html.escape(first['name'])}</td>"
            f"<td>{html.escape(first['error']['message'])}</td></tr>"
        )
    return (
        "<section><h2>Failures by code</h2><table><tr><th>Code</th><th class=count>Garments</th>"
        "<th class=count>Share</th><th>The first</th><th>What it says</th></tr>"
        f"{''.join(rows)}</table></section>"
    )


def doubts(records: list[Record]) -> str:
    rows = "".join(
        f"<tr><td>{html.escape(word)}</td><td class=count>{count}</td></tr>"
        for word, count in counted(records, lambda record: sorted(set(record["doubts"])))
    )
    head = "<tr><th>Doubt</th><th class=count>Garments</th></tr>"
    table = f"<table class=narrow>{head}{rows}</table>"
    return f"<section><h2>Doubts</h2>{table}</section>" if rows else ""


def page(records: list[Record]) -> str:
    status = dict(counted(records, lambda record: [record["status"]]))
    flat = [record for record in records if record["status"] != "failed"]
    versions = ", ".join(sorted({record["toile"] for record in records})) or "–"
    figures = [
        (str(len(records)), "garments"),
        (str(status.get("done", 0)), "done"),
        (str(status.get("some-failed", 0)), "failed in part"),
        (str(status.get("failed", 0)), "failed"),
        (str(sum(record["pieces"] or 0 for record in flat)), "pieces"),
        (duration(math.fsum(map(processor, records))), "processor time"),
    ]
    charts = [
        histogram("Mean strain", "%", flat, percent("strain_mean")),
        histogram("Largest strain", "%", flat, percent("strain_max")),
        histogram_of_powers("Worst seam error", "mm", flat, lambda r: r["worst_seam_mm"]),
        histogram("Triangles", "thousand", flat, thousands),
        histogram("Processor time", "s", records, processor),
        histogram("Peak memory", "MiB", records, peak),
    ]
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<title>Batch of garments</title><meta name="viewport" content="width=device-width">'
        f"<style>{STYLE}</style></head><body><main><h1>Batch of garments</h1>"
        f'<p class="quiet">Flattened by Toile {html.escape(versions)}.</p><div class="figures">'
        + "".join(f"<div><b>{value}</b>{word}</div>" for value, word in figures)
        + '</div><div class="charts">'
        + "".join(charts)
        + f"</div>{failures(records)}{doubts(records)}</main></body></html>\n"
    )


# The plan ---------------------------------------------------------------------------------------


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
