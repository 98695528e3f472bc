// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/mirrored_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/line.h"
#include "core/symmetry/mirrored_pair.h"

namespace toile {
namespace {

/// Places in 3D of all rows of a line, given those of some rows; interpolated by length along the
/// rows.
/// @param rowOf  per known point  @param arc  places of these points, and of the first one again
/// @return one per row, plus that of row 0 a turn later; ascending
std::vector<double> placesOfRows(const Points2& rows, const std::vector<int>& rowOf,
                                 const std::vector<double>& arc) {
    const auto line = geometry::Line::closed(rows);
    const int m = line.count();
    std::vector<double> places(static_cast<std::size_t>(m) + 1);
    for (std::size_t k = 0; k < rowOf.size(); ++k) {
        const int first = rowOf[k], next = rowOf[(k + 1) % rowOf.size()];
        const int count = next > first ? next - first : next - first + m;
        const auto at = [&](int r) { return line.arc()[r % m] + (r < m ? 0 : line.length()); };
        for (int r = first; r < first + count; ++r) {
            const double share = (at(r) - at(first)) / (at(first + count) - at(first));
            places[r % m] = (1 - share) * arc[k] + share * arc[k + 1];
        }
    }
    const double turn = arc.back() - arc.front();
    for (int r = 1; r < m; ++r) {
        places[r] += places[r] < places[0] ? turn : 0;
    }
    places[m] = places[0] + turn;
    return places;
}

/// The line of the rows, starting at point 0 of the outline.
OutlineReference referenceFrom(const Points2& rows, const std::vector<double>& places,
                               const std::vector<int>& rowOf, const OutlineReference& outline) {
    const auto m = static_cast<int>(rows.rows());
    OutlineReference from;
    from.points.resize(m, 2);
    const double start = places[rowOf.front()];
    for (int r = 0; r < m; ++r) {
        const int row = (rowOf.front() + r) % m;
        from.points.row(r) = rows.row(row);
        const double past = places[row] - start;
        from.arc.push_back(row < rowOf.front() ? past + outline.arc.back() : past);
    }
    from.arc.push_back(outline.arc.back());
    from.turn.assign(static_cast<std::size_t>(m), 0);
    for (std::size_t k = 0; k < rowOf.size(); ++k) {
        const int r = (rowOf[k] - rowOf.front() + m) % m;
        from.turn[r] = outline.turn[k];
        from.arc[r] = outline.arc[k];
    }
    return from;
}

/// Pairs the rows of a line with those of its mirror image, which run backwards.
MirrorPlaces mirrorPlaces(const std::vector<double>& of, std::vector<double> image) {
    std::ranges::reverse(image);
    return {of, std::move(image)};
}

/// Shifts the values by whole turns so that the first lies within the first turn.
std::vector<double> fromFirstTurn(std::vector<double> arc) {
    const double turn = arc.back() - arc.front();
    const double before = std::floor(arc.front() / turn) * turn;
    for (double& place : arc) {
        place -= before;
    }
    return arc;
}

FlatLine imageOf(FlatLine line, const MirrorPlaces& places) {
    const auto n = line.points.rows();
    Points2 points(n, 2);
    std::vector<double> arc;
    for (Eigen::Index k = 0; k < n; ++k) {
        const Eigen::Index of = n - 1 - k;
        points.row(k) << -line.points(of, 0), line.points(of, 1);
        arc.push_back(places(line.arc[of]));
    }
    arc.push_back(places(line.arc[n - 1] - (line.arc.back() - line.arc.front())));
    line.points = std::move(points);
    line.arc = fromFirstTurn(std::move(arc));
    return line;
}

/// Makes the line symmetric about the places that mirror themselves: the first and the middle row.
Result<FlatLine> symmetricAbout(FlatLine line, const MirrorPlaces& places) {
    const auto byArc = geometry::Line::closed(line.points, line.arc);
    const auto flat = geometry::Line::closed(line.points);
    const double from = byArc.placeOn(flat, places.rising.front());
    const double to = byArc.placeOn(flat, places.rising[places.rising.size() / 2]);
    auto made = symmetricLine(line.points, flat.wrap(from), flat.wrap(to));
    if (!made) {
        return made.error();
    }
    line.arc = fromFirstTurn(placesOfRows(made->line, made->row, line.arc));
    line.points = std::move(made->line);
    return line;
}

/// The segments of a piece in the plane.
class FlatSegments {
public:
    FlatSegments(const Garment& garment, const std::vector<MirrorSegment>& segments,
                 const OutlineReference& outline)
        : flat_(geometry::Line::closed(outline.points)) {
        const auto byArc = geometry::Line::closed(outline.points, outline.arc);
        for (const MirrorSegment& one : segments) {
            const SeamSide& side = sideOf(garment, one);
            const auto [low, high] = std::minmax(side.start, side.end);
            starts_.push_back(byArc.placeOn(flat_, low));
            ends_.push_back(byArc.placeOn(flat_, high));
        }
    }

    double start(int segment) const { return flat_.wrap(starts_[segment]); }
    double end(int segment) const { return flat_.wrap(ends_[segment]); }
    double length(int segment) const { return ends_[segment] - starts_[segment]; }
    double middle(int segment) const { return flat_.wrap((starts_[segment] + ends_[segment]) / 2); }
    double perimeter() const { return flat_.length(); }
    /// Whether the segments cover the whole outline.
    bool coverAll() const {
        double sum = 0;
        for (std::size_t k = 0; k < starts_.size(); ++k) {
            sum += ends_[k] - starts_[k];
        }
        return std::abs(sum - flat_.length()) < kSameLength;
    }

private:
    geometry::Line flat_;
    std::vector<double> starts_, ends_;
};

/// Two pieces that may be mirror images of each other, or one piece and itself.
class Mirrored {
public:
    Mirrored(const Garment& garment, const PieceResults& exact, const Symmetry& symmetry, int a,
             int b)
        : pairs_(symmetry.pairs[a]),
          count_(static_cast<int>(pairs_.size())),
          outlineA_(referenceOf(*exact[a]->piece, *exact[a]->flat)),
          outlineB_(referenceOf(*exact[b]->piece, *exact[b]->flat)),
          a_(garment, symmetry.segments[a], outlineA_),
          b_(garment, symmetry.segments[b], outlineB_) {}

