// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/garment/piece.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::test {

/// Small named shapes with known answers. Millimetres unless said otherwise.

/// Columns x rows squares in the plane z = 0, each cut by one diagonal; `size` is a square's side.
MeshArrays planeGrid(int columns, int rows, double size);
/// A square panel of 600 mm, of side x side squares, bent both ways as over a shoulder.
MeshArrays bentPanel(int side);
/// A cylinder's sector meshed along its rulings: flat when unrolled. Width is the arc's chord sum.
MeshArrays cylinderSector(int columns, int rows, double radius, double angle, double height);
/// A cone's sector meshed along its rulings, from radius `inner` to `outer` along the slant.
MeshArrays coneSector(int columns, int rows, double inner, double outer, double openingAngle,
                      double slope);
/// A spherical cap of concentric rings about +y; half angle in radians.
MeshArrays sphericalCap(int rings, double radius, double halfAngle);
/// z = bend * x * y over a square: negative curvature everywhere.
MeshArrays saddle(int side, double size, double bend);
/// The unit cube of [Wang05] Table 1, Example IV: 8 x 8 squares a side, 768 triangles, opened along
/// five cube edges shaped like an H. Diagonals alternate like a checkerboard.
MeshArrays cubeOpenedAlongH();
/// The same cube opened along a single edge: the iteration of [Wang05] from raw angles goes astray.
MeshArrays cubeSlitAlongOneEdge();
/// A quad strip closed with half a turn.
MeshArrays moebiusStrip(int quads);
/// A tube without caps: two boundary loops.
MeshArrays tube(int around, int along);
/// The surface of an octahedron: closed.
MeshArrays octahedron();
/// A torus with one triangle taken out: one loop and one handle.
MeshArrays piercedTorus(int around, int across);

/// The triangles whose middle is inside, with the vertices that they use.
MeshArrays part(const MeshArrays& mesh,
                const std::function<bool(const Eigen::RowVector3d& middle)>& inside);

/// The same surface with vertices renumbered and faces reordered and rotated, by a fixed seed.
struct Renumbered {
    MeshArrays mesh;
    std::vector<int> newIndex;  ///< of each old vertex
};

Renumbered renumber(const MeshArrays& mesh, unsigned seed);

/// The mesh as a checked piece.
std::shared_ptr<const Piece> asPiece(MeshArrays mesh, const std::string& name = "piece");
/// Makes it a piece of a division.
void identify(Piece& piece, std::uint64_t id);

/// Largest distance between two planar point sets after the best rigid motion (no reflection).
double distanceAfterRigidMotion(const Points2& P, const Points2& Q);

}  // namespace toile::test
