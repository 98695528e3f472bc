# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines as lists of points, and lengths that are to be among others."""
import math
import xml.etree.ElementTree

from check import Fault, said_by

MILLIMETRE = 72 / 25.4  # points
STEPS = 64  # of a Bezier curve: a quarter of a circle loses 25 millionths of its length


def length(points):
    return math.fsum(map(math.dist, points, points[1:]))


def closed(points):
    """Its points with the first once more at the end, where it is not there."""
    return points if math.dist(points[0], points[-1]) < 1e-6 else [*points, points[0]]


def extent(lines):
    """Least and largest x and y over all points."""
    xs = [point[0] for line in lines for point in line]
    ys = [point[1] for line in lines for point in line]
    return min(xs), min(ys), max(xs), max(ys)


def match(found, wanted, within, what):
    """The largest difference; a Fault where a wanted length has no found one of its own."""
    left, worst = sorted(found), 0
    for value in sorted(wanted):
        best = min(left, key=lambda one: abs(one - value), default=math.inf)
        if abs(best - value) > within:
            raise Fault(f"{what}: no line of {value:.4f} mm within {within} mm, "
                        f"the nearest has {best:.4f}")
        left.remove(best)
        worst = max(worst, abs(best - value))
    return worst


def bezier(a, b, c, d):
    """Points of a cubic curve but its first."""
    for k in range(1, STEPS + 1):
        t = k / STEPS
        weights = (1 - t)**3, 3 * t * (1 - t)**2, 3 * t * t * (1 - t), t**3
        yield tuple(sum(w * p[axis] for w, p in zip(weights, (a, b, c, d))) for axis in (0, 1))


def _subpaths(stroke):
    """The lines of one stroke that mutool traced, in mm on the paper."""
    m = [float(word) for word in stroke.get("transform").split()]

    def place(x, y):
        return tuple((m[axis] * float(x) + m[2 + axis] * float(y) + m[4 + axis]) / MILLIMETRE
                     for axis in (0, 1))

    line = []
    for step in stroke:
        if step.tag == "moveto":
            if len(line) > 1:
                yield line
            line = [place(step.get("x"), step.get("y"))]
        elif step.tag == "lineto":
            line.append(place(step.get("x"), step.get("y")))
        elif step.tag == "curveto":
            corners = [place(step.get(f"x{k}"), step.get(f"y{k}")) for k in (1, 2, 3)]
            line += bezier(line[-1], *corners)
        elif step.tag == "closepath":
            line.append(line[0])
    if len(line) > 1:
        yield line


def traced(pdf, page="1"):
    """Of each line that is stroked on a page its layers, outermost first, and its points in mm."""
    trace = xml.etree.ElementTree.fromstring(said_by("mutool", "trace", pdf, page))
    layers = []
    for element in trace.iter():
        if element.tag == "layer":
            layers.append(element.get("name"))
        elif element.tag == "end_layer":
            layers.pop()
        elif element.tag == "stroke_path":
            for points in _subpaths(element):
                yield tuple(layers), points
