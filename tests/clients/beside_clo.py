# SPDX-License-Identifier: GPL-3.0-or-later
"""Our DXF of a skirt beside the one that CLO itself wrote of its pattern: layers and entities."""
from check import Check, require
from garments import SHARED

GARMENT = "skirt_clo"
THEIRS = SHARED / "patterns" / f"{GARMENT}.dxf"
SAID = {"POLYLINE": "lines", "LINE": "lines of two points", "POINT": "points", "TEXT": "text",
        "INSERT": "inserts"}


def _kinds(path):
    """Kinds of entities by layer."""
    import ezdxf
    document = ezdxf.readfile(path)
    blocks = [block for block in document.blocks if not block.name.startswith(("*", "$"))]
    kinds = {}
    for place in (document.modelspace(), *blocks):
        for entity in place:
            kinds.setdefault(entity.dxf.layer, set()).add(entity.dxftype())
    inserted = sorted(insert.dxf.name for insert in document.modelspace().query("INSERT"))
    require(inserted == sorted(block.name for block in blocks), "blocks are not placed once each")
    closed = [[line.is_closed for line in block.query('POLYLINE[layer=="1"]')] for block in blocks]
    require(all(lines == [True] for lines in closed), "not one closed outline a block")
    return kinds


def same_structure(garment):
    theirs, ours = _kinds(THEIRS), _kinds(garment.file("astm.dxf"))
    for layer, kinds in theirs.items():
        lacking = kinds - ours.get(layer, set())
        require(not lacking, f"layer {layer} has no {sorted(lacking)}")


def table(garment):
    """What is on which layer, in both files."""
    theirs, ours = _kinds(THEIRS), _kinds(garment.file("astm.dxf"))
    rows = ["| Layer | In CLO's file | In ours |", "|--:|---|---|"]
    for layer in sorted(theirs.keys() | ours.keys(), key=int):
        cells = (", ".join(words for kind, words in SAID.items() if kind in file.get(layer, ()))
                 for file in (theirs, ours))
        rows.append(f"| {layer} | {' | '.join(cells)} |")
    return "\n".join(rows) + "\n"


CHECKS = [Check("DXF, `astm`", "CLO's own DXF", "blocks, outlines and each kind of entity by layer",
                "", same_structure, python="ezdxf", beside=(THEIRS,), garment=GARMENT)]
