// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/soup.h"

namespace toile {

/// The names of one kind, and the index of each face's name: -1 for none. Empty: no names.
struct ArrayNames {
    std::vector<std::string> names{};
    std::span<const int> ofFace{};  ///< one per face, or empty
};

/// A mesh in a caller's memory, row by row.
struct MeshInArrays {
    std::span<const double> positions;  ///< three numbers each
    std::span<const double> uvs{};      ///< two numbers each
    std::span<const int> faceStart;     ///< #faces + 1, ascending from 0 to #corners
    std::span<const int> corners;       ///< position index per corner
    std::span<const int> cornerUvs{};   ///< uv index per corner, -1 for none; empty: no uvs
    ArrayNames objects{}, groups{}, materials{};
    /// Decimals with which an export repeats the positions, as a file's own digits; negative: as
    /// many as reproduce the numbers.
    int decimals = -1;
};

/// The soup that a reader makes of a file with this mesh: invalid rows are dropped and listed by
/// their index, from 0.
/// @param name  used in messages only
/// Precondition: the sizes fit each other. Errors: NoGeometry. Cost: linear, one copy. Pure.
Result<PolygonSoup> soupOfArrays(const MeshInArrays& mesh, const std::string& name);

}  // namespace toile