    bool correspond() const {
        for (int i = 0; i < count_; ++i) {
            const int there = pairs_[i], next = pairs_[(i + 1) % count_];
            if (there < 0 || next != (there + count_ - 1) % count_ ||
                std::abs(a_.length(i) - b_.length(there)) > kSameLength) {
                return false;
            }
        }
        return count_ > 1 && a_.coverAll() && b_.coverAll();
    }

    /// Precondition: they correspond.
    Result<MirroredOutline> pair(Mirror mirror) const {
        std::vector<MirrorEnd> ends;
        ends.reserve(pairs_.size());
        for (int i = 0; i < count_; ++i) {
            ends.push_back({a_.start(i), b_.end(pairs_[i])});
        }
        auto mean = meanLine(outlineA_.points, outlineB_.points, ends);
        if (!mean) {
            return mean.error();
        }
        const auto placesA = placesOfRows(mean->a, mean->rowOfA, outlineA_.arc);
        const auto placesB = placesOfRows(mean->b, mean->rowOfB, outlineB_.arc);
        if (mirror == Mirror::First) {
            const auto exact = geometry::Line::closed(outlineA_.points, outlineA_.arc);
            for (Eigen::Index r = 0; r < mean->a.rows(); ++r) {
                mean->a.row(r) = exact.pointAt(placesA[r]);
            }
        }
        return MirroredOutline{referenceFrom(mean->a, placesA, mean->rowOfA, outlineA_),
                               mirrorPlaces(placesA, placesB)};
    }

    /// Precondition: it corresponds to itself.
    Result<MirroredOutline> own() const {
        std::vector<double> fixed;
        for (int i = 0; i < count_; ++i) {
            if (pairs_[i] == i) {
                fixed.push_back(a_.middle(i));
            }
            if (pairs_[i] == (i + 1) % count_) {
                fixed.push_back(a_.end(i));
            }
        }
        const double half = fixed.size() == 2 ? std::abs(fixed[1] - fixed[0]) : 0;
        if (std::abs(half - a_.perimeter() / 2) > kSameLength) {
            return Error{ErrorCode::LineNotDrawn};
        }
        auto made = symmetricLine(outlineA_.points, fixed[0], fixed[1]);
        if (!made) {
            return made.error();
        }
        const auto places = placesOfRows(made->line, made->row, outlineA_.arc);
        return MirroredOutline{referenceFrom(made->line, places, made->row, outlineA_),
                               mirrorPlaces(places, places), false, true};
    }

private:
    const std::vector<int>& pairs_;
    int count_;
    OutlineReference outlineA_, outlineB_;
    FlatSegments a_, b_;
};

/// Signed distance of a piece from the plane, mm.
double sideOf(const Piece& piece, const MirrorPlane& plane) {
    return piece.mesh.V.colwise().mean().dot(plane.normal) - plane.offset;
}

}  // namespace

double MirrorPlaces::operator()(double place) const {
    const double turn = rising.back() - rising.front();
    const double turns = std::floor((place - rising.front()) / turn);
    const double within = place - turns * turn;
    const auto next = std::upper_bound(rising.begin() + 1, rising.end() - 1, within);
    const auto k = static_cast<std::size_t>(next - rising.begin()) - 1;
    const double t = (within - rising[k]) / (rising[k + 1] - rising[k]);
    return (1 - t) * falling[k] + t * falling[k + 1] + turns * (falling.back() - falling.front());
}

std::vector<MirrorPlan> planMirrors(const Garment& garment, const PieceResults& exact,
                                    const Symmetry& symmetry, Mirror mirror) {
    std::vector<MirrorPlan> plans(exact.size());
    for (int p = 0; p < static_cast<int>(exact.size()); ++p) {
        const int q = symmetry.pieces.counterpart[p];
        const bool isKept = !symmetry.kept.empty() && symmetry.kept[p];
        if (q < p || isKept || !exact[p] || !exact[q] || !exact[p]->flat || !exact[q]->flat) {
            continue;
        }
        const bool leads = sideOf(*garment.pieces[p], symmetry.plane) >=
                           sideOf(*garment.pieces[q], symmetry.plane);
        const int lead = leads ? p : q, other = leads ? q : p;
        const Mirrored mirrored(garment, exact, symmetry, lead, other);
        if (!mirrored.correspond()) {
            continue;
        }
        auto outline = p == q ? mirrored.own() : mirrored.pair(mirror);
        if (outline) {
            outline->lead = garment.pieces[lead]->id;
            plans[lead] = {lead, *outline};
            plans[other] = {lead, *outline};
            plans[other].outline.isImage = p != q;
        }
    }
    return plans;
}

FlatLine lineOf(const OutlineReference& reference) {
    FlatLine line;
    line.points = reference.points;
    line.arc = reference.arc;
    return line;
}

Result<FlatLine> mirroredFor(const MirroredOutline& outline, FlatLine line) {
    return outline.isSymmetric ? symmetricAbout(std::move(line), outline.places)
           : outline.isImage   ? imageOf(std::move(line), outline.places)
                               : Result<FlatLine>(std::move(line));
}

}  // namespace toile
