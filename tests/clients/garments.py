# SPDX-License-Identifier: GPL-3.0-or-later
"""The garments whose files are checked, and these files."""
import itertools
import json
import os
import pathlib

from check import Fault, require, said_by

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHARED = pathlib.Path(os.environ.get("TOILE_SHARED_DATA", ROOT.parent / "shared" / "data"))
SAMPLES = ROOT / "resources" / "samples"
PROFILES = ("astm", "aama", "plain")
PAPERS = ("a4", "letter", "tile", "a0", "arch-d", "arch-e", "roll-610", "roll-841", "roll-914",
          "projector")
ONCE = ("json", "svg", "plt", "obj", "glb", "usda", "specification.json")


class Garment:
    def __init__(self, name, source, unit, work):
        self.name, self.source, self.unit = name, source, unit
        self.folder = work / name

    def file(self, kind):
        """The path of "svg", "astm.dxf", "a4.pdf" and so on."""
        return self.folder / f"{self.name}.{kind}"

    def write(self, toile):
        """Writes everything."""
        self.folder.mkdir(parents=True, exist_ok=True)
        kinds = list(ONCE)
        for profile, paper in itertools.zip_longest(PROFILES, PAPERS):
            kinds.append(f"{paper}.pdf")
            options = ["--paper", paper]
            if profile:
                kinds.append(f"{profile}.dxf")
                options += ["--dxf-profile", profile]
            outputs = [word for kind in kinds for word in ("-o", self.file(kind))]
            said_by(toile, "flatten", self.source, "--unit", self.unit, "--pattern", *outputs,
                    *options)
            kinds = []
        self.report = json.loads(self.file("json").read_text(encoding="utf-8"))
        require(all(piece["status"] == "flat" for piece in self.pieces),
                f"{self.name} does not lie flat")

    @property
    def pieces(self):
        return self.report["pieces"]

    def lengths(self, field):
        """`perimeter_2d` (the seam line) or `cutting_line_length` of all pieces, mm."""
        return [piece[field] for piece in self.pieces]


def garments(work):
    """Those that are there: our own samples always, the others where the shared data stand."""
    own = [Garment(name, SAMPLES / f"{name}.obj", "mm", work) for name in ("tshirt", "skirt")]
    shared = [Garment(name, SHARED / "garments" / f"{name}.obj", unit, work)
              for name, unit in (("tee_sim", "cm"), ("polo", "cm"), ("dress", "cm"),
                                 ("skirt_clo", "mm"))]
    if not SHARED.is_dir():
        return own
    for garment in shared:
        if not garment.source.is_file():
            raise Fault(f"{garment.source} is missing")
    return shared + own
