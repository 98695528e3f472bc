// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/garment/piece.h"

namespace toile {

/// The plane in which a garment is most nearly its own mirror image: normal . x = offset.
struct MirrorPlane {
    Eigen::Vector3d normal{1, 0, 0};  ///< unit; its largest component is positive
    double offset = 0;                ///< mm
    /// Distance from the reflected vertices to the garment's surface, mm: root of the mean square
    /// over the area, and the largest. Cloth that hangs is not symmetric: 5 to 20 mm are usual.
    double deviation = 0;
    double farthest = 0;

    Eigen::Vector3d reflected(const Eigen::Vector3d& p) const {
        return p - 2 * (normal.dot(p) - offset) * normal;
    }
};

/// A garment whose deviation is more than this part of its size (root mean square distance from its
/// centre) has no mirror plane. Draped garments have 0.01 to 0.05.
inline constexpr double kMaxMirrorDeviation = 0.06;
/// Nor is a plane one in which the garment lies: the root mean square distance from it must be at
/// least this part of that size.
inline constexpr double kMinMirrorWidth = 0.1;

/// Finds the plane by turns: vertices are reflected and paired with the nearest points of the
/// surface, and of all planes that which brings the pairs (x, x') together best, in the
/// least-squares sense, is taken next. Its normal is the eigenvector of the smallest eigenvalue of
/// sum w (x x'^T + x' x^T), about the means. The weights w are the vertices' areas, so that it
/// matters little how a piece is triangulated; pairs farther apart than three medians are left out.
/// It starts from the area's principal axes, and from the coordinate axes that are others, as a
/// round garment has no principal ones; the least deviation wins. At most 40 rounds from each, and
/// 40 more from the best.
/// None where even the least deviation is too large (`kMaxMirrorDeviation`), where the garment is a
/// line (`kMinMirrorWidth`), or without any area.
/// It follows from these pieces alone, and moves, turns and is reflected with them. Of large
/// garments every so many vertices are taken, 500 for the choice and 1500 for the plane.
/// @param pieces    as divided (`Garment::uncut`): where they are cut and sewn does not count
/// @param progress  polled from vertex to vertex; cancelled, there is none
/// Precondition: finite positions. Deterministic.
/// Cost: 40 rounds of these, with a search of O(log #F) for each vertex: a second, or two to three
/// for a hundred thousand vertices.  Pure.
std::optional<MirrorPlane> findMirrorPlane(const std::vector<std::shared_ptr<const Piece>>& pieces,
                                           const Progress& progress = {});

}  // namespace toile
