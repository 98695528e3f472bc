#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes garments for trials of `toile batch`, the same at every run.

    tests/batch/make_garments.py FOLDER COUNT [SOURCE.obj...]

Each is one of the sources (else the samples, and the shared garments where these are), of another
size, turned about the vertical, and bent a little and smoothly; every 25th is a bad file: cut off
near the end, empty, closed all round, or no mesh at all. FOLDER/list.txt names them all, with
absolute paths.
"""
import math
import random
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SHARED = ROOT.parent / "shared" / "data" / "garments"
SHARED_NAMES = ["tee_sim", "dress", "polo", "longsleeve", "skirt_clo", "tshirt"]
BAD_EVERY = 25
BALL = "v 0 0 5\nv 1 0 5\nv 0 1 5\nv 0 0 6\no ball\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n"
SMALLEST, LARGEST = 0.85, 1.2  # of the source's size
BEND = 0.01  # of the height, at most
DECIMALS = 6


def sources() -> list[Path]:
    """Ours come before each of the others, as most garments are not that large."""
    ours = sorted((ROOT / "resources" / "samples").glob("*.obj"))
    others = [SHARED / f"{name}.obj" for name in SHARED_NAMES]
    return ours + [path for path in others if path.is_file()]


def varied(text: str, number: int) -> str:
    """The mesh with other positions; every other line as it is."""
    lines = text.splitlines()
    points = [
        [float(word) for word in line.split()[1:4]] for line in lines if line.startswith("v ")
    ]
    choice = random.Random(number)
    size = choice.uniform(SMALLEST, LARGEST)
    angle = choice.uniform(-math.pi, math.pi)
    low = [min(point[k] for point in points) for k in range(3)]
    height = max(max(point[k] for point in points) - low[k] for k in range(3))
    bend = [choice.uniform(-BEND, BEND) * height for _ in range(3)]
    phase = [choice.uniform(0, 2 * math.pi) for _ in range(3)]
    cosine, sine = math.cos(angle), math.sin(angle)

    def moved(point: list[float]) -> tuple[float, ...]:
        waves = [
            point[k] + bend[k] * math.sin(2 * math.pi * point[(k + 1) % 3] / height + phase[k])
            for k in range(3)
        ]
        x, y, z = (size * value for value in waves)
        return (cosine * x + sine * z, y, cosine * z - sine * x)

    moving = iter(points)
    return "\n".join(
        "v " + " ".join(f"{value:.{DECIMALS}f}" for value in moved(next(moving)))
        if line.startswith("v ")
        else line
        for line in lines
    )


def spoiled(text: str, kind: int) -> str:
    if kind == 0:
        return text[: len(text) * 4 // 5]
    if kind == 1:
        return ""
    if kind == 2:
        return BALL
    return "This is a letter to the tailor, and no garment.\n"


def main() -> None:
    folder, count = Path(sys.argv[1]).resolve(), int(sys.argv[2])
    chosen = [Path(name) for name in sys.argv[3:]] or sources()
    texts = [path.read_text(encoding="utf-8", errors="replace") for path in chosen]
    folder.mkdir(parents=True, exist_ok=True)
    names = []
    for number in range(count):
        which = number % len(chosen)
        text = varied(texts[which], number) + "\n"
        bad, rest = divmod(number, BAD_EVERY)
        if rest == BAD_EVERY - 1:
            text = spoiled(text, bad % 4)
        path = folder / f"{chosen[which].stem}-{number:05d}.obj"
        path.write_text(text, encoding="utf-8")
        names.append(str(path))
    (folder / "list.txt").write_text("".join(name + "\n" for name in names), encoding="utf-8")


if __name__ == "__main__":
    main()
