# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs two programs over the same cases and classifies what differs; see compare_outputs.sh."""
import concurrent.futures
import fnmatch
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
SAMPLES = HERE.parent / "resources" / "samples"
SHARED = pathlib.Path(
    os.environ.get("TOILE_SHARED_DATA", HERE.parent.parent / "shared" / "data")).resolve()
WORK = HERE.parent / "build" / "compare"
KEPT = pathlib.Path(os.environ.get("COMPARE", WORK)).resolve()  # outputs of the old program
FILES = [word for kind in ("svg", "dxf", "obj", "json") for word in ("-o", f"out.{kind}")]
METHODS = "isometric curvature wang2005 stretch natural lscm abf convex".split()
LIMIT = 40  # seconds of processor time; no case of sound input comes near
GIB = 2**30
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
MESHES = {".obj", ".off", ".ply", ".stl"}


def cases():
    """Names of cases with their arguments; files are meant relative to one of the two folders."""
    own = sorted(f.name for f in SAMPLES.glob("*.obj")) + ["shapes/cube-h.obj"]
    for name in own:
        yield ["flatten", name, "--unit", "mm", "--auto-cut", "--ledger", *FILES]
        yield ["info", name, "--json"]
        yield ["check", name, "--unit", "mm"]
        yield ["check", name, "--unit", "mm", "--json"]
    for name in ("bodice.obj", "cap.obj"):
        for method in METHODS:
            yield ["flatten", name, "--unit", "mm", "--method", method, *FILES]
    yield ["flatten", "tshirt.obj", "--unit", "mm", "--seams", "tshirt.seams.json", "--ledger", *FILES]
    yield ["flatten", "sample.toile", *FILES]
    yield ["compare", "tshirt.obj", "--unit", "mm", "--json"]
    yield ["flatten", "no-such-file.obj"]
    found = {folder: sorted(str(f.relative_to(SHARED)) for f in (SHARED / folder).rglob("*"))
             for folder in ("garments", "disks", "nasty", "attack")}
    meshes = {folder: [f for f in names if pathlib.Path(f).suffix in MESHES]
              for folder, names in found.items()}
    for name in meshes["garments"]:
        yield ["flatten", name, "--auto-cut", "--ledger", *FILES]
        yield ["flatten", name, "--method", "curvature", *FILES]
        yield ["info", name, "--json"]
        yield ["check", name]
    for name in meshes["disks"]:
        for method in ("isometric", "curvature"):
            yield ["flatten", name, "--method", method, *FILES]
    for name in meshes["nasty"] + meshes["attack"]:
        yield ["flatten", name, "--auto-cut", *FILES]
        yield ["info", name, "--json"]
    for name in meshes["attack"]:
        for method in ("curvature", "convex"):
            yield ["flatten", name, "--method", method, *FILES]
    for seams in (f for f in found["attack"] if f.endswith(".seams.json")):
        yield ["flatten", "attack/two.obj", "--seams", seams, *FILES]
    for project in (f for f in found["attack"] if f.endswith(".toile")):
        yield ["flatten", project, *FILES]
    if found["garments"]:
        yield ["flatten", "garments/leggings.ply", "--seams", "leggings.seams.json", *FILES]
        yield ["flatten", "garments/dress.obj", "--split", "uv", "--ledger", *FILES]
        yield ["flatten", "garments/polo.obj", "--split", "components", "--weld", *FILES]
        for method in METHODS[2:]:
            yield ["flatten", "garments/arcsim/tshirt.obj", "--method", method, *FILES]


def source(word):
    """The file that a word of a case means; none where it means none."""
    candidates = (folder / word for folder in (SAMPLES, SHARED, HERE / "data"))
    return next((c for c in candidates if "." in word and c.is_file()), None)


def run(program, case, folder):
    """Runs one case in a folder of its own, unless its outputs are there; returns the folder."""
    sources = [source(word) for word in case]
    key = hashlib.sha256(json.dumps(case).encode())
    for path in filter(None, sources):
        key.update(path.read_bytes())
    done = folder / key.hexdigest()[:16]
    if done.exists():
        return done
    folder = folder / f"{done.name}.{os.getpid()}"
    folder.mkdir(parents=True)
    words = []
    for word, path in zip(case, sources):  # by bare names, so that no output says where the tree lies
        if path and path.suffix != ".toile":  # which looks for its meshes beside itself
            (folder / path.name).symlink_to(path)
        words.append(word if not path else str(path) if path.suffix == ".toile" else path.name)
    with open(folder / "stdout", "wb") as out, open(folder / "stderr", "wb") as err:
        limits = ["prlimit", f"--cpu={LIMIT}", f"--as={6 * GIB}", "--core=0"]
        ended = subprocess.run(limits + [program] + words, cwd=folder, stdin=subprocess.DEVNULL,
                               stdout=out, stderr=err)
    word = "out of time" if ended.returncode in (-24, -9) else str(ended.returncode)
    (folder / "status").write_text(word)
    try:
        folder.rename(done)
    except OSError:  # somebody else has, in a shared folder
        shutil.rmtree(folder)
    return done


