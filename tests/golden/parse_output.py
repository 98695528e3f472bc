# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns an output file of Toile into words and numbers.

An output becomes lines of words in which every number is replaced by MARK, and the list of these
numbers. What differs from run to run, or depends on the machine, is left out first: times, the version
of Toile, and the pictures that OpenGL draws.
"""
import json
import math
import re
import struct
import zlib

NUMBER = re.compile(r"(?:(?<![A-Za-z0-9_.])[-+])?(?<![A-Za-z_.])(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?")
PLOT_NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
MARK = "\u25a1"
MAX_DECIMALS = 10
MAX_NUMBER = 1e15  # longer rows of digits are names


def decimals_of(token):
    mantissa, _, exponent = token.lower().partition("e")
    digits = len(mantissa.partition(".")[2]) - int(exponent or 0)
    return min(MAX_DECIMALS, max(0, digits))


class Output:
    """Words and numbers of one output, and how many decimals each number has."""

    def __init__(self, text, number=NUMBER):
        self.words, self.numbers, self.decimals, self.line_of = [], [], [], []
        for line in text.split("\n"):
            words = number.sub(self._take, line)
            words = re.sub(r"[ \t\r]+", " ", words).strip()
            self.words.append(words)

    def _take(self, match):
        value = float(match.group())
        if not abs(value) < MAX_NUMBER:
            return match.group()
        self.numbers.append(value)
        self.decimals.append(decimals_of(match.group()))
        self.line_of.append(len(self.words))
        return MARK


def without_chance(text):
    """Without times and what depends on the last digits: which of several errors of 0 is the largest."""
    text = re.sub(r'"seconds(\w*)":\s*(\{[^}]*\}|[^,\n}]+)', r'"seconds\1": TIME', text)
    text = re.sub(r'"cost":\s*\{[^}]*\}', '"cost": COST', text)
    text = re.sub(r'"(fingerprint|key)":\s*"[^"]*"', r'"\1": HASH', text)
    text = re.sub(r'^\{"id":[^,]*,"progress":[^}]*\}\n', "", text, flags=re.M)
    text = re.sub(r"^toile: (\d+ min )?\d+ s\b.*\n", "", text, flags=re.M)  # progress of what takes longer
    text = re.sub(r"largest error 0(\.0+)? mm \(.*\)", r"largest error 0\1 mm (NAME)", text)
    text = re.sub(r"; \d+\.\d s$", "; TIME", text, flags=re.M)
    lines, column, fields_in_table, split = [], None, 0, None
    for line in text.split("\n"):
        marks = r" *\| *" if line.startswith("|") else r" {2,}"
        fields = re.split(marks, line.strip())
        heading = next((k for k, field in enumerate(fields) if field in ("ms", "time ms")), None)
        if heading is not None and len(fields) > 3:
            column, fields_in_table, split = heading, len(fields), marks
        if column is not None and marks == split and len(fields) == fields_in_table:
            del fields[column]
            line = "  ".join(fields)
        else:
            column = None
        lines.append(line)
    return "\n".join(lines)


def pdf_text(data):
    """Dictionaries and content of all objects; not where they lie in the file, nor their length."""
    text = []
    for match in re.finditer(rb"\d+ \d+ obj\b(.*?)\bendobj\b", data, re.S):
        head, mark, rest = match.group(1).partition(b"stream")
        if mark:
            rest = rest.lstrip(b"\r").removeprefix(b"\n")
            body = zlib.decompressobj().decompress(rest) if b"/FlateDecode" in head else \
                rest.rpartition(b"endstream")[0]
            head = re.sub(rb"/Length \d+", b"", head)
            if b"/DeviceRGB" in head or b"/Length1" in head:  # a picture or a font
                body = b"%d bytes" % len(body)
            head += b"\nstream\n" + body
        text.append(head.decode("latin-1"))
    return "\n".join(text)


def glb_text(data):
    """The JSON text and all numbers of the buffers, an accessor after the other."""
    length, = struct.unpack_from("<I", data, 12)
    document = json.loads(data[20:20 + length])
    buffer = data[20 + length + 8:]
    lines = [json.dumps(document, indent=0)]
    kinds = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}
    widths = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
    for accessor in document["accessors"]:
        view = document["bufferViews"][accessor["bufferView"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        count = accessor["count"] * widths[accessor["type"]]
        values = struct.unpack_from(f"<{count}{kinds[accessor['componentType']]}", buffer, start)
        lines.append("accessor")
        lines += [f"{value:.10f}" if isinstance(value, float) else str(value) for value in values]
    return "\n".join(lines)


def png_text(data):
    """The size alone: letters and colours depend on the fonts and the libraries of the machine."""
    width, height = struct.unpack_from(">II", data, 16)
    at = data.find(b"pHYs")
    dots = struct.unpack_from(">IIB", data, at + 4) if at > 0 else ()
    return f"{width} x {height} pixels, {dots} per metre"


def dxf_summary(text):
    """Of an apparel DXF: the names of blocks, every entity with its layer, and the length and box of lines in
    place of their points. Where and how many points a curve has, and at which of them a line begins, depends on
    rounding: a sample moved by 1e-13 mm has other ones."""
    lines = [line.strip() for line in text.split("\n")]
    entities = []
    for code, value in zip(lines[0::2], lines[1::2]):
        if code == "0":
            entities.append({"0": value})
        elif entities:
            entities[-1].setdefault(code, value)
    told, points = [], []
    for entity in entities:
        kind, layer = entity["0"], entity.get("8", "")
        if kind == "VERTEX":
            points.append((float(entity["10"]), float(entity["20"])))
        elif kind == "SEQEND":
            xs, ys = zip(*points)
            length = sum(math.dist(a, b) for a, b in zip(points, points[1:]))
            told.append(f"{length:.4f} {min(xs):.4f} {max(xs):.4f} {min(ys):.4f} {max(ys):.4f}")
        elif kind != "POINT" or layer not in ("3", "84", "85"):  # points of curves
            points = []
            told.append(" ".join(["0", kind, layer, entity.get("2", ""), entity.get("1", "")]))
    return "\n".join(told)


def parse_output(name, data, version, summary=False):
    """@param name  of the file; the ending tells how to read it
    @param summary  of DXF: `dxf_summary`"""
    if name.endswith(".pdf"):
        text = pdf_text(data)
    elif name.endswith(".glb"):
        text = glb_text(data)
    elif name.endswith(".png"):
        text = png_text(data)
    else:
        text = data.decode("utf-8", "surrogateescape")
    if summary and name.endswith(".dxf"):
        text = dxf_summary(text)
    if name.endswith((".svg", ".html", ".htm")):  # whether a point is there twice depends on rounding
        text = re.sub(r"(-?[\d.]+,-?[\d.]+ )(L )?(?:\1)+", r"\1\2", re.sub(r'(?<=\d)(?=" />)', " ", text))
    if name.endswith((".html", ".htm")):  # pictures are there only with OpenGL
        text = re.sub(r"<figure>\n<img .*?</figure>\n", "", text, flags=re.S)
    text = re.sub(rf"(?<![\w.]){re.escape(version)}(?!\.?\w)", "VERSION", text)
    if name.endswith((".json", ".jsonl", ".html", ".htm", "stdout", "stderr")):
        text = without_chance(text)
    return Output(text, PLOT_NUMBER if name.endswith((".plt", ".hpgl")) else NUMBER)
