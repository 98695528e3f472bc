// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>

#include "core/cut/cut_along.h"
#include "core/cut/surface_paths.h"

namespace toile::test {

double totalArea(const MeshArrays& mesh);
/// Of all corners, in radians.
double leastAngle(const MeshArrays& mesh);
int rimEdgeCount(const MeshArrays& mesh);
int componentCount(const MeshArrays& mesh);

/// A point of a random triangle; the engine's own numbers, so the same everywhere.
SurfacePoint randomPoint(const MeshArrays& mesh, std::mt19937& random);
/// The shortest path between two of them.
Result<PathPolyline> randomPath(const SurfaceLinks& links, std::mt19937& random);

/// Expects what holds for every cut: same area, every part on its source's side with an area above
/// zero, vertices where they say they are, runs whose sides lie at the same places and are rims,
/// and no rim but the old one and the cuts.
void expectValidCut(const MeshArrays& source, const CutResult& cut, const std::string& what);

/// Expects every connected part to be a disk; returns how many there are.
int expectDisks(const MeshArrays& mesh, const std::string& what);

}  // namespace toile::test
