# SPDX-License-Identifier: GPL-3.0-or-later
"""A garment on its way through Toile: what is asked for, and what came of it. Knows no Blender."""

from __future__ import annotations

import pathlib
import shlex
import tempfile
from dataclasses import dataclass, field
from typing import Any

from .garment_mesh import (
    MILLIMETRES,
    READING,
    FoundPattern,
    SourceMesh,
    WrittenGarment,
    found,
    in_scene,
    nowhere,
    one_line,
    written,
)
from .program import Requests, ToileError, program_path

FILE = "garment.obj"
WELDED = "vertices-welded"  # is of no consequence: the map keeps apart what lies apart
SHOWN = 2  # decimals of errors: those that look alike stay in the order of their names
ARRAYS = ["vertices", "triangles", "source_vertices", "source_faces", "sheet", "strain"]


@dataclass
class Wishes:
    """As a person has said; the options are those of `toile flatten`."""

    program: str = ""  # empty: the one in PATH
    auto_cut: bool = False
    options: str = ""  # as on the command line
    files: list[str] = field(default_factory=list)  # of the pattern, by their endings
    unit: float = MILLIMETRES  # to a unit of the scene, in which sentences tell places


@dataclass
class Outcome:
    garment: WrittenGarment
    arrays: dict[str, dict[str, Any]]  # of the pieces by name
    pattern: FoundPattern
    seams: list[dict[str, Any]]  # of the report: sewn ones, the worst first
    is_cut: bool  # cuts run through faces: the pattern is no map of the meshes as they are
    sentences: list[str]  # what there is to say
    files: list[str]


class Flattening:
    """Begins at once; ask `requests.poll` until it is done, then `outcome`. Raises ToileError."""

    def __init__(self, meshes: list[SourceMesh], wishes: Wishes):
        if not any(mesh.faces for mesh in meshes):
            raise ToileError("There are no faces to flatten.", "no-geometry")
        for mesh in meshes:
            vertex = nowhere(mesh)
            if vertex is not None:
                raise ToileError(
                    f"Vertex {vertex} of {mesh.name} lies nowhere: its place is no number; "
                    "delete it, or give it a place.",
                    "non-finite-position",
                    mesh.name,
                )
        reading = [*READING, *(["--auto-cut"] if wishes.auto_cut else [])]
        try:
            options = shlex.split(wishes.options)
        except ValueError as error:
            raise ToileError(f"The options cannot be read: {error}.", "wrong-usage") from error
        for word in options:
            if word.startswith("--") and word.partition("=")[0] in READING:
                raise ToileError(f"The add-on says {word} itself; leave it out.", "wrong-usage")
        reading += options
        program = program_path(wishes.program)
        self._garment = written(meshes)
        self._unit = wishes.unit
        self._meshes = one_line(meshes[0].name) if len(meshes) == 1 else "the meshes"
        self._folder = tempfile.TemporaryDirectory(prefix="toile-")
        path = pathlib.Path(self._folder.name) / FILE
        path.write_text(self._garment.text, encoding="utf-8")
        asked: list[dict[str, Any]] = [
            {"do": "load", "args": [str(path), *reading]},
            {"do": "flatten", "settle": True},
            {"do": "query", "what": ["cuts", "seams", "problems", "doubts", *ARRAYS]},
        ]
        if wishes.files:
            words = [word for file in wishes.files for word in ("-o", file)]
            asked.append({"do": "export", "args": words})
        try:
            self.requests = Requests(program, asked, self._reworded)
        except ToileError:
            self._folder.cleanup()
            raise

    def _reworded(self, said: dict[str, Any]) -> str:
        """In words of who sees the meshes, and never the file."""
        return in_scene(said, self._unit).replace(FILE, self._meshes)

    def outcome(self) -> Outcome:
        loaded, flat, told, *exported = self.requests.wait()
        arrays = told.get("arrays", {})
        errors = [piece["error"] for piece in flat["pieces"] if piece["error"]]
        if len(errors) == len(flat["pieces"]):
            said = self._reworded(errors[0]) if errors else "Nothing lies flat."
            raise ToileError(said, "failed")
        of_files = [
            said
            for file in loaded["files"]
            for said in file["problems"]
            if said["code"] != WELDED
        ]
        others = [*of_files, *told["problems"], *told["doubts"]]
        notes = [{"message": sentence} for sentence in loaded["notes"]]
        sentences = map(self._reworded, [*errors, *notes, *others])
        pattern = found(self._garment, arrays)
        sewn = [seam for seam in told["seams"] if seam["error_mm"] is not None]
        sewn.sort(key=lambda seam: -round(abs(seam["error_mm"]), SHOWN))
        return Outcome(
            self._garment,
            arrays,
            pattern,
            sewn,
            pattern.is_split and bool(told["cuts"]),
            # What is wrong with a piece is said of its file too.
            list(dict.fromkeys(sentences)),
            [file["path"] for answer in exported for file in answer["files"]],
        )

    def close(self) -> None:
        """Ends it, wherever it is."""
        self.requests.close()
        self._folder.cleanup()
