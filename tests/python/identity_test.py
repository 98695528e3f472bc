# SPDX-License-Identifier: GPL-3.0-or-later
"""What is the same is equal, and what never changes is its own copy and stays where it is."""

import copy
import pickle
import unittest
from typing import Any

import toile
from support import sample


class Identity(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.tee = toile.load(sample("tshirt.obj"), unit="mm")
        cls.flat = cls.tee.flatten()

    def things(self) -> list[Any]:
        """Asked for anew each time."""
        return [
            self.flat.garment,
            *self.tee.pieces,
            *self.tee.seams,
            self.flat.seams[0].seam,
            *self.flat.pieces,
            *self.flat.seams,
            self.flat.pattern,
            *self.flat.pattern.pieces,
        ]

    def test_the_same_things_are_equal_and_hash_alike(self) -> None:
        once, again = self.things(), self.things()
        self.assertEqual(once, again)
        self.assertEqual([hash(one) for one in once], [hash(one) for one in again])
        self.assertEqual(len({*once, *again}), len(once) - 1, "one seam is asked for twice")
        self.assertEqual(self.tee["front"], self.flat["front"].piece)
        self.assertEqual(self.flat.garment, self.tee)

    def test_others_are_not(self) -> None:
        other = toile.load(sample("tshirt.obj"), unit="mm")
        self.assertNotEqual(self.tee, other)
        self.assertNotEqual(self.tee["front"], other["front"])
        self.assertNotEqual(self.tee["front"], self.tee["back"])
        self.assertNotEqual(self.tee["front"], self.flat["front"])
        self.assertNotEqual(self.tee["front"], "front")
        self.assertNotEqual(self.tee.seams[0], self.tee.seams[1])

    def test_names_and_pieces_are_in_it(self) -> None:
        for of, other in ((self.tee, self.flat), (self.flat, self.tee)):
            self.assertIn("front", of)
            self.assertIn(of["front"], of)
            self.assertIn(of[-1], of)
            self.assertNotIn(other["front"], of)
            for key in ("no such piece", "\udcff", "\ud800", 0, None, 1.5):
                self.assertNotIn(key, of)
            for key in ("no such piece", "\udcff", "\ud800"):
                with self.assertRaises(KeyError):
                    of[key]

    def test_a_slice_is_a_list(self) -> None:
        for of in (self.tee, self.flat):
            for part in (slice(0, 2), slice(None), slice(None, None, -2), slice(5, 99)):
                self.assertEqual(of[part], list(of.pieces)[part])

    def test_a_copy_is_the_thing(self) -> None:
        for thing in self.things():
            self.assertIs(copy.copy(thing), thing)
            self.assertIs(copy.deepcopy([thing])[0], thing)

    def test_what_to_pass_between_processes_is_said(self) -> None:
        for thing in self.things():
            with self.assertRaises(TypeError) as caught:
                pickle.dumps(thing)
            self.assertIn("pass paths or arrays between processes", str(caught.exception))
            self.assertIn(f"toile.{type(thing).__name__} ", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
