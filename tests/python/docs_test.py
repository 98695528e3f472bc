# SPDX-License-Identifier: GPL-3.0-or-later
"""Everything public says what it is, and the stubs know it all."""

import ast
import inspect
import re
import unittest
from pathlib import Path

import toile
import toile.bridge
from support import SOURCE
from toile import _core

STUBS = Path(toile.__file__).with_name("_core.pyi")


def members(owner: type) -> list[str]:
    return [name for name in vars(owner) if not name.startswith("_")]


class Documentation(unittest.TestCase):
    def test_everything_public_has_a_docstring(self) -> None:
        for name in toile.__all__:
            thing = getattr(toile, name)
            self.assertTrue(inspect.getdoc(thing), name)
            if inspect.isclass(thing) and thing.__module__.endswith("_core"):
                for member in members(thing):
                    text = inspect.getdoc(getattr(thing, member))
                    self.assertTrue(text, f"{name}.{member}")
        for name in ("from_meshio", "from_trimesh", "to_meshio"):
            self.assertTrue(inspect.getdoc(getattr(toile.bridge, name)), name)

    def test_arrays_state_shape_and_unit(self) -> None:
        for owner, names in {
            toile.Piece: ("vertices", "faces", "boundary", "source_vertices"),
            toile.FlatPiece: ("positions", "strain"),
            toile.PatternPiece: ("outline", "cutting_line"),
            toile.ProvenPiece: ("sewn", "gap", "strain"),
        }.items():
            for name in names:
                text = inspect.getdoc(getattr(owner, name)) or ""
                self.assertRegex(text, r"(float64|int32) \(\w+,( \d)?\)", name)
                self.assertTrue("int32" in text or re.search(r"\bmm\b|parts? of 1", text), name)

    def test_stubs_name_all_members(self) -> None:
        tree = ast.parse(STUBS.read_text())
        stubs = {
            node.name: {
                item.name for item in node.body if isinstance(item, ast.FunctionDef)
            }
            for node in tree.body
            if isinstance(node, ast.ClassDef)
        }
        functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
        for name, thing in vars(_core).items():
            if inspect.isclass(thing):
                self.assertIn(name, stubs)
                public = {one for one in stubs[name] if not one.startswith("_")}
                self.assertEqual(public, set(members(thing)), name)
            elif callable(thing):
                self.assertIn(name, functions)

    def test_the_page_names_all_of_it(self) -> None:
        page = (SOURCE / "docs" / "python.md").read_text()
        for name in toile.__all__:
            self.assertIn(name, page)


if __name__ == "__main__":
    unittest.main()
