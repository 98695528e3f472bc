// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/trueing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/QR>

#include "core/geometry/disjoint_sets.h"
#include "core/geometry/line.h"
#include "core/seam/seam_settings.h"

namespace toile {
namespace {

/// Largest distance of a seam's end from its turn point, mm.
constexpr double kAtTurnPoint = 1e-3;
/// Tolerance for equal places on a line, as shares of it.
constexpr double kSameEnd = 1e-6;

std::optional<OutlineCorner> cornerAt(const std::vector<OutlineSegments>& segments,
                                      const SeamSide& side, double at) {
    if (side.loop != 0) {
        return std::nullopt;
    }
    const OutlineSegments& of = segments[side.piece];
    double perimeter = 0;
    for (const Segment& segment : of.segments) {
        perimeter += segment.length();
    }
    for (std::size_t k = 0; k < of.turnPoints.size(); ++k) {
        const double off = std::remainder(of.turnPoints[k].at - at, perimeter);
        if (std::abs(off) < kAtTurnPoint && keepsTurn(of.turnPoints[k])) {
            return OutlineCorner{side.piece, static_cast<int>(k)};
        }
    }
    return std::nullopt;
}

const TurnPoint& pointOf(const std::vector<OutlineSegments>& segments,
                         const OutlineCorner& corner) {
    return segments[corner.piece].turnPoints[corner.point];
}

/// Settings of single ends, by seam and end.
std::map<std::pair<int, bool>, bool> statedOf(const SeamGraph& graph,
                                              const LineSettings& settings) {
    std::map<std::pair<int, bool>, bool> stated;
    for (const SeamEndSettings& one : settings.seamEnds) {
        const int found = seamAt(graph, one.seam);
        if (found < 0) {
            continue;
        }
        // If the sides have been exchanged, the seam runs in the opposite direction.
        const SeamPlace& place = graph.seams[found].place;
        const bool isTurned =
            covered(one.seam.left, place.right) > covered(one.seam.left, place.left);
        const LineStretch& there = isTurned ? place.right : place.left;
        const double off =
            one.atEnd ? there.to - one.seam.left.to : there.from - one.seam.left.from;
        if (std::abs(std::remainder(off, 1)) < kSameEnd) {  // else a cut has removed that end
            stated[{found, one.atEnd != isTurned}] = one.trued;
        }
    }
    return stated;
}

/// Numbers corners in order of occurrence.
class Numbers {
public:
    int of(const OutlineCorner& corner) {
        const auto [known, isNew] =
            number_.emplace(std::pair(corner.piece, corner.point), static_cast<int>(all_.size()));
        if (isNew) {
            all_.push_back(corner);
        }
        return known->second;
    }
    const std::vector<OutlineCorner>& all() const { return all_; }

private:
    std::map<std::pair<int, int>, int> number_;
    std::vector<OutlineCorner> all_;
};

/// Trues connected ends: at each, the turns of both corners together increase by its kink.
void trueTogether(const std::vector<const SeamEnd*>& ends,
                  std::vector<std::vector<double>>& turns) {
    Numbers corners;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(ends.size(), 2 * ends.size());
    Eigen::VectorXd kinks(ends.size());
    for (std::size_t row = 0; row < ends.size(); ++row) {
        A(row, corners.of(ends[row]->left)) += 1;
        A(row, corners.of(ends[row]->right)) += 1;
        kinks[row] = ends[row]->kink;
    }
    // Rows may be linearly dependent if four pieces meet.
    const Eigen::VectorXd change =
        A.leftCols(corners.all().size()).completeOrthogonalDecomposition().solve(kinks);
    for (std::size_t k = 0; k < corners.all().size(); ++k) {
        turns[corners.all()[k].piece][corners.all()[k].point] = change[k];
    }
}

}  // namespace

double kinkOf(double turnLeft, double turnRight) {
    return std::numbers::pi - turnLeft - turnRight;
}

double drawnTurn(const PieceResult& result, const TurnPoint& point) {
    if (!result.flat || !result.flat->line) {
        return point.turn;
    }
    const FlatLine& line = *result.flat->line;
    const auto byArc = geometry::Line::closed(line.points, line.arc);
    const auto apart = [&](double arc) { return byArc.apart(arc, point.at); };
    const auto nearest = std::ranges::min_element(line.arc.begin(), line.arc.end() - 1, {}, apart);
    const double turn = byArc.turnAt(static_cast<int>(nearest - line.arc.begin()));
    return point.turn + std::remainder(turn - point.turn, 2 * std::numbers::pi);
}

std::vector<SeamEnd> findSeamEnds(const Garment& garment,
                                  const std::vector<OutlineSegments>& segments,
                                  const LineSettings& settings) {
    const auto stated = statedOf(garment.seams, settings);
    std::vector<SeamEnd> ends;
    for (std::size_t s = 0; s < garment.seams.seams.size(); ++s) {
        const Seam& seam = garment.seams.seams[s];
        if (seam.kind == SeamKind::Free || seam.closed || seam.stacked || seam.right.piece < 0) {
            continue;
        }
        for (const bool atEnd : {false, true}) {
            const auto left =
                cornerAt(segments, seam.left, atEnd ? seam.left.end : seam.left.start);
            const auto right =
                cornerAt(segments, seam.right, atEnd ? seam.right.end : seam.right.start);
            const bool isFoldEnd =
                left && right && left->piece == right->piece && left->point == right->point;
            if (!left || !right || isFoldEnd) {
                continue;
            }
            SeamEnd end{static_cast<int>(s), atEnd, *left, *right};
            end.kink = kinkOf(pointOf(segments, *left).turn, pointOf(segments, *right).turn);
            if (std::abs(end.kink) <= kMaxKink) {
                const auto known = stated.find({end.seam, atEnd});
                end.isTrued = known != stated.end() ? known->second
                                                    : std::abs(end.kink) <= settings.trueBelow;
                ends.push_back(end);
            }
        }
    }
    return ends;
}

std::vector<std::vector<double>> truedTurns(const std::vector<OutlineSegments>& segments,
                                            const std::vector<SeamEnd>& ends) {
    std::vector<std::vector<double>> turns(segments.size());
    for (std::size_t p = 0; p < segments.size(); ++p) {
        turns[p].assign(segments[p].turnPoints.size(), 0);
    }
    Numbers corners;
    std::vector<const SeamEnd*> requested;
    for (const SeamEnd& end : ends) {
        if (end.isTrued) {
            requested.push_back(&end);
            corners.of(end.left);
            corners.of(end.right);
        }
    }
    geometry::DisjointSets groups(static_cast<int>(corners.all().size()));
    for (const SeamEnd* end : requested) {
        groups.join(corners.of(end->left), corners.of(end->right));
    }
    std::map<int, std::vector<const SeamEnd*>> together;
    for (const SeamEnd* end : requested) {
        together[groups.root(corners.of(end->left))].push_back(end);
    }
    for (const auto& [group, members] : together) {
        trueTogether(members, turns);
    }
    return turns;
}

}  // namespace toile
