# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the Python module share: files, the built program, and an OBJ reader."""

from __future__ import annotations

import os
import subprocess
import unittest
from pathlib import Path
from typing import Any

import numpy as np

SOURCE = Path(os.environ.get("TOILE_SOURCE_DIR", Path(__file__).resolve().parents[2]))
SAMPLES = SOURCE / "resources" / "samples"
SHARED = Path(os.environ.get("TOILE_SHARED_DATA", SOURCE.parent / "shared" / "data"))


def sample(name: str) -> Path:
    return SAMPLES / name


def shared(name: str) -> Path:
    """A garment that is not part of the project; skips the test where it is not there."""
    path = SHARED / name
    if not path.exists():
        raise unittest.SkipTest(f"needs {name} of the shared data")
    return path


def program() -> str:
    """The built command line; skips the test where there is none."""
    path = os.environ.get("TOILE_PROGRAM", "")
    if not os.path.exists(path):
        raise unittest.SkipTest("needs the built program, TOILE_PROGRAM")
    return path


def run_program(*words: str | os.PathLike[str]) -> str:
    # What a sanitizer has loaded before the interpreter is none of the program's.
    own = {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}
    done = subprocess.run(
        [program(), *map(os.fspath, words)], capture_output=True, text=True, check=False, env=own
    )
    if done.returncode not in (0, 1):
        raise AssertionError(done.stderr)
    return done.stdout


def arrays_of(path: Path) -> dict[str, Any]:
    """An OBJ file as the arguments of toile.garment: what a program has that has read it."""
    points: list[list[float]] = []
    uvs: list[list[float]] = []
    faces: list[list[int]] = []
    uv_faces: list[list[int]] = []
    names: dict[str, list[str | None]] = {"o": [], "g": [], "usemtl": []}
    current: dict[str, str | None] = dict.fromkeys(names)
    decimals = 0
    for line in path.read_text().splitlines():
        word, _, rest = line.partition(" ")
        if word == "v":
            points.append([float(number) for number in rest.split()[:3]])
            decimals = len(rest.split()[0].partition(".")[2])
        elif word == "vt":
            uvs.append([float(number) for number in rest.split()[:2]])
        elif word in names:
            current[word] = rest.strip()
        elif word == "f":
            corners = [corner.split("/") for corner in rest.split()]
            faces.append([int(corner[0]) - 1 for corner in corners])
            uv_faces.append([int(c[1]) - 1 if len(c) > 1 and c[1] else -1 for c in corners])
            for key, of_face in names.items():
                of_face.append(current[key])
    arrays: dict[str, Any] = {"vertices": np.array(points), "faces": _rows(faces)}
    if uvs:
        arrays |= {"vt": np.array(uvs), "ft": _rows(uv_faces)}
    for key, word in (("o", "objects"), ("g", "groups"), ("usemtl", "materials")):
        if any(names[key]):
            arrays[word] = names[key]
    return arrays | {"name": path.name, "decimals": decimals}


def _rows(faces: list[list[int]]) -> Any:
    return np.array(faces, np.int32) if len({len(face) for face in faces}) == 1 else faces


def grid(size: int = 4, bump: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """A square sheet of size x size fields of 10 mm, bent upwards by `bump` mm in the middle."""
    axis = np.linspace(0, 10 * size, size + 1)
    x, y = np.meshgrid(axis, axis)
    z = bump * np.sin(np.pi * x / axis[-1]) * np.sin(np.pi * y / axis[-1])
    points = np.column_stack([x.ravel(), y.ravel(), z.ravel()])
    corner = (np.arange(size)[:, None] * (size + 1) + np.arange(size)).ravel()
    lower = np.column_stack([corner, corner + 1, corner + size + 2])
    upper = np.column_stack([corner, corner + size + 2, corner + size + 1])
    return points, np.concatenate([lower, upper]).astype(np.int32)
