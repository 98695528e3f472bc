# SPDX-License-Identifier: GPL-3.0-or-later
"""DXF files in LibreCAD, printed at 1:20 on A4."""
from check import Check, near, require, said_by
from garments import PROFILES
from lines import extent, length, traced

TWENTIETH = 0.05
LETTER = 0.18  # mm on paper: no stroke of the letters beside the pieces is longer


def prints(profile):
    def run(garment):
        import ezdxf
        import ezdxf.bbox
        import ezdxf.disassemble
        layers, longer = (("CUT", "CHECK"), 0) if profile == "plain" else (("1",), LETTER)
        file = garment.file(f"{profile}.dxf")
        said_by("librecad", "dxf2pdf", "-s", TWENTIETH, "-c", file, folder=garment.folder)
        strokes = [points for _, points in traced(file.with_suffix(".pdf"))]
        found = extent([points for points in strokes if length(points) > longer])
        document = ezdxf.readfile(file)
        lines = [line for line in ezdxf.disassemble.recursive_decompose(document.modelspace())
                 if line.dxftype() == "POLYLINE" and line.dxf.layer in layers]
        box = ezdxf.bbox.extents(lines)
        require(box.has_data, "nothing drawn")
        wide, high = found[2] - found[0], found[3] - found[1]
        return max(near(wide / TWENTIETH, box.size.x, 1, "width"),
                   near(high / TWENTIETH, box.size.y, 1, "height"))
    return run


CHECKS = [Check(f"DXF, `{profile}`", "LibreCAD", "prints it at 1:20, the extents there", "1 mm",
                prints(profile), ("librecad", "mutool"), "ezdxf") for profile in PROFILES]
