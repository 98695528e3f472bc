# SPDX-License-Identifier: GPL-3.0-or-later
"""A garment on its way through Toile: what is asked for, and what came of it. Knows no Blender."""

from __future__ import annotations

import pathlib
import shlex
import tempfile
from dataclasses import dataclass, field
from typing import Any

from .garment_mesh import FoundPattern, SourceMesh, WrittenGarment, found, written
from .program import Requests, ToileError, program_path

ARRAYS = ["vertices", "triangles", "source_vertices", "source_faces", "sheet", "strain"]


@dataclass
class Wishes:
    """As a person has said; the options are those of `toile flatten`."""

    program: str = ""  # empty: the one in PATH
    auto_cut: bool = False
    options: str = ""  # as on the command line
    files: list[str] = field(default_factory=list)  # of the pattern, by their endings


@dataclass
class Outcome:
    garment: WrittenGarment
    arrays: dict[str, dict[str, Any]]  # of the pieces by name
    pattern: FoundPattern
    seams: list[dict[str, Any]]  # of the report: sewn ones, the worst first
    sentences: list[str]  # what there is to say
    files: list[str]


class Flattening:
    """Begins at once; ask `requests.poll` until it is done, then `outcome`. Raises ToileError."""

    def __init__(self, meshes: list[SourceMesh], wishes: Wishes):
        if not any(mesh.faces for mesh in meshes):
            raise ToileError("There are no faces to flatten.", "no-geometry")
        reading = ["--unit", "mm", "--up", "z", "--as", "sheet", "--split", "components"]
        reading += ["--auto-cut"] if wishes.auto_cut else []
        try:
            reading += shlex.split(wishes.options)
        except ValueError as error:
            raise ToileError(f"The options cannot be read: {error}.", "wrong-usage") from error
        program = program_path(wishes.program)
        self._garment = written(meshes)
        self._folder = tempfile.TemporaryDirectory(prefix="toile-")
        path = pathlib.Path(self._folder.name) / "garment.obj"
        path.write_text(self._garment.text, encoding="utf-8")
        asked: list[dict[str, Any]] = [
            {"do": "load", "args": [str(path), *reading]},
            {"do": "flatten", "settle": True},
            {"do": "query", "what": ["seams", "problems", "doubts", *ARRAYS]},
        ]
        if wishes.files:
            words = [word for file in wishes.files for word in ("-o", file)]
            asked.append({"do": "export", "args": words})
        try:
            self.requests = Requests(program, asked)
        except ToileError:
            self.close()
            raise

    def outcome(self) -> Outcome:
        loaded, flat, told, *exported = self.requests.wait()
        arrays = told.get("arrays", {})
        errors = [piece["error"]["message"] for piece in flat["pieces"] if piece["error"]]
        if len(errors) == len(flat["pieces"]):
            raise ToileError(errors[0] if errors else "Nothing lies flat.", "failed")
        of_files = [said for file in loaded["files"] for said in file["problems"]]
        others = [*of_files, *told["problems"], *told["doubts"]]
        sentences = [*errors, *loaded["notes"], *(said["message"] for said in others)]
        sewn = [seam for seam in told["seams"] if seam["error_mm"] is not None]
        sewn.sort(key=lambda seam: -abs(seam["error_mm"]))
        return Outcome(
            self._garment,
            arrays,
            found(self._garment, arrays),
            sewn,
            list(dict.fromkeys(sentences)),  # what is wrong with a piece is said of its file too
            [file["path"] for answer in exported for file in answer["files"]],
        )

    def close(self) -> None:
        self._folder.cleanup()
