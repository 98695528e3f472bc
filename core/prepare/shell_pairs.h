// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::shell {

/// Triangles with what is asked of them again and again.
struct Surface {
    MeshArrays mesh;        ///< open edges that lie on each other are one
    std::vector<int> face;  ///< the polygon that a triangle is part of; ascending
    Points3 normal;         ///< unit, per triangle; zero where it has no area
    Eigen::VectorXd area;   ///< mm2, per triangle
};

Surface surfaceWith(MeshArrays mesh, std::vector<int> face);

/// What lies opposite to what across the cloth.
struct Pairs {
    std::vector<int> partner;       ///< per vertex: its copy on the other surface, or -1
    std::vector<int> opposite;      ///< per triangle: one of the other surface, or -1
    std::vector<char> isRim;        ///< per triangle: joins a vertex with its partner
    Points3 across;                 ///< per triangle with an opposite: the way there
    std::vector<double> thickness;  ///< per triangle with an opposite, mm, along the normal
};

/// Largest of these values that counts as the same thickness as the least.
inline constexpr double kSameThickness = 1.5;

/// Which share of a weight lies within two spans of values, each from some value to kSameThickness
/// times as much.
/// @param valueAndWeight  reordered
double shareInTwoSpans(std::vector<std::pair<double, double>>& valueAndWeight);

/// None where a sample says that the surface faces no other at a thickness's distance.
std::optional<Pairs> findPairs(const Surface& surface, const Progress& progress);

}  // namespace toile::shell
