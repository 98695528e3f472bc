// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "core/garment/garment.h"
#include "core/geometry/line.h"
#include "core/pattern/outline_reference.h"
#include "core/pattern/segments.h"
#include "core/quality/measures.h"

namespace toile::test {

/// How unevenly an outline is curved: over all runs of eight points or more between cuts the mean
/// of |kappa(i + 1) - kappa(i)|, kappa = turn over the mean of the two edges, 1/mm.
struct Variation {
    double sum = 0;
    int count = 0;

    void add(const Points2& points, const std::set<int>& cuts) {
        const auto line = geometry::Line::closed(points);
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
    const auto reference = geometry::Line::closed((*piece.reference)(piece.boundary, Eigen::all));
    for (int k = 0; k < n; ++k) {
        if (std::abs(reference.turnAt(k)) > kLineCorner.turn) {
            cuts.insert(k);
        }
    }
    return cuts;
}

/// How well the corners that were found on an outline are the designer's: vertices of the reference
/// panel that turn by more than 25 degrees. Two within 5 mm along the outline are the same.
struct CornerScore {
    int designers = 0, seen = 0;  ///< the designer's; those of them that were found
    int found = 0, right = 0;     ///< those found; those of them that are the designer's

    void add(const Piece& piece, const OutlineSegments& segments) {
        const auto reference =
            geometry::Line::closed((*piece.reference)(piece.boundary, Eigen::all));
        const auto worn = geometry::Line::closed(reference.points(), outlineArc(piece));
        std::vector<double> there, here;
        for (int k = 0; k < reference.count(); ++k) {
            if (std::abs(reference.turnAt(k)) > kLineCorner.turn) {
                there.push_back(worn.arc()[static_cast<std::size_t>(k)]);
            }
        }
        for (const TurnPoint& point : segments.turnPoints) {
            if (point.isCorner) {
                here.push_back(point.at);
            }
        }
        const auto count = [&worn](const std::vector<double>& of, const std::vector<double>& in) {
            return static_cast<int>(std::ranges::count_if(of, [&](double a) {
                return std::ranges::any_of(in, [&](double b) { return worn.apart(a, b) < 5; });
            }));
        };
        designers += static_cast<int>(there.size());
        seen += count(there, here);
        found += static_cast<int>(here.size());
        right += count(here, there);
    }
    void add(const CornerScore& other) {
        designers += other.designers;
        seen += other.seen;
        found += other.found;
        right += other.right;
    }
    double recall() const { return designers > 0 ? static_cast<double>(seen) / designers : 1; }
    double precision() const { return found > 0 ? static_cast<double>(right) / found : 1; }
};

}  // namespace toile::test
