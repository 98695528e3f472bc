# SPDX-License-Identifier: GPL-3.0-or-later
"""GarmentCode files beside those of that program: the same structure, stitches that sew."""
import collections
import json
import math

from check import Check, near, require
from garments import SHARED
from lines import bezier, length, match

THEIRS = tuple(SHARED / f"{name}.specification.json"
               for name in ("garments/tee_sim", "patterns/gc_shirt", "patterns/gc_hoody"))
NAMED = {"panels", "parameters"}  # objects whose keys are names
WITHIN = 0.02  # mm


def _read(path):
    return json.loads(path.read_text(encoding="utf-8"))


def _structure(value, at=""):
    """Every place of a document, without indices and names, with the type of what is there."""
    if isinstance(value, dict):
        yield at, "object"
        for key, inner in value.items():
            named = at.rpartition("/")[2] in NAMED
            yield from _structure(inner, f"{at}/*" if named else f"{at}/{key}")
    elif isinstance(value, list):
        yield at, "list"
        for inner in value:
            yield from _structure(inner, f"{at}/-")
    else:
        yield at, "number" if type(value) in (int, float) else type(value).__name__


def structure(garment):
    ours, theirs = _read(garment.file("specification.json")), [_read(path) for path in THEIRS]
    places = set(_structure(ours))
    known = [set(_structure(document)) for document in theirs]
    require(places <= set.union(*known), f"they have no {sorted(places - set.union(*known))}")
    # A design's parameters and a panel's curves are what a pattern may do without.
    lacking = {place for place in set.intersection(*known) - places
               if "/parameter" not in place[0] and "curvature" not in place[0]}
    require(not lacking, f"no {sorted(lacking)}")
    always = set.intersection(*(set(panel) for document in theirs
                                for panel in document["pattern"]["panels"].values()))
    for name, panel in ours["pattern"]["panels"].items():
        require(always <= set(panel), f"{name} has no {sorted(always - set(panel))}")


def _edge(vertices, edge):
    """Points of an edge, its controls relative to its chord."""
    a, b = (vertices[k] for k in edge["endpoints"])
    if "curvature" not in edge:
        return [a, b]
    require(edge["curvature"]["type"] == "cubic", "an edge that is no cubic curve")
    along = b[0] - a[0], b[1] - a[1]
    controls = [(a[0] + x * along[0] - y * along[1], a[1] + x * along[1] + y * along[0])
                for x, y in edge["curvature"]["params"]]
    return [a, *bezier(a, *controls, b)]


def _lengths(document):
    """Of each panel the lengths of its edges, mm; each edge begins where the last one ends."""
    unit = 1000 / document["properties"]["units_in_meter"]
    for name, panel in document["pattern"]["panels"].items():
        ends = [edge["endpoints"] for edge in panel["edges"]]
        require(all(a[1] == b[0] for a, b in zip(ends, ends[1:] + ends[:1])),
                f"{name}: the edges are no loop")
        yield name, [unit * length(_edge(panel["vertices"], edge)) for edge in panel["edges"]]


def outlines(garment):
    document = _read(garment.file("specification.json"))
    found = dict(_lengths(document))
    require(set(document["pattern"]["panel_order"]) == set(found), "panels are not in order")
    return match([math.fsum(edges) for edges in found.values()], garment.lengths("perimeter_2d"),
                 WITHIN, "outline")


def stitches(garment):
    """One to one, no edge twice, both as long: none of these garments is sewn with ease."""
    document = _read(garment.file("specification.json"))
    lengths = dict(_lengths(document))
    sewn = document["pattern"]["stitches"]
    times = collections.Counter((side["panel"], side["edge"]) for pair in sewn for side in pair)
    require(times and max(times.values()) == 1, f"edges in two stitches: {times.most_common(3)}")
    worst = 0
    for pair in sewn:
        require(len(pair) == 2, "a stitch of more than two edges")
        one, other = (lengths[side["panel"]][side["edge"]] for side in pair)
        worst = max(worst, near(one, other, WITHIN, f"stitch {pair}"))
    return worst


CHECKS = [
    Check("GarmentCode", "its own files", "every key and type is theirs, none is missing", "",
          structure, beside=THEIRS),
    Check("GarmentCode", "its own rules", "panels are loops, as long as in the report",
          f"{WITHIN} mm", outlines),
    Check("GarmentCode", "its own rules", "stitches one to one, both edges as long",
          f"{WITHIN} mm", stitches),
]
