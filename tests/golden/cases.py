# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases of the golden values: which commands run on which small garments.

The files that a command names are samples, meshes of meshes.py, files in `input`, or what an earlier
command of the same case wrote. Keep cases small: the values of all of them must stay below 2 MB.
"""

METHODS = "isometric curvature wang2005 stretch natural lscm abf convex".split()
LENGTH_KEEPING = "curvature wang2005 stretch convex".split()
ONE_WAY = ["--one-way", "--threads", "1"]
MM = ["--unit", "mm"]
PRESETS_OF_DXF = "clo accumark optitex lectra illustrator laser".split()
PAPERS = "a4 letter tile a0 arch-d arch-e roll-610 roll-841 roll-914 projector".split()
PRESETS_OF_SVG = "inkscape illustrator silhouette laser cricut".split()

# Words of options of `toile flatten` that no case uses, with the reason.
NOT_COVERED = {
    "--unit": ["dm", "m", "LENGTH"],  # read by the same code as cm and in
}


class Case:
    """@param tolerance  replaces the default; give the reason in a comment
    @param needs  an ending that the program may have been built without
    @param summary  compare DXF files by the lengths and boxes of their lines"""

    def __init__(self, name, *commands, tolerance=None, needs=None, stdin=None, summary=False):
        self.name, self.commands = name, [list(words) for words in commands]
        self.tolerance, self.needs, self.stdin, self.summary = tolerance, needs, stdin, summary


def flatten(mesh, *words):
    return ["flatten", mesh, *MM, *words]


def methods_of(mesh, methods):
    return [flatten(mesh, "--method", method, "-o", f"{method}.obj", "-o", f"{method}.json")
            for method in methods]


SESSION = """\
{"id":1,"do":"load","args":["bent-tshirt.obj","--unit","mm"]}
{"id":2,"do":"flatten","settle":true}
{"id":3,"do":"query","what":["seams","outline","flat","strain"],"pieces":["neckband"]}
{"id":4,"do":"edit","seams":{"version":1,"cuts":[{"name":"centre back","points":[[-16.7,800,-144.9],[10.1,1459.8,-55.8]]}]}}
{"id":5,"do":"flatten","settle":true}
{"id":6,"do":"query","what":["report"]}
{"id":7,"do":"edit","args":["--unit","mm","--method","lcsm"]}
{"id":8,"do":"export","args":["-o","served.svg","-o","served.csv"]}
{"id":9,"do":"query","what":["sheet","vertices","triangles"],"pieces":["neckband"]}
{"id":10,"do":"quit"}
"""

CASES = [
    # Flattening
    # Not by isometric, nor with a free outline: the cube's symmetry leaves several solutions, or several largest
    # errors, and rounding would choose.
    Case("methods_of_the_cube", *methods_of("cube-h.obj", LENGTH_KEEPING),
         ["compare", "cube-h.obj", *MM, "--methods", ",".join(LENGTH_KEEPING), "--json"]),
    Case("methods_of_a_bump", *methods_of("bump.obj", METHODS), ["compare", "bump.obj", *MM],
         ["compare", "bump.obj", *MM, "--json"], ["compare", "bump.obj", *MM, "--markdown", "--per-piece"]),
    Case("options_of_methods",
         *[flatten("bump.obj", "--method", method, *words, "-o", f"{number}.obj", "-o", f"{number}.json")
           for number, (method, *words) in enumerate([
               ("wang2005", "--boundary-solver", "newton"), ("wang2005", "--boundary-solver", "slcp"),
               ("curvature", "--boundary-solver", "newton"), ("curvature", "--boundary-solver", "slcp"),
               ("stretch", "--stretch-outline", "circle"),
               ("stretch", "--stretch-outline", "curvature", "--boundary-solver", "newton"),
               ("stretch", "--stretch-outline", "curvature", "--boundary-solver", "slcp"),
               ("natural", "--free-boundary", "pinned"), ("natural", "--free-boundary", "spectral"),
               ("wang2005", "--authalic", "0.5"), ("curvature", "--authalic", "1"),
               ("isometric", "--quality", "draft"), ("isometric", "--quality", "standard"),
               ("isometric", "--quality", "fine")])]),
    Case("methods_of_the_cap", *methods_of("bent-cap.obj", METHODS), ["compare", "bent-cap.obj", *MM, "--json"]),
    Case("methods_of_the_bodice",
         *[flatten("bent-bodice.obj", "--method", method, "--ledger", "-o", f"{method}.json")
           for method in METHODS]),
    Case("flat_samples",
         *[flatten(f"bent-{name}.obj", "--ledger", "-o", f"{name}.svg", "-o", f"{name}.json")
           for name in ("tshirt", "bodice", "trousers", "cap", "skirt")]),
    Case("seams_of_the_tshirt",
         *[flatten("bent-tshirt.obj", "--seams", "tshirt.seams.json", "--method", method, "--ledger",
                   "-o", f"{method}.svg", "-o", f"{method}.json")
           for method in ("isometric", "stretch")],
         flatten("bent-tshirt.obj", "--split", "seams", "--seams", "tshirt.seams.json", "-o", "split.json")),
    Case("holed", *[flatten("holed.obj", "--method", method, "-o", f"{method}.obj", "-o", f"{method}.json")
                    for method in ("isometric", "curvature", "abf")]),
    # Patterns and files
    Case("pattern_of_a_bent_tshirt", flatten(
        "bent-tshirt.obj", "--pattern", "--ledger", "--size", "M", "--date", "2026-01-02",
        *[word for ending in "svg pdf plt hpgl specification.json html htm csv json".split()
          for word in ("-o", f"tshirt.{ending}")])),
    Case("pattern_of_the_cap", flatten(
        "bent-cap.obj", "--pattern", "--notches", "none",
        *[word for ending in "svg obj usda glb specification.json csv json".split()
          for word in ("-o", f"pattern.{ending}")]),
         ["info", "pattern.usda"], ["info", "pattern.glb", "--json"], ["info", "pattern.specification.json"]),
    Case("lines", *[flatten("bent-bodice.obj", *words, "-o", f"{number}.svg", "-o", f"{number}.json")
                    for number, words in enumerate([
                        ["--fair"], ["--fair=0.5,30"], ["--true"], ["--mirror", "auto"],
                        ["--mirror", "none", "--allowance", "12", "--hem", "20", "--edge-allowance",
                         "armhole=9"],
                        ["--notches", "auto", "--allowance", "4"], ["--notches", "none", "--pattern"],
                        ["--grain", "vertical"], ["--grain", "reference"], ["--grain", "least-strain"],
                        ["--mirror", "equal"]])]),
    # Only what is symmetric is cut by half. Of the skirt only tables: where its lines begin is a matter of rounding.
    Case("half", flatten("tshirt.obj", "--half", "--pattern", "-o", "tshirt.svg", "-o", "tshirt.json",
                         "-o", "half.csv"),
         flatten("skirt.obj", "--half", "--pattern", "-o", "skirt.csv")),
    Case("mesh_files", flatten("panel.obj", "--pattern", "--mesh-uv", "drawn", "-o", "drawn.obj",
                               "-o", "drawn.usda", "-o", "drawn.glb"),
         flatten("panel.obj", "--pattern", "--mesh-uv", "exact", "-o", "exact.obj", "-o", "exact.usda",
                 "-o", "exact.glb"),
         flatten("cube-h.obj", "--method", "curvature", "--obj-pieces", "-o", "pieces.obj")),
    Case("dxf_presets", *[flatten("panel.obj", "--pattern", "--dxf-preset", preset, "-o", f"{preset}.dxf")
                          for preset in PRESETS_OF_DXF]),
    # The tolerance is some steps of the dense lines, which may begin later.
    Case("dxf_of_garments", *[flatten(f"bent-{name}.obj", "--pattern", "--dxf-profile", profile, "-o",
                                      f"{name}-{profile}.dxf")
                              for name, profile in (("tshirt", "astm"), ("tshirt", "aama"), ("bodice", "astm"))],
         summary=True, tolerance=10),
    Case("dxf_options",
         *[flatten("panel.obj", "--pattern", "--dxf-profile", profile, "--dxf-unit", unit, "--dxf-rul",
                   "--dxf-control-piece", "-o", f"{profile}-{unit}.dxf")
           for profile in ("astm", "aama", "plain") for unit in ("mm", "cm", "in")],
         ["info", "astm-mm.dxf"], ["info", "aama-cm.dxf", "--unit", "cm"], ["info", "plain-in.dxf", "--json"]),
    Case("svg_presets", *[flatten("panel.obj", "--pattern", "--svg-preset", preset, "-o", f"{preset}.svg")
                          for preset in PRESETS_OF_SVG],
         *[flatten("bent-cap.obj", "--pattern", "--notches", "none", "--svg-groups", groups, "--svg-text", text,
                   "-o", f"{groups}-{text}.svg")
           for groups, text in (("kind", "text"), ("piece", "paths"))],
         ["info", "inkscape.svg"]),
    Case("papers", *[flatten("panel.obj", "--pattern", "--paper", paper, "--overlap", "8",
                             "-o", f"{paper}.pdf") for paper in PAPERS],
         flatten("bent-skirt.obj", "-o", "skirt.pdf")),
    Case("plots", flatten("bent-cap.obj", "--pattern", "--notches", "none", "--plt-turned", "-o", "turned.plt"),
         flatten("bent-bodice.obj", "-o", "upright.plt")),
    Case("picture", flatten("panel.obj", "--pattern", "--png-dpi", "50", "-o", "panel.png"), needs=".png"),
    Case("projects",
         *[["flatten", f"{name}.toile", "-o", f"{name}.svg", "-o", f"{name}.json"]
           for name in ("sample", "version_1_tshirt", "version_1_cut")],
         ["flatten", "details.toile", "-o", "details.svg", "-o", "details.dxf", "--dxf-profile", "plain",
          "-o", "details.pdf", "-o", "details.json", "-o", "details.csv"],
         ["check", "details.toile"], ["walk", "details.toile"],
         ["flatten", "dart.toile", "-o", "dart.svg", "-o", "dart.dxf", "--dxf-profile", "plain",
          "-o", "dart.json", "-o", "dart.csv"]),
    # Reading
    Case("kinds_of_files",
         *[["flatten", name, "--unit", "cm", "-o", name.replace(".", "-") + ".json"]
           for name in ("panel.obj", "panel.stl", "panel.off", "panel.ply")],
         flatten("shell.obj", "-o", "outer.obj"),
         flatten("shell.obj", "--surface", "inner", "-o", "inner.json"),
         flatten("shell.obj", "--surface", "middle", "-o", "middle.obj"),
         flatten("shell.obj", "--as", "shell", "--surface", "outer"),
         flatten("panel.obj", "--as", "sheet", "--up", "z"),
         flatten("panel.stl", "--as", "soup", "--weld-within", "0.1", "--up", "y"),
         flatten("panel.obj", "--strict", "--close-slits"),
         ["flatten", "panel.obj"], ["flatten", "panel.obj", "--unit", "in", "--fail-on", "doubt", "--threads", "2"],
         flatten("panel.obj", "--fail-on", "fault"),
         flatten("shell.obj", "--strict"), ["flatten", "missing.obj"], ["flatten", "panel.obj", "--unit", "ell"],
         *[["info", name, "--json"] for name in ("shell.obj", "layers.obj", "ball.obj", "scan.obj", "half.obj")],
         ["info", "tube.obj", "--advice"]),
    Case("dividing",
         *[flatten("bent-tshirt.obj", "--split", split, "--ledger", "-o", f"{split}.json")
           for split in ("auto", "objects", "groups", "materials", "components", "uv")]),
    Case("automatic_cuts",
         flatten("tube.obj", "--auto-cut", "-o", "tailor.json", "-o", "tailor.svg"),
         flatten("tube.obj", "--auto-cut", "--cut-style", "topology", "--turn-over"),
         flatten("ball.obj", "--auto-cut", "--cut-style", "auto"),  # how it is turned is a matter of rounding
         flatten("ball.obj", "--auto-cut", "--as", "solid"),
         flatten("layers.obj", "--auto-cut", "--layer", "2", "-o", "layer.json"),
         flatten("layers.obj", "--auto-cut", "--as", "layers", "-o", "layers.svg", "-o", "layers.json"),
         flatten("half.obj", "--complete-half", "--auto-cut", "-o", "half.json"),
         flatten("bent-tshirt.obj", "--split", "components", "--weld", "--auto-cut", "--cut-style", "tailor",
                 "-o", "tshirt.json", "-o", "tshirt.svg"),
         flatten("bent-tshirt.obj", "--split", "components", "--weld", "--auto-cut", "--max-strain", "3", "--swap-front",
                 "-o", "enough.json")),
    Case("scan", flatten("scan.obj", "--as", "scan", "--close-holes", "0", "--smooth", "0.5", "--keep-debris",
                         "--auto-cut", "-o", "scan.json", "-o", "scan.svg")),
    # Groups of their own: other algorithms are to replace those that fill holes and make triangles again.
    Case("scan_holes", flatten("scan.obj", "--as", "scan", "--auto-cut", "-o", "usual.json", "-o", "usual.svg"),
         flatten("scan.obj", "--as", "scan", "--close-holes", "300", "--smooth", "0", "--auto-cut", "-o",
                 "closed.json")),
    Case("remesh",
         flatten("scan.obj", "--as", "scan", "--remesh", "18", "--auto-cut", "-o", "remeshed.json",
                 "-o", "remeshed.svg"),
         ["info", "scan.obj", *MM, "--as", "scan", "--remesh", "25", "--json"]),
    # Looking at garments
    Case("info", *[["info", f"{name}.obj", "--json"] for name in
                   ("tshirt", "bodice", "trousers", "cap", "skirt", "cube-h")],
         ["info", "tshirt.obj"], ["info", "sample.toile"]),
    Case("check", *[["check", f"bent-{name}.obj", *MM, "--pattern", "--fabric", fabric, *words]
                    for name, fabric, words in (
                        ("tshirt", "jersey", []), ("bodice", "woven", ["--json"]),
                        ("trousers", "denim", ["--fail-on", "doubt"]), ("cap", "leather", ["--json"]),
                        ("skirt", "unstated", []))]),
    Case("walk", ["walk", "bent-tshirt.obj", *MM, "--pattern"],
         ["walk", "bent-tshirt.obj", *MM, "--pattern", "--json"],
         ["walk", "bent-skirt.obj", *MM, "--method", "lscm"]),
    Case("compare_with_a_pattern", flatten("bent-skirt.obj", "-o", "skirt.svg"),
         ["compare", "bent-skirt.obj", *MM, "--pattern", "skirt.svg", "-o", "both.svg"],
         flatten("bent-skirt.obj", "--method", "abf", "--dxf-profile", "plain", "-o", "other.dxf"),
         ["compare", "bent-skirt.obj", *MM, "--pattern", "other.dxf", "--json"]),
    # Markers: the number of rounds is given, so that no clock decides. Where pieces may lie either way up, rounding
    # decides between places that are equally good; so all lie one way. Only a marker of a piece that is not
    # symmetric is drawn: labels of a symmetric piece have two places that are equally good, too.
    Case("markers",
         ["marker", "panel.obj", *MM, "--pattern", "--garments", "5", *ONE_WAY, "--rounds", "4",
          "--minutes-per-metre", "2", "-o", "roll.svg", "-o", "roll.plt", "-o", "roll.dxf", "-o", "roll.pdf",
          "--paper", "a0", "--report", "roll.json"],
         ["marker", "bent-cap.obj", *MM, "--width", "900", "--gap", "2", "--border", "10", *ONE_WAY, "--garments",
          "2", "--rounds", "4", "--report", "gap.json"],
         ["marker", "bent-skirt.obj", *MM, "--pattern", "--folded", *ONE_WAY, "--rounds", "0", "--seed", "2",
          "--report", "folded.json"],
         ["marker", "bent-bodice.obj", *MM, "--sheet", "500x700", "--free-grain", "--threads", "1", "--rounds", "3",
          "--report", "sheets.json"],
         ["marker", "bent-tshirt.obj", *MM, "--repeat", "80x60@10,5", "--match", "front / back, seam 1", *ONE_WAY,
          "--rounds", "0", "--report", "stripes.json"],
         ["marker", "bent-cap.obj", *MM, "--hide", "hide.svg", "--grade", "peak=2", *ONE_WAY, "--rounds", "0",
          "-o", "hide.marker.svg", "--report", "hide.json"],
         ["marker", "bent-tshirt.obj", *MM, "--pattern", *ONE_WAY, "--rounds", "1", "--report", "shirt.json"],
         ["marker", "details.toile", "--garments", "1", *ONE_WAY, "--rounds", "0"],
         ["marker", "nest.json", "--rounds", "30", "--seed", "3", "--threads", "1", "-o", "nest.svg", "--report",
          "nested.json"]),
    # Proof by sewing
    Case("proof",
         ["prove", "bent-cap.obj", *MM, "--threads", "1", "--report", "cap.json"],
         ["prove", "tube.obj", *MM, "--auto-cut", "--fabric", "denim", "--gravity", "--body", "tube.obj",
          "--threads", "1", "--report", "tube.json"],
         ["prove", "bent-skirt.obj", *MM, "--scale", "0.97", "--self-contact", "--threads", "1", "--edge", "25",
          "--report", "skirt.json"]),
    # Other programs
    Case("serve", ["serve"], stdin=SESSION),
    Case("batch", ["batch", "list.txt", "-o", "patterns", *MM, "--formats", "svg,csv"]),
]
