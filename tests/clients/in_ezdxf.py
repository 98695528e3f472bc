# SPDX-License-Identifier: GPL-3.0-or-later
"""DXF files in ezdxf: its audit, and the lengths of its entities."""
import math

from check import Check, near, require, same
from garments import PROFILES
from lines import closed, length, match

EXACT, BY_KEY_POINTS = 0.01, 0.05  # mm
DENSE = {"astm": ("84", "87"), "plain": ("CUT", "SEW")}


def _document(garment, profile):
    import ezdxf
    return ezdxf.readfile(garment.file(f"{profile}.dxf"))


def _places(document):
    """Where lines stand: the blocks of the pieces, or the drawing itself."""
    blocks = [block for block in document.blocks if not block.name.startswith(("*", "$"))]
    return blocks or [document.modelspace()]


def _outlines(place, layer):
    """The closed lines of a layer as points."""
    return [closed([(v.dxf.location.x, v.dxf.location.y) for v in line.vertices])
            for line in place.query(f'POLYLINE[layer=="{layer}"]') if line.is_closed]


def audit(profile):
    def run(garment):
        document = _document(garment, profile)
        errors = document.audit().errors
        require(not errors, f"{len(errors)} errors, the first: {errors[:1]}")
        placed = [insert.dxf.name for insert in document.modelspace().query("INSERT")]
        blocks = [] if profile == "plain" else [block.name for block in _places(document)]
        require(sorted(placed) == sorted(blocks), "blocks are not placed once each")
        if profile != "plain":
            same(len(blocks), len(garment.pieces), "blocks")
    return run


def dense(profile):
    def run(garment):
        places, worst = _places(_document(garment, profile)), 0
        for layer, field in zip(DENSE[profile], ("cutting_line_length", "perimeter_2d")):
            found = [length(line) for place in places for line in _outlines(place, layer)]
            worst = max(worst, match(found, garment.lengths(field), EXACT, f"layer {layer}"))
        return worst
    return run


def _segments(line, corners):
    """Lengths between these of its points, in turn; a line without is one segment."""
    at = [k for k, point in enumerate(line[:-1])
          if any(math.dist(point, corner) < 2e-4 for corner in corners)]
    turned = line[:-1][at[0]:] + line[:at[0] + 1] if at else line
    stops = [k - at[0] for k in at] + [len(line) - 1] if at else [0, len(line) - 1]
    return [length(turned[a:b + 1]) for a, b in zip(stops, stops[1:])]


def key_points(profile):
    """Each outline by key points beside the dense one of the ASTM file, turn to turn."""
    def run(garment):
        worst = 0
        beside = {block.name: block for block in _places(_document(garment, "astm"))}
        for block in _places(_document(garment, profile)):
            corners = [(p.dxf.location.x, p.dxf.location.y)
                       for p in block.query('POINT[layer=="2"]')]
            for layer, thick in (("1", "84"), ("14", "87")):
                few, many = _outlines(block, layer), _outlines(beside[block.name], thick)
                same(len(few), len(many), f"{block.name}, outlines of layer {layer}")
                for line, dense_line in zip(few, many):
                    parts = _segments(line, corners), _segments(dense_line, corners)
                    same(len(parts[0]), len(parts[1]), f"{block.name}, segments")
                    for ours, drawn in zip(*parts):
                        worst = max(worst, near(ours, drawn, BY_KEY_POINTS,
                                                f"{block.name}, layer {layer}"))
        return worst
    return run


def _format(profile):
    return f"DXF, `{profile}`"


CHECKS = [
    *(Check(_format(profile), "ezdxf", "audit without error, a block for each piece"
            if profile != "plain" else "audit without error", "", audit(profile), python="ezdxf")
      for profile in PROFILES),
    *(Check(_format(profile), "ezdxf", "cutting and seam lines as long as in the report",
            f"{EXACT} mm", dense(profile), python="ezdxf") for profile in DENSE),
    *(Check(_format(profile), "ezdxf", "each segment by key points as long as the dense line",
            f"{BY_KEY_POINTS} mm", key_points(profile), python="ezdxf")
      for profile in ("astm", "aama")),
]
