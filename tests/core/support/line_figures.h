// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "core/garment/garment.h"
#include "core/pattern/segments.h"
#include "core/quality/closed_line.h"
#include "core/quality/measures.h"

namespace toile::test {

/// How unevenly an outline is curved: over all runs of eight points or more between cuts the mean
/// of |kappa(i + 1) - kappa(i)|, kappa = turn over the mean of the two edges, 1/mm.
struct Variation {
    double sum = 0;
    int count = 0;

    void add(const Points2& points, const std::set<int>& cuts) {
        const ClosedLine line(points);
        const int n = line.count();
        const auto kappa = [&](int k) -> double {
            const int at = k % n, before = (at + n - 1) % n;
            const double edges =
                line.arc()[at + 1] - line.arc()[at] + line.arc()[before + 1] - line.arc()[before];
            return line.turnAt(at) / (edges / 2);
        };
        const std::vector<int> ends(cuts.begin(), cuts.end());
        for (std::size_t c = 0; c < ends.size(); ++c) {
            const int last = c + 1 < ends.size() ? ends[c + 1] : ends[0] + n;
            if (last - ends[c] + 1 < 8) {
                continue;
            }
            for (int k = ends[c] + 1; k + 1 < last; ++k) {
                sum += std::abs(kappa(k + 1) - kappa(k));
                ++count;
            }
        }
    }
};

/// The vertices of a piece's outline where it is cut for that: ends of seams, and corners of the
/// reference panel of more than 25 degrees.
inline std::set<int> referenceCuts(const Garment& garment, std::size_t index,
                                   const OutlineSegments& segments) {
    const Piece& piece = *garment.pieces[index];
    const Eigen::VectorXd lengths = boundaryLengths3d(piece.mesh.V, piece.boundary);
    const int n = static_cast<int>(piece.boundary.size());
    std::set<int> cuts;
    for (const TurnPoint& point : segments.turnPoints) {
        double at = 0;
        int nearest = 0;
        double least = 1e300;
        for (int k = 0; k < n; at += lengths[k], ++k) {
            if (std::abs(at - point.at) < least) {
                least = std::abs(at - point.at);
                nearest = k;
            }
        }
        if (point.isSeamEnd) {
            cuts.insert(nearest);
        }
    }
    const ClosedLine reference((*piece.reference)(piece.boundary, Eigen::all));
    for (int k = 0; k < n; ++k) {
        if (std::abs(reference.turnAt(k)) > kCornerTurn) {
            cuts.insert(k);
        }
    }
    return cuts;
}

}  // namespace toile::test
