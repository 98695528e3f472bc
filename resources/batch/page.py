# SPDX-License-Identifier: GPL-3.0-or-later
"""The summary as one page of HTML, which stands alone."""
import html
import math
from typing import Callable

from charts import histogram, histogram_of_powers
from records import Record, duration, peak, percent, processor, thousands

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
