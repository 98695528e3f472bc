// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/seam/seam_measure.h"
#include "core/symmetry/mirror_segments.h"

namespace toile {
namespace {

/// The point half-way along a polyline, by length.
Eigen::Vector3d middleOf(const Points3& line) {
    double rest = 0;
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        rest += 0.5 * (line.row(i) - line.row(i - 1)).norm();
    }
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        const double length = (line.row(i) - line.row(i - 1)).norm();
        if (rest <= length && length > 0) {
            return line.row(i - 1) + rest / length * (line.row(i) - line.row(i - 1));
        }
        rest -= length;
    }
    return line.rows() > 0 ? Eigen::Vector3d(line.row(line.rows() - 1)) : Eigen::Vector3d::Zero();
}

/// A segment and its start on the outline.
struct PlacedSegment {
    double at;
    MirrorSegment segment;
};

}  // namespace

MirrorSegments seamSegments(const Garment& garment) {
    std::vector<std::vector<PlacedSegment>> placed(garment.pieces.size());
    const auto add = [&](const SeamSide& side, int neighbour, int seam, bool isRight) {
        if (side.piece < 0 || side.loop != 0) {
            return;
        }
        const Points3 line = spaceLine(side, *garment.pieces[side.piece]);
        placed[side.piece].push_back(
            {std::min(side.start, side.end),
             {side.piece, neighbour, side.length(), middleOf(line), seam, isRight}});
    };
    const std::vector<Seam>& seams = garment.seams.seams;
    for (int s = 0; s < static_cast<int>(seams.size()); ++s) {
        add(seams[s].left, seams[s].right.piece, s, false);
        if (!seams[s].stacked) {
            add(seams[s].right, seams[s].left.piece, s, true);
        }
    }
    MirrorSegments segments(garment.pieces.size());
    for (std::size_t p = 0; p < placed.size(); ++p) {
        std::ranges::stable_sort(placed[p], {}, &PlacedSegment::at);
        for (const PlacedSegment& one : placed[p]) {
            segments[p].push_back(one.segment);
        }
    }
    return segments;
}

}  // namespace toile
