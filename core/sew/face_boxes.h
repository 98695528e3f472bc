// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/triangle_tree.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::sew {

/// The boxes that triangles sweep on straight ways, in a tree: which of them another box meets.
/// Immutable; thread-safe.
class FaceBoxes {
public:
    /// Cost: n log n.
    FaceBoxes(const Points3& from, const Points3& to, const Triangles& F)
        : ends_(2 * F.rows(), 3), tree_(treeOf(from, to, F)) {}

    /// @param visit  the number of each triangle that is met, in an order of its own
    template <class Visit>
    void visitMet(const Eigen::RowVector3d& low, const Eigen::RowVector3d& high,
                  const Visit& visit) const {
        const auto isMet = [&](const auto& boxLow, const auto& boxHigh) {
            return (boxLow.array() <= high.array()).all() && (low.array() <= boxHigh.array()).all();
        };
        using Corner = Eigen::Map<const Eigen::RowVector3d>;
        const auto distanceTo = [&](const Tree::Box& box) {
            return isMet(Corner(box.low.data()), Corner(box.high.data())) ? 0 : Tree::kMissed;
        };
        tree_.search(distanceTo, [&](std::uint32_t face) {
            const auto row = 2 * static_cast<Eigen::Index>(face);
            if (isMet(ends_.row(row), ends_.row(row + 1))) {
                visit(static_cast<int>(face));
            }
        });
    }

private:
    using Tree = geometry::TriangleTree<3, double>;

    /// To the tree a box is a triangle, from its lowest corner to its highest.
    Tree treeOf(const Points3& from, const Points3& to, const Triangles& F) {
        std::vector<std::uint32_t> diagonals;
        diagonals.reserve(static_cast<std::size_t>(F.size()));
        for (Eigen::Index f = 0; f < F.rows(); ++f) {
            Eigen::RowVector3d low = from.row(F(f, 0)), high = low;
            for (int k = 0; k < 3; ++k) {
                low = low.cwiseMin(from.row(F(f, k))).cwiseMin(to.row(F(f, k)));
                high = high.cwiseMax(from.row(F(f, k))).cwiseMax(to.row(F(f, k)));
            }
            ends_.row(2 * f) = low;
            ends_.row(2 * f + 1) = high;
            const auto first = static_cast<std::uint32_t>(2 * f);
            diagonals.insert(diagonals.end(), {first, first + 1, first + 1});
        }
        return {ends_.data(), 3, diagonals};
    }

    Points3 ends_;  ///< two per triangle: the lowest corner of its box and the highest
    Tree tree_;
};

}  // namespace toile::sew
