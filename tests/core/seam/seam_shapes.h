// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/garment/piece.h"
#include "core/garment/seam.h"

namespace toile::test {

/// A rectangle in the plane z = 0 with its lower left corner at (x, y): columns x rows squares.
MeshArrays rectangle(double x, double y, double width, double height, int columns, int rows);
/// The mesh with every triangle wound the other way.
MeshArrays woundAgainst(MeshArrays mesh);
/// The mesh opened along a vertical slit: the `steps` lowest edges of column `column` of a grid
/// with `columns` columns.
MeshArrays withSlit(MeshArrays mesh, int columns, int column, int steps);
/// Copies that know the positions they share: vertices at one place get one source vertex.
Pieces welded(const Pieces& pieces);

/// The seams of a kind.
std::vector<Seam> only(const SeamGraph& graph, SeamKind kind);
/// The seam or edge of that name; fails the test where there is none.
Seam named(const SeamGraph& graph, const std::string& name);
/// One line per seam with its name and lengths to `digits` decimals of the `unit`, sorted.
std::vector<std::string> summary(const SeamGraph& graph, double unit = 1, int digits = 6);
/// Checks what holds for every seam graph: matches are monotone and reach from end to end, places
/// are in range, edges know their seams, and sewn and free edges cover each outline.
void expectValid(const SeamGraph& graph, const Pieces& pieces);

}  // namespace toile::test
