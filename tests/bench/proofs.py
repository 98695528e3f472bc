#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sews patterns of garments back together and writes the table of docs/prove.md.

    tests/bench/proofs.py build/release/app/toile ../shared/data/garments [NAME ...]

Each garment by the designer's own panels, where its file carries them, by some methods, and by the
panels, or else the pattern of the first method, at other scales, where what fits comes out worse. Without
names: garments of the folder and our own samples. With names it is a try: only these, of either, and
the table is only shown. `--limit` is of one proof; what takes longer is "-" and said.
"""
import argparse
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
GARMENTS = ["tee_sim", "dress", "polo", "longsleeve", "tshirt", "skirt_clo"]
SAMPLES = ["tshirt", "bodice", "cap", "skirt", "trousers"]
METHODS = ["isometric", "curvature", "lscm", "wang2005"]
SCALES = [0.98, 1.02]
PAGE = ROOT / "docs" / "prove.md"
BEGIN, END = "<!-- written by tests/bench/proofs.py -->\n", "<!-- until here -->\n"


def proved(program, limit, garment, *options):
    """The proof, or none where the pattern cannot be sewn."""
    try:
        run = subprocess.run([program, "prove", *garment, "--json", *options], check=False,
                             timeout=limit, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    except subprocess.TimeoutExpired:
        print(f"{garment[0]} {' '.join(options)}: more than {limit:g} s", file=sys.stderr)
        return None
    if run.returncode not in (0, 1) or not run.stdout:
        said = run.stderr.strip().splitlines() or [f"status {run.returncode}"]
        print(f"{garment[0]} {' '.join(options)}: {said[-1]}", file=sys.stderr)
        return None
    return json.loads(run.stdout)


def cell(proof):
    """Mean gap and what a twentieth exceeds; a star where it has not settled, and how many of the
    pieces it is of where it is not of all."""
    if proof is None:
        return "-"
    gap = proof["gap_mm"]
    if gap["mean"] is None or gap["p95"] is None:
        return "-"
    sewn, pieces = sum(piece["sewn"] for piece in proof["pieces"]), len(proof["pieces"])
    return (f"{gap['mean']:.2f} / {gap['p95']:.1f}" + ("" if proof["settled"] else " *") +
            ("" if sewn == pieces else f", {sewn} of {pieces}"))


def found(folder, names):
    """Names to show, with the words that read the file. A sample gives way to a garment of its name."""
    samples = ROOT / "resources" / "samples"
    garments = [(name, [str(folder / f"{name}.obj")]) for name in names or GARMENTS]
    own = [(f"sample {name}", [str(samples / f"{name}.obj"), "--unit", "mm", "--up", "y"])
           for name in names or SAMPLES]
    there = [row for row in garments if pathlib.Path(row[1][0]).is_file()]
    known = {name for name, _ in there}
    if names:
        own = [row for row in own if row[0].removeprefix("sample ") not in known]
    own = [row for row in own if pathlib.Path(row[1][0]).is_file()]
    known |= {row[0].removeprefix("sample ") for row in own} if names else set()
    for name, _ in garments:
        if name not in known:
            print(f"{name}: there is no such garment", file=sys.stderr)
    return there + own


def main():
    options = argparse.ArgumentParser(description=__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("garments", type=pathlib.Path)
    options.add_argument("names", nargs="*", help="a try")
    options.add_argument("--limit", type=float, default=600, help="s, of one proof")
    typed = options.parse_args()
    heads = ["Garment", "Triangles", "Designer", *METHODS, *(f"x {s:g}" for s in SCALES), "s"]
    lines = ["| " + " | ".join(heads) + " |", "|---" + "|--:" * (len(heads) - 1) + "|"]
    print("\n".join(lines), flush=True)
    for name, garment in found(typed.garments, typed.names):
        def prove(*words, of=garment):
            return proved(typed.program, typed.limit, of, *words)
        designer = prove("--reference", "uv")
        proofs = [designer, *(prove("--method", method) for method in METHODS)]
        scaled = ["--reference", "uv"] if designer else ["--method", METHODS[0]]
        proofs += [prove(*scaled, "--scale", str(scale)) for scale in SCALES]
        known = [proof for proof in proofs if proof]
        longest = max((proof["seconds"] for proof in known), default=0)
        size = str(known[0]["triangles"]) if known else "-"
        lines.append("| " + " | ".join([name, size, *map(cell, proofs), f"{longest:.1f}"]) + " |")
        print(lines[-1], flush=True)
    if typed.names:
        return
    page = PAGE.read_text(encoding="utf-8")
    begin, end = page.index(BEGIN) + len(BEGIN), page.index(END)
    PAGE.write_text(page[:begin] + "\n".join(lines) + "\n" + page[end:], encoding="utf-8")


if __name__ == "__main__":
    main()
