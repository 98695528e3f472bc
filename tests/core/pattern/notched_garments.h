// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/pattern/notches.h"
#include "core/toile/pipeline.h"

namespace toile::test {

/// A garment with all that notches follow from.
struct Notched {
    Garment garment;
    PieceResults results;
    std::vector<OutlineSegments> segments;
    std::optional<Symmetry> symmetry{};

    std::vector<std::vector<Notch>> found(const NotchRules& rules = {}) const {
        return findNotches(garment, results, segments, rules, symmetry ? &*symmetry : nullptr);
    }
    /// Fails the test where there is none of that name.
    int indexOf(const std::string& name) const;
};

Notched notched(Garment garment, const LineSettings& lines = {}, Method method = Method::Curvature);

/// Of the samples or of the shared data.
Garment garmentFrom(const std::string& file);

/// Pieces "a", "b" and so on that are sewn where they meet. Of flat rectangles in the plane z = 0
/// the flat outlines are they themselves.
Garment plane(const std::vector<MeshArrays>& meshes);

}  // namespace toile::test
