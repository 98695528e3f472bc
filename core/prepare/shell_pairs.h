// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::shell {

/// Triangles with values that are used repeatedly.
struct Surface {
    MeshArrays mesh;        ///< coinciding open edges are merged
    std::vector<int> face;  ///< the polygon of each triangle; ascending
    Points3 normal;         ///< unit, per triangle; zero if it has no area
    Eigen::VectorXd area;   ///< mm2, per triangle
};

Surface surfaceWith(MeshArrays mesh, std::vector<int> face);

/// Opposite triangles and vertices across the cloth.
struct Pairs {
    std::vector<int> partner;       ///< per vertex: its copy on the other surface, or -1
    std::vector<int> opposite;      ///< per triangle: one of the other surface, or -1
    std::vector<char> isRim;        ///< per triangle: joins a vertex with its partner
    Points3 across;                 ///< per triangle with an opposite: the vector to it
    std::vector<double> thickness;  ///< per triangle with an opposite, mm, along the normal
};

/// Largest ratio of thicknesses that count as the same.
inline constexpr double kSameThickness = 1.5;

/// The largest share of weight within two spans of values, each from some value to kSameThickness
/// times that.
/// @param valueAndWeight  is reordered
double shareInTwoSpans(std::vector<std::pair<double, double>>& valueAndWeight);

/// Nothing if a sample shows that the surface faces no other at the distance of a thickness.
std::optional<Pairs> findPairs(const Surface& surface, const Progress& progress);

}  // namespace toile::shell
