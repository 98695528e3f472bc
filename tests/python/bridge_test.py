# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of other packages, by what they look like."""

import types
import unittest

import numpy as np
import toile
import toile.bridge
from support import grid


class Trimesh(unittest.TestCase):
    def test_what_looks_like_one(self) -> None:
        points, faces = grid(bump=5)
        mesh = types.SimpleNamespace(vertices=points, faces=faces.astype(np.int64))
        made = toile.bridge.from_trimesh(mesh, unit="mm")
        expected = toile.garment(points, faces, unit="mm")
        np.testing.assert_array_equal(
            made.flatten()[0].positions, expected.flatten()[0].positions
        )
        mesh.visual = types.SimpleNamespace(uv=points[:, :2] / 40)
        self.assertIsNotNone(toile.bridge.from_trimesh(mesh, unit="mm", split="uv")[0])


class HigherOrders(unittest.TestCase):
    """Cells with nodes on their edges; of what looks like a meshio.Mesh."""

    def area(self, kind: str, cells: list[list[int]]) -> float:
        axis = np.linspace(0, 20, 3)
        points = np.array([[x, y, 0] for y in axis for x in axis])
        mesh = types.SimpleNamespace(
            points=points,
            cells=[types.SimpleNamespace(type=kind, data=np.array(cells))],
            cell_data={},
            point_data={},
        )
        return sum(piece.area for piece in toile.bridge.from_meshio(mesh, unit="mm").pieces)

    def test_faces_are_those_of_the_corners(self) -> None:
        for kind, cells in {
            "triangle": [[0, 2, 8], [0, 8, 6]],
            "triangle6": [[0, 2, 8, 1, 5, 4], [0, 8, 6, 4, 7, 3]],
            "quad": [[0, 2, 8, 6]],
            "quad8": [[0, 2, 8, 6, 1, 5, 7, 3]],
            "quad9": [[0, 2, 8, 6, 1, 5, 7, 3, 4]],
            "polygon8": [[0, 1, 2, 5, 8, 7, 6, 3]],
        }.items():
            self.assertAlmostEqual(self.area(kind, cells), 400, msg=kind)


class Meshio(unittest.TestCase):
    def setUp(self) -> None:
        try:
            import meshio
        except ImportError:
            self.skipTest("needs meshio")
        self.meshio = meshio

    def test_there_and_back(self) -> None:
        points, faces = grid(bump=5)
        mesh = self.meshio.Mesh(
            points,
            [("line", faces[:2, :2]), ("triangle", faces[:16]), ("triangle", faces[16:])],
            cell_data={"groups": [np.zeros(2, int), np.zeros(16, int), np.ones(16, int)]},
        )
        made = toile.bridge.from_meshio(mesh, unit="mm", split="groups")
        self.assertEqual({piece.name.split()[0] for piece in made.pieces}, {"0", "1"})
        flat = toile.bridge.from_meshio(mesh, unit="mm", split="components").flatten()
        back = toile.bridge.to_meshio(flat)
        (block,) = back.cells
        self.assertEqual(block.data.shape, faces.shape)
        self.assertEqual(back.cell_data["piece"][0].tolist(), [0] * len(faces))
        edges = back.points[block.data[:, 0]] - back.points[block.data[:, 1]]
        own = flat[0].positions[flat[0].piece.faces]
        np.testing.assert_allclose(
            np.linalg.norm(edges, axis=1),
            np.linalg.norm(own[:, 0] - own[:, 1], axis=1),
            rtol=1e-9,
        )
        worn = toile.bridge.to_meshio(flat, worn=True)
        np.testing.assert_array_equal(worn.points, flat[0].piece.vertices)

    def test_no_group_is_no_name(self) -> None:
        points, faces = grid()
        for key, tags in (("obj:group_ids", [-1, 0]), ("gmsh:physical", [0, 1])):
            mesh = self.meshio.Mesh(
                points, [("triangle", faces)], cell_data={key: [np.repeat(tags, len(faces) // 2)]}
            )
            made = toile.bridge.from_meshio(mesh, unit="mm", split="groups")
            named = {piece.name.split()[0] for piece in made.pieces}
            self.assertEqual(named, {"piece", str(tags[1])})

    def test_strain_is_the_one_of_larger_size(self) -> None:
        points, faces = grid(8)
        points[:, 2] = (points[:, 0] - 40) * (points[:, 1] - 40) / 40  # a saddle
        flat = toile.garment(points, faces, unit="mm").flatten()
        (told,) = toile.bridge.to_meshio(flat).cell_data["strain"]
        strain = flat[0].strain
        np.testing.assert_array_equal(np.abs(told), np.abs(strain).max(axis=1))
        self.assertTrue((told == strain[:, 1]).any() and (told == strain[:, 0]).any())


if __name__ == "__main__":
    unittest.main()
