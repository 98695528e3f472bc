#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares what the program `toile` writes with stored values: the golden values.

The cases in cases.py cover every export format and option, every method, reading, automatic cuts,
markers, proofs and the other commands, on small garments. Each output file, the console output and the
exit status are compared: words exactly, numbers within a tolerance. It needs only Python and the program.

    TOILE_PROGRAM=build/release/app/toile tests/golden/golden_test.py             all cases
    TOILE_PROGRAM=build/release/app/toile tests/golden/golden_test.py papers      one case, or several
    tests/golden/golden_test.py --list                                       the names of the cases
    tests/golden/golden_test.py --shard 0/2                                  every second case

The program runs without fonts and settings of the user, with one kernel of OpenBLAS and one thread of it;
GOLDEN_CORETYPE, GOLDEN_THREADS and GOLDEN_LOCALE change these, to see whether a case depends on them. Choose
cases that do not: symmetric pieces, equal copies in a marker and curve points of apparel DXF are decided by
rounding.

A number passes if it differs by at most 1e-6 (mm, or what the file's unit is) plus 1e-9 of its size. A
number that is printed with few decimals may also round to the other neighbour: it may differ by one unit of
its last decimal, but only 2 numbers plus 1 of 200 in a file may.

To change values on purpose:

 1. Run the test and read the differences: are all of them intended?
 2. Write the values again, only of the cases that changed:
        TOILE_PROGRAM=build/release/app/toile tests/golden/golden_test.py --update CASE...
 3. Commit tests/golden/values together with the change, and list in the commit message each case that
    changed and why. The files are JSON in xz: `xz -dc tests/golden/values/CASE.xz` shows them.
"""
import argparse
import json
import lzma
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
VALUES = HERE / "values"
INPUT_FOLDERS = [SOURCE / "resources" / "samples", SOURCE / "resources" / "samples" / "shapes",
                 SOURCE / "tests" / "data", HERE / "input"]
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True

import cases as table  # noqa: E402
import meshes  # noqa: E402
import parse_output  # noqa: E402

ABSOLUTE, RELATIVE = 1e-6, 1e-9
ROUNDED_SHARE, ROUNDED_COUNT = 1 / 200, 2  # numbers of a file that may round to the other neighbour
MAX_STORED_DECIMALS = 8  # beyond what the tolerances need
SHOWN = 6  # differences of a file that are printed
# Absolute and relative tolerances of formats.
OF_ENDING = {
    ".glb": (1e-9, 2.4e-7),  # in metres; a number has 24 bits, which are 1.2e-7 of its size
    ".specification.json": (2e-5, 1e-9),  # control points of curves that are nearly straight
}


def environment(folder):
    """The same on every machine: no fonts, no settings of the user, one kernel of OpenBLAS."""
    config = folder / "fonts.conf"
    config.write_text('<?xml version="1.0"?>\n<fontconfig></fontconfig>\n')
    return {
        "PATH": os.environ.get("PATH", ""), "LD_LIBRARY_PATH": os.environ.get("LD_LIBRARY_PATH", ""),
        "HOME": str(folder), "XDG_CONFIG_HOME": str(folder), "XDG_CACHE_HOME": str(folder),
        "LC_ALL": os.environ.get("GOLDEN_LOCALE", "C.UTF-8"), "TZ": "UTC",
        "OPENBLAS_CORETYPE": os.environ.get("GOLDEN_CORETYPE", "Prescott"),  # any x86-64 has it
        "OPENBLAS_NUM_THREADS": os.environ.get("GOLDEN_THREADS", "1"),
        "OMP_NUM_THREADS": os.environ.get("GOLDEN_THREADS", "1"),
        "FONTCONFIG_FILE": str(config), "QT_QPA_PLATFORM": "offscreen", "LIBGL_ALWAYS_SOFTWARE": "1",
    }


class Program:
    def __init__(self, path, folder):
        self.path, self.environment = path, environment(folder)
        self.version = self.run(["--version"]).stdout.decode().split()[-1]
        self.help = self.run(["flatten", "--help"]).stdout.decode()

    def run(self, words, cwd=None, stdin=None):
        return subprocess.run([self.path, *words], cwd=cwd, env=self.environment, capture_output=True,
                              input=(stdin or "").encode(), timeout=600)

    def endings(self):
        """Endings of all formats, and of those that this build can write."""
        known = re.findall(r"(\.[a-z.]+) \(([^)]*)\)( \(not built\))?", self.help)
        return [row[0] for row in known], [row[0] for row in known if not row[2]]


def input_files():
    """Bytes of every input by its name."""
    files = meshes.all_meshes(INPUT_FOLDERS[0])
    for folder in INPUT_FOLDERS:
        for path in sorted(folder.glob("*")) if folder.is_dir() else []:
            if path.is_file() and path.suffix in (".obj", ".json", ".toile", ".svg", ".txt"):
                data = path.read_bytes()
                if path.suffix == ".toile":  # its meshes are read from its own folder
                    data = re.sub(rb'"(\.\./)+(resources/samples/)?', b'"', data)
                files[path.name] = data
    return files


def run_case(case, program, inputs, folder):
    """Runs the commands of a case in an empty folder. @return their outputs, parsed, by name"""
    folder.mkdir()
    wanted = {word for words in case.commands for word in words} | set(re.findall(r'"([^"]+\.obj)"', case.stdin or ""))
    queue = [name for name in wanted if name in inputs]
    seen = {}
    while queue:
        name = queue.pop()
        if name in seen:
            continue
        seen[name] = inputs[name]
        (folder / name).write_bytes(inputs[name])
        if name.endswith((".toile", ".txt")):
            queue += [n for n in re.findall(r"[\w.-]+\.\w+", inputs[name].decode()) if n in inputs]

    def parse(name, data):
        return parse_output.parse_output(name, data.replace(os.fsencode(folder), b"FOLDER"), program.version,
                                         case.summary)

    outputs = {}
    for number, words in enumerate(case.commands):
        done = program.run(words, folder, case.stdin)
        prefix = f"{number} " + " ".join(words)[:60].replace("/", "_")
        outputs[f"{prefix}: status"] = parse_output.Output(str(done.returncode))
        for name, data in (("stdout", done.stdout), ("stderr", done.stderr)):
            outputs[f"{prefix}: {name}"] = parse(name, data)
        for path in sorted(folder.rglob("*")):
            name = str(path.relative_to(folder))
            if path.is_file() and name not in seen:
                seen[name] = data = path.read_bytes()
                outputs[name] = parse(path.name, data)
            elif path.is_file() and path.read_bytes() != seen[name] and name not in inputs:
                raise RuntimeError(f"{case.name}: two commands write {name}")
    return outputs


def packed(name, output):
    """As JSON: the words, and the numbers as differences of whole numbers."""
    places = max(output.decimals, default=0)
    places = places if name.endswith(".glb") else min(MAX_STORED_DECIMALS, places)
    whole = [round(value * 10**places) for value in output.numbers]
    best = None
    for stride in range(5):  # coordinates repeat after 1, 2, 3 or 4 numbers
        text = " ".join(str(v - (whole[k - stride] if 0 < stride <= k else 0)) for k, v in enumerate(whole))
        best = min(best or (len(text), stride, text), (len(text), stride, text))
    runs = []
    for count in output.decimals:
        if runs and runs[-1][0] == count:
            runs[-1][1] += 1
        else:
            runs.append([count, 1])
    return {"words": "\n".join(output.words), "places": places, "stride": best[1], "numbers": best[2],
            "decimals": " ".join(f"{count}*{times}" for count, times in runs)}


def unpacked(stored):
    """@return lines of words, numbers and their decimals"""
    stride, scale = stored["stride"], 10 ** stored["places"]
    whole = []
    for k, word in enumerate(stored["numbers"].split()):
        whole.append(int(word) + (whole[k - stride] if 0 < stride <= k else 0))
    decimals = []
    for run in stored["decimals"].split():
        count, times = run.split("*")
        decimals += [int(count)] * int(times)
    return stored["words"].split("\n"), [v / scale for v in whole], decimals


def write_values(case, outputs):
    VALUES.mkdir(exist_ok=True)
    text = json.dumps({name: packed(name, output) for name, output in outputs.items()}, indent=0,
                      ensure_ascii=False)
    (VALUES / f"{case.name}.xz").write_bytes(
        lzma.compress(text.encode("utf-8", "surrogateescape"), preset=9 | lzma.PRESET_EXTREME))


def read_values(case):
    path = VALUES / f"{case.name}.xz"
    if not path.exists():
        return None
    return json.loads(lzma.decompress(path.read_bytes()).decode("utf-8", "surrogateescape"))


def filled(words, numbers, line, line_of):
    """A line with its numbers again, to be read by a person."""
    if line >= len(words):
        return "(no such line)"
    rest = iter(number for number, at in zip(numbers, line_of) if at == line)
    return re.sub(parse_output.MARK, lambda _: f"{next(rest, float('nan')):.9g}", words[line])


def compare_words(expected, output):
    """@return sentences about the first lines whose words differ"""
    lines = expected[0]
    if lines == output.words:
        return []
    pairs = list(zip(lines, output.words))
    count = sum(a != b for a, b in pairs) + abs(len(lines) - len(output.words))
    first = next((k for k, (a, b) in enumerate(pairs) if a != b), len(pairs))
    line_of = [k for k, words in enumerate(lines) for _ in range(words.count(parse_output.MARK))]
    told = [f"words differ: {len(lines)} lines expected, {len(output.words)} found, {count} differ"]
    for k in range(first, min(first + 2, max(len(lines), len(output.words)))):
        texts = [filled(lines, expected[1], k, line_of),
                 filled(output.words, output.numbers, k, output.line_of)]
        start = max(0, len(os.path.commonprefix(texts)) - 60)
        for what, text in zip(("expected:", "found:   "), texts):
            told.append(f"  line {k + 1}, {what} " + ("... " if start else "") + text[start:start + 200])
    return told


def compare_numbers(name, expected, output, tolerance):
    """@return sentences about numbers that differ; how many rounded otherwise; largest difference"""
    _, numbers, decimals = expected
    if len(numbers) != len(output.numbers):
        return [f"{len(numbers)} numbers expected, {len(output.numbers)} found"], 0, 0
    ending = next((e for e in OF_ENDING if name.endswith(e)), "")
    absolute, relative = OF_ENDING.get(ending, (ABSOLUTE, RELATIVE))
    absolute = max(absolute, tolerance or 0)
    is_plot = name.endswith((".plt", ".hpgl"))
    wrong, rounded, largest = [], [], 0.0
    for k, (a, b) in enumerate(zip(numbers, output.numbers)):
        difference = abs(a - b)
        if difference <= absolute + relative * abs(a):
            continue
        largest = max(largest, difference)
        places = max(decimals[k], output.decimals[k])  # formats may leave out zeros at the end
        unit = 10.0 ** -places
        may_round = places > 0 or is_plot
        (rounded if may_round and difference <= 1.001 * unit else wrong).append(k)
    if len(rounded) > ROUNDED_COUNT + ROUNDED_SHARE * len(numbers):
        wrong = sorted(wrong + rounded)
    told = []
    if wrong:
        told.append(f"{len(wrong)} of {len(numbers)} numbers differ, by up to {largest:.3g}")
    for k in wrong[:SHOWN]:
        line = output.line_of[k]
        told.append(f"  line {line + 1}, number {k + 1}: expected {numbers[k]:.10g}, found "
                    f"{output.numbers[k]:.10g}, in: {output.words[line][:100]}")
    return told, len(rounded), largest


def compare_case(case, outputs, stored):
    """@return sentences, and a note about numbers that rounded otherwise"""
    told, rounded = [], 0  # the numbers of a file are compared only if its words are equal
    for name in [*stored, *(n for n in outputs if n not in stored)]:
        if name not in outputs or name not in stored:
            told.append(f"{name}: " + ("is not written any more" if name in stored else "is new"))
            continue
        expected = unpacked(stored[name])
        lines = compare_words(expected, outputs[name])
        if not lines:
            lines, count, _ = compare_numbers(name, expected, outputs[name], case.tolerance)
            rounded += count
        told += [f"{name}: {lines[0]}", *lines[1:]] if lines else []
    return told, rounded


def uncovered(program):
    """Formats, methods and words of options that no case uses, and values that belong to no case."""
    words = {word for case in table.CASES for command in case.commands for word in command}
    known, _ = program.endings()
    missing = [f"no case writes the format {ending}" for ending in known
               if not any(word.endswith(ending) for word in words)]
    if len(known) < 12:
        missing.append(f"toile flatten --help lists only {len(known)} formats")
    for line in program.help.split("\n"):
        match = re.match(r" +(--[\w-]+)(?: (\S+))?", line)
        if not match or match.group(1) == "--help":
            continue
        option, values = match.group(1), match.group(2) or ""
        used = {b for case in table.CASES for command in case.commands
                for a, b in zip(command, [*command[1:], ""]) if a == option}
        used |= {word.partition("=")[2] for word in words if word.startswith(option + "=")}
        if option not in words and not used:
            missing.append(f"no case uses the option {option}")
        for value in values.partition("=")[0].split("|") if "|" in values else []:
            if value not in used and value not in table.NOT_COVERED.get(option, []):
                missing.append(f"no case uses {option} {value}")
    names = {case.name for case in table.CASES}
    missing += [f"{path.name} belongs to no case" for path in sorted(VALUES.glob("*")) if path.stem not in names]
    return missing


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("cases", nargs="*", metavar="CASE")
    parser.add_argument("--update", action="store_true", help="write the values of the cases again")
    parser.add_argument("--shard", default="0/1", metavar="K/N", help="cases K, K + N, ... alone")
    parser.add_argument("--list", action="store_true", help="print the names of the cases")
    parser.add_argument("--keep", metavar="FOLDER", help="keep what the program wrote, in a new folder")
    asked = parser.parse_args()
    names = asked.cases
    unknown = set(names) - {case.name for case in table.CASES}
    if unknown:
        parser.error(f"no such case: {', '.join(sorted(unknown))}")
    if asked.list:
        print("\n".join(case.name for case in table.CASES))
        return 0
    path = os.environ.get("TOILE_PROGRAM")
    if not path or not os.access(path, os.X_OK):
        parser.error("set TOILE_PROGRAM to the program to test")
    shard, shards = (int(part) for part in asked.shard.split("/"))
    chosen = [case for k, case in enumerate(table.CASES)
              if (case.name in names if names else k % shards == shard)]
    folder = pathlib.Path(tempfile.mkdtemp(prefix="toile-golden-"))
    failed, rounded_in_all = 0, 0
    try:
        program = Program(os.path.abspath(path), folder)
        inputs = input_files()
        if not names and shard == 0:
            missing = uncovered(program)
            failed += bool(missing)
            print("".join(f"FAILED coverage: {line}\n" for line in missing), end="")
        for case in chosen:
            if case.needs and case.needs not in program.endings()[1]:
                print(f"skipped {case.name}: this build does not write {case.needs}")
                continue
            started = time.monotonic()
            try:
                outputs = run_case(case, program, inputs, folder / case.name)
            except (RuntimeError, subprocess.TimeoutExpired) as trouble:
                failed += 1
                print(f"FAILED {case.name}: {trouble}", flush=True)
                continue
            seconds = time.monotonic() - started
            if asked.update:
                write_values(case, outputs)
                size = (VALUES / f"{case.name}.xz").stat().st_size
                print(f"written {case.name}: {len(outputs)} outputs, {size} bytes, {seconds:.1f} s", flush=True)
                continue
            stored = read_values(case)
            told, rounded = compare_case(case, outputs, stored) if stored else (["there are no values"], 0)
            rounded_in_all += rounded
            failed += bool(told)
            print(f"{'FAILED' if told else 'passed'} {case.name}, {seconds:.1f} s"
                  + (f", {rounded} numbers rounded to the other neighbour" if rounded else ""))
            if told:
                print("".join(f"    {line}\n" for line in told[:60]), end="")
                print(f"  To repeat it: TOILE_PROGRAM={path} {sys.argv[0]} {case.name} --keep FOLDER\n"
                      f"  If the change is intended, read the first lines of {sys.argv[0]}.")
            sys.stdout.flush()
        if asked.keep:
            shutil.copytree(folder, asked.keep)
    finally:
        shutil.rmtree(folder)
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    own, of_toile = (usage.ru_utime + usage.ru_stime for usage in used)
    print(f"{failed} failed; processor time: {of_toile:.1f} s of toile, {own:.1f} s of Python")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
