# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of docs/exports.md that says what was checked in which client."""
import beside_clo
from garments import ROOT, SHARED

DOCS = ROOT / "docs" / "exports.md"
BEGIN = "<!-- table: clients, written by tests/clients/run.py -->\n"
END = "<!-- end of table -->\n"
BETWEEN = """
What is on which layer in the DXF of `skirt_clo` that CLO wrote and in ours:

"""
OPTIONAL = {"usdchecker"}  # not among Debian's packages; it has no row


def table(results):
    """A row per check, those of a format together."""
    rows = ["| Format | Client | What is checked | Within | Result |", "|---|---|---|--:|---|"]
    formats = [check.format for check in results]
    for check in sorted(results, key=lambda check: formats.index(check.format)):
        words = list(results[check].values())
        if OPTIONAL.intersection(check.needs):
            continue
        if check.garment:
            result = f"{check.garment} passed"
        else:
            result = f"{words.count('passed')} of {len(words)} passed"
        cells = check.format, check.client, check.what, check.within, result
        rows.append(f"| {' | '.join(cells)} |")
    return "\n".join(rows) + "\n"


def settle(results, found, skipped, given):
    """Writes the table, or says whether it is stale; the status to end with."""
    if given.only or not SHARED.is_dir() or skipped - OPTIONAL:
        print("The table of docs/exports.md is not compared: not everything was checked")
        return 0
    text = DOCS.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    end = rest.index(END)
    skirt = next(garment for garment in found if garment.name == beside_clo.GARMENT)
    new = before + BEGIN + table(results) + BETWEEN + beside_clo.table(skirt) + rest[end:]
    if new == text:
        return 0
    if given.write_docs:
        DOCS.write_text(new, encoding="utf-8")
        print("wrote the table of docs/exports.md")
        return 0
    print("The table of docs/exports.md is stale: tests/clients/run.py --write-docs")
    return 1
