# SPDX-License-Identifier: GPL-3.0-or-later
"""SVG drawings in Inkscape and librsvg, plots in hp2xx."""
import math
import re
import xml.etree.ElementTree

from check import Check, near, require, said_by
from lines import MILLIMETRE, closed, extent, length, match, traced

PIXEL = 25.4 / 96  # of Inkscape, mm
STROKE = 0.3  # mm, counts for the box of a line
PENS = {"cutting_line_length": '"stroke:rgb(0,0,0)', "perimeter_2d": '"stroke:rgb(255,0,0)'}
SVG = "{http://www.w3.org/2000/svg}"
NUMBER = re.compile(r"-?\d+\.?\d*")


def _outlines(garment):
    """Ids of what is cut with their points, by Python's own reader of XML; lines alone."""
    root = xml.etree.ElementTree.parse(garment.file("svg")).getroot()
    found = {}
    for path in root.find(f'{SVG}g[@id="layer-cut"]').iter(f"{SVG}path"):
        numbers = [float(word) for word in NUMBER.findall(path.get("d"))]
        found[path.get("id")] = closed(list(zip(numbers[::2], numbers[1::2])))
    return root, found


def boxes(garment):
    said = said_by("inkscape", "--query-all", garment.file("svg"))
    seen = {row.split(",")[0]: [float(word) * PIXEL for word in row.split(",")[1:]]
            for row in said.splitlines() if row.count(",") == 4}
    root, outlines = _outlines(garment)
    require(outlines, "no outlines")
    ids = [group.get("id") for group in root.iter(f"{SVG}g")]
    require(set(ids) <= set(seen), f"no {set(ids) - set(seen)}")
    worst = near(seen["check-square"][2], 100 + STROKE, 0.01, "the check square")
    for name, points in outlines.items():
        low_x, low_y, high_x, high_y = extent([points])
        half = STROKE / 2
        for value, wanted in zip(seen[name], (low_x - half, low_y - half, high_x - low_x + STROKE,
                                              high_y - low_y + STROKE)):
            worst = max(worst, near(value, wanted, 0.01, name))
    return worst


def _printed(garment, pdf):
    lengths = [length(points) for _, points in traced(pdf)]
    return max(match(lengths, garment.lengths(field), 0.01, field)
               for field in ("cutting_line_length", "perimeter_2d"))


def inkscape_prints(garment):
    pdf = garment.file("inkscape.pdf")
    said_by("inkscape", garment.file("svg"), f"--export-filename={pdf}")
    return _printed(garment, pdf)


def rsvg_prints(garment):
    pdf = garment.file("rsvg.pdf")
    said_by("rsvg-convert", "-f", "pdf", "-o", pdf, garment.file("svg"))
    return _printed(garment, pdf)


def _plotted(garment):
    """Of each pen, by its colour, its lines: hp2xx writes them in parts of a few points."""
    said = said_by("hp2xx", "-q", "-m", "svg", "-t", "-f", "-", garment.file("plt"))
    for group in said.split("<g style=")[1:]:
        colour = group[:group.find(";")]
        lines = []
        for path in re.findall(r'<path d="([^"]*)"', group):
            numbers = [float(word) / MILLIMETRE for word in NUMBER.findall(path)]
            points = list(zip(numbers[::2], numbers[1::2]))
            if lines and points and math.dist(lines[-1][-1], points[0]) < 1e-6:
                lines[-1] += points[1:]
            elif points:
                lines.append(points)
        yield colour, lines


def plot(garment):
    """Pen 1, black there, draws what is cut; pen 2, red, the seam lines."""
    lengths = {}
    for colour, lines in _plotted(garment):
        lengths.setdefault(colour, []).extend(map(length, lines))
    return max(match(lengths.get(colour, []), garment.lengths(field), 0.05, field)
               for field, colour in PENS.items())


CHECKS = [
    Check("SVG", "Inkscape", "finds the layers; boxes of all outlines, the check square", "0.01 mm",
          boxes, ("inkscape",)),
    Check("SVG", "Inkscape", "its PDF: cutting and seam lines as long as in the report", "0.01 mm",
          inkscape_prints, ("inkscape", "mutool")),
    Check("SVG", "librsvg", "its PDF: cutting and seam lines as long as in the report", "0.01 mm",
          rsvg_prints, ("rsvg-convert", "mutool")),
    Check("HPGL", "hp2xx", "cutting and seam lines by their pens as long as in the report",
          "0.05 mm", plot, ("hp2xx",)),
]
