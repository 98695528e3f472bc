// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "core/io/soup.h"

namespace toile {

/// Finds the uv index of a face's corner at a position. If called face by face, the cost is linear
/// in the corners, even for one polygon with thousands. Keeps a reference. Not shareable.
class CornerUvs {
public:
    explicit CornerUvs(const PolygonSoup& soup) : soup_(soup) {}

    /// The index, or -1. Faces that repeat a position are dropped before, so the corner is unique.
    int at(int face, int position) {
        if (soup_.cornerUvs.empty()) {
            return -1;
        }
        const int first = soup_.faceStart[face];
        const int last = soup_.faceStart[face + 1];
        if (last - first <= kFew) {
            const auto begin = soup_.corners.begin();
            const auto found = std::find(begin + first, begin + last, position);
            return found == begin + last ? -1 : soup_.cornerUvs[found - begin];
        }
        if (face != face_) {
            sort(face);
        }
        const auto found =
            std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{position, -1});
        return found != sorted_.end() && found->first == position ? found->second : -1;
    }

private:
    static constexpr int kFew = 16;  // corners: a linear search is faster than sorting

    void sort(int face) {
        sorted_.clear();
        for (int c = soup_.faceStart[face]; c < soup_.faceStart[face + 1]; ++c) {
            sorted_.emplace_back(soup_.corners[c], soup_.cornerUvs[c]);
        }
        std::sort(sorted_.begin(), sorted_.end());
        face_ = face;
    }

    const PolygonSoup& soup_;
    int face_ = -1;
    std::vector<std::pair<int, int>> sorted_;  ///< position and uv of that face's corners
};

}  // namespace toile
