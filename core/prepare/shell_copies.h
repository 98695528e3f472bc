// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/prepare/shell_rays.h"

namespace toile::shell {

/// Follows two surfaces, one a copy of the other, polygon by polygon, as exporters create a
/// thickness: from one pair of polygons over their sides to the next, as long as they match.
class Copies {
public:
    Copies(const Surface& surface, Facing facing, double farthest);

    /// How two polygons match.
    struct Seed {
        double slant = 2;  ///< 1 - cosine between the normal and the way between corners
        int polygon = -1, other = -1;
        int shift = 0;  ///< index of the other's corner that matches the first corner
    };
    /// A seed with a slant of 2 if the polygons of a triangle and the one that it met do not match.
    Seed seedOf(int triangle, const Meeting& met) const;

    /// Accepts a seed and all pairs that follow from it, if none of them is taken.
    void follow(const Seed& seed);

    /// Whether a triangle's polygon has a copy.
    bool isPaired(int triangle) const { return mate_[polygon_[triangle]] >= 0; }
    /// Whether a triangle's polygon connects a vertex with its copy.
    bool isRim(int triangle) const;
    /// A triangle of the copy of a triangle's polygon. Precondition: isPaired
    int mateOf(int triangle) const { return firstTriangle_[mate_[polygon_[triangle]]]; }

    const std::vector<int>& partners() const { return partner_; }

private:
    struct SidePair {
        int side, other;
    };

    void addPolygon(int first, int last);
    void linkSides();
    int corners(int polygon) const { return start_[polygon + 1] - start_[polygon]; }
    int cornerAt(int polygon, int k) const {
        return corner_[start_[polygon] + k % corners(polygon)];
    }
    int mirrored(int other, int shift, int k) const;
    bool pairUp(const Seed& seed, double distance);
    double distance(int v, int w) const {
        return (surface_.mesh.V.row(v) - surface_.mesh.V.row(w)).norm();
    }

    const Surface& surface_;
    Facing facing_;
    double farthest_;
    std::vector<int> polygon_;        ///< per triangle
    std::vector<int> firstTriangle_;  ///< per polygon
    std::vector<int> start_{0};       ///< per polygon: of its corners; one more for the end
    std::vector<int> corner_;         ///< vertices
    std::vector<int> owner_;          ///< per corner: the polygon; side s begins at corner s
    std::vector<int> across_;         ///< per side: the only other one there, in reverse, or -1
    std::vector<int> mate_;           ///< per polygon, or -1
    std::vector<int> partner_;        ///< per vertex, or -1
    std::vector<SidePair> open_;
};

}  // namespace toile::shell
