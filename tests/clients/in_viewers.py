# SPDX-License-Identifier: GPL-3.0-or-later
"""PDF files in qpdf, MuPDF and Poppler."""
import re

from check import Check, Fault, near, require, said_by
from garments import PAPERS
from lines import MILLIMETRE, length, match, traced

LAYERS = {"cut", "seam line", "notches", "marks", "grain", "labels", "check"}
OF_PAPER = {"a4": {"pages"}, "letter": {"pages"}, "tile": {"pages"}, "projector": {"grid"}}
PIXELS = 10  # a mm, at 254 dpi
WORD = re.compile(r'<word xMin="([\d.]+)" yMin="([\d.]+)" xMax="([\d.]+)" yMax="([\d.]+)">'
                  r"(.*?)</word>")


def sound(garment):
    for paper in PAPERS:
        said = said_by("qpdf", "--check", garment.file(f"{paper}.pdf"))
        require("No syntax or stream encoding errors" in said and "WARNING" not in said,
                f"{paper}: {said.strip()[-200:]}")


def layers(garment):
    for paper in PAPERS:
        said = said_by("mutool", "show", garment.file(f"{paper}.pdf"), "grep")
        names = re.findall(r"<</Name\((.*?)\)/Type/OCG>>", said)
        lacking = (LAYERS | OF_PAPER.get(paper, set())) - set(names)
        require(not lacking, f"{paper}: no layer {', '.join(sorted(lacking))} in {names}")


def outlines(garment):
    """On the projector's one page; the other papers divide the pattern."""
    found = {}
    for inside, points in traced(garment.file("projector.pdf")):
        found.setdefault(inside[:1], []).append(length(points))
    return max(match(found.get((layer,), []), garment.lengths(field), 0.02, layer)
               for layer, field in (("cut", "cutting_line_length"), ("seam line", "perimeter_2d")))


def _square_middle(file):
    """Where the words "50 mm" of the square stand on the first page, in pixels."""
    words = WORD.findall(said_by("pdftotext", "-l", "1", "-bbox", file, "-"))
    for first, second in zip(words, words[1:]):
        if (first[4], second[4]) == ("50", "mm"):
            ends = float(first[0]), float(second[2]), float(first[1]), float(first[3])
            x, y = (ends[0] + ends[1]) / 2, (ends[2] + ends[3]) / 2
            return [round(value / MILLIMETRE * PIXELS) for value in (x, y)]
    raise Fault("no words 50 mm on the first page")


def _dark_runs(pixels):
    """The middles of the stretches of dark pixels in a row."""
    dark = [value < 160 for value in pixels]
    starts = [k for k, now in enumerate(dark) if now and not dark[k - 1:k] == [True]]
    ends = [k for k, now in enumerate(dark) if now and not dark[k + 1:k + 2] == [True]]
    return [(a + b) / 2 for a, b in zip(starts, ends)]


def square(garment):
    """From the middle of one line to that of the other, across and down, beside the words."""
    margin, worst = 35 * PIXELS, 0
    for paper in PAPERS:
        file = garment.file(f"{paper}.pdf")
        x, y = _square_middle(file)
        picture = garment.file("square")
        said_by("pdftoppm", "-r", 25.4 * PIXELS, "-gray", "-f", 1, "-l", 1, "-x", x - margin, "-y",
                y - margin, "-W", 2 * margin, "-H", 2 * margin, "-singlefile", file, picture)
        head, size, depth, gray = garment.file("square.pgm").read_bytes().split(b"\n", 3)
        width, height = map(int, size.split())
        require((head, depth) == (b"P5", b"255"), "no picture in gray")
        beside = 15 * PIXELS
        for line in (gray[(height // 2 + beside) * width:][:width],
                     gray[width // 2 + beside::width]):
            runs = _dark_runs(line)
            sides = [b - a for a, b in zip(runs, runs[1:])]
            side = min(sides, key=lambda side: abs(side - 50 * PIXELS), default=0)
            worst = max(worst, near(side / PIXELS, 50, 0.1, f"{paper}, the square"))
    return worst


def names(garment):
    for paper in PAPERS:
        said = said_by("pdftotext", "-enc", "UTF-8", garment.file(f"{paper}.pdf"), "-")
        for piece in garment.pieces:
            require(piece["name"] in said, f"{paper}: no text {piece['name']}")


CHECKS = [
    Check("PDF, all papers", "qpdf", "`--check` finds nothing", "", sound, ("qpdf",)),
    Check("PDF, all papers", "MuPDF", "lists the layers", "", layers, ("mutool",)),
    Check("PDF, all papers", "Poppler", "the square of 50 mm in pixels at 254 dpi", "0.1 mm",
          square, ("pdftoppm", "pdftotext")),
    Check("PDF, all papers", "Poppler", "finds the names of the pieces as text", "", names,
          ("pdftotext",)),
    Check("PDF, projector", "MuPDF", "cutting and seam lines as long as in the report", "0.02 mm",
          outlines, ("mutool",)),
]