def text(path):
    """What a file says but for times and folders."""
    if not path.exists():
        return "(no file)\n"
    said = path.read_bytes().decode("utf-8", "replace")
    if path.name == "stdout" or path.suffix == ".json":
        said = re.sub(r'"seconds(\w*)": (\{[^}]*\}|[^,\n}]+)', r'"seconds\1": 0', said)
        said = re.sub(r'"(path|file)": "/[^"]*/', r'"\1": "', said)  # where a project's meshes lie
    if path.name != "stdout":
        return said
    lines, table = [], False
    for line in said.split("\n"):  # without the last column of a table of times
        fields = re.split(" {2,}", line.rstrip())
        table = fields[-1] == "ms" or (table and len(fields) >= 10)
        lines.append("  ".join(fields[:-1]) if table else line)
    return "\n".join(lines)


def difference(old, new):
    """In words, "" where equal, and the largest difference of numbers where only these differ."""
    before, after = text(old), text(new)
    if before == after:
        return "", 0
    if old.name == "status":
        return f"ends {before} -> {after}", None
    if NUMBER.sub("#", before) == NUMBER.sub("#", after):
        pairs = zip(NUMBER.findall(before), NUMBER.findall(after))
        worst = max(abs(float(a) - float(b)) for a, b in pairs if a != b)
        bound = next((f"at most {b}" for b in ("1e-9", "1e-6") if worst <= float(b)), "MORE than 1e-6")
        return f"numbers differ by {worst:.2g}, {bound}", worst
    for path, said in ((old, before), (new, after)):
        (new.parent / f"{new.name}.{'old' if path is old else 'new'}").write_text(said)
    shown = subprocess.run(["diff", "-U0", f"{new.name}.old", f"{new.name}.new"], cwd=new.parent,
                           capture_output=True).stdout.decode("utf-8", "replace").split("\n")[2:-1]
    count = sum(line[0] in "+-" for line in shown)
    return f"text differs, {count} lines:" + "".join(f"\n        {x[:150]!r}" for x in shown[:6]), None


def expectations():
    lines = (HERE / "expected_differences.txt").read_text().split("\n")
    rows = [[f.strip() for f in x.split("|")] for x in lines if x.strip() and x[0] != "#"]
    return [(row[0], row[1], float(row[2]) if len(row) > 2 else None) for row in rows]


def main():
    old, new = (str(pathlib.Path(p).resolve()) for p in sys.argv[1:3])
    stores = [KEPT / hashlib.sha256(pathlib.Path(old).read_bytes()).hexdigest()[:16], WORK / f"new.{os.getpid()}"]
    stores[1].mkdir(parents=True)
    wanted = [c for c in cases() if all(part in " ".join(c) for part in sys.argv[3:])]
    rules, used = expectations(), set()
    tally = {"same": 0, "expected": 0, "DIFFERS": 0}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        pairs = [(c, pool.submit(run, old, c, stores[0]), pool.submit(run, new, c, stores[1]))
                 for c in wanted]
        for case, before, after in pairs:
            name = " ".join(w for w in case if w != "-o" and not w.startswith("out."))
            folders, verdict, lines = (before.result(), after.result()), "same", []
            late = "out of time" in [(f / "status").read_text() for f in folders]
            files = ["status"] if late else ["status", "stdout", "stderr"] + FILES[1::2]
            for file in files:
                words, worst = difference(*(f / file for f in folders))
                if not words:
                    continue
                rule = next((r for r in rules if fnmatch.fnmatch(f"{name}:{file}", r[0]) and
                             (r[2] is None or (worst is not None and worst <= r[2]))), None)
                used.add(rule)
                verdict = "DIFFERS" if verdict == "DIFFERS" or not rule else "expected"
                lines.append(f"    {file}: {'[' + rule[1] + '] ' if rule else ''}{words}")
            tally[verdict] += 1
            print("\n".join([f"{verdict:9}{name}"] + lines), flush=True)
    for rule in rules if not sys.argv[3:] else []:
        if rule not in used:
            print(f"no longer needed in expected_differences.txt: {rule[0]} ({rule[1]})")
    print(", ".join(f"{count} {verdict}" for verdict, count in tally.items()))
    if tally["DIFFERS"]:
        print(f"the new outputs are in {stores[1]}, the old ones in {stores[0]}")
        return 1
    shutil.rmtree(stores[1])
    return 0


sys.exit(main())
