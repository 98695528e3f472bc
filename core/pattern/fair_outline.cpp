// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/fair_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/flatten/boundary/boundary_problem.h"
#include "core/geometry/segment.h"
#include "core/geometry/segment_pairs.h"
#include "core/pattern/fair_line.h"
#include "core/quality/closed_line.h"

namespace toile {
namespace {

/// A step of the line, mm: its chords are some micrometres short of a curve in 400 mm.
constexpr double kStep = 2;
/// No more than about so many steps, however large the piece, and no fewer, however small.
constexpr double kMaxSteps = 20000, kMinSteps = 24;
/// The solver's numbers end where waves are smoothed that are this many steps long.
constexpr double kMaxSmoothedSteps = 40;
/// No outline strays by more than this part of its length.
constexpr double kPerimeterPart = 0.02;
/// Two stretches are the sides of a band where the way around is so many times the way across.
constexpr double kBandWay = 6;
/// The part of a band's width that either side may stray.
constexpr double kBandPart = 0.25;
/// The least tolerance, mm: below it the line is the exact one for all that one can see.
constexpr double kLeastTolerance = 0.02;

/// The exact outline, with two measures along it: where it is in 3D, and its length in the plane.
class ExactOutline {
public:
    explicit ExactOutline(const OutlineReference& reference)
        : byArc_(reference.points, reference.arc),
          flat_(reference.points),
          turnIn3d_(reference.turn) {}

    const ClosedLine& flat() const { return flat_; }
    const ClosedLine& byArc() const { return byArc_; }

    /// The length in the plane up to a place in 3D, over any number of turns; and back.
    double flatAt(double arc) const { return byArc_.placeOn(flat_, arc); }
    double arcAt(double flat) const { return flat_.placeOn(byArc_, flat); }
    /// What it turns by at a vertex: of the full turns that cannot be told apart, as in 3D.
    double turnAt(int k) const {
        return turnIn3d_[k] + std::remainder(flat_.turnAt(k) - turnIn3d_[k], 2 * std::numbers::pi);
    }

private:
    ClosedLine byArc_, flat_;
    std::vector<double> turnIn3d_;
};

/// The outline with some stretches straight: the boundary problem with each of them as one edge,
/// whose ends take half of what it turned by; laid over the outline as it was.
class StraightenedOutline {
public:
    StraightenedOutline(const ExactOutline& exact, const OutlinePlan& plan) : exact_(exact) {
        const ClosedLine& flat = exact.flat();
        std::vector<std::pair<double, double>> runs;  // in the plane
        for (const OutlinePlan::Stretch& stretch : plan.stretches) {
            if (stretch.straight) {
                runs.emplace_back(exact.flatAt(stretch.from), exact.flatAt(stretch.to));
            }
        }
        for (int k = 0; k < flat.count(); ++k) {
            const double at = flat.arc()[k];
            if (std::ranges::none_of(runs, [&](const auto& run) { return isIn(at, run); })) {
                places_.push_back(at);
            }
        }
        for (const auto& [from, to] : runs) {
            places_.push_back(flat.wrap(from));
            places_.push_back(flat.wrap(to));
        }
        std::ranges::sort(places_);
        const auto same = [](double a, double b) { return b - a < kSamePlace; };
        places_.erase(std::unique(places_.begin(), places_.end(), same), places_.end());
        for (int k = 0; k < flat.count(); ++k) {
            turned_.push_back(turned_.back() + exact.turnAt(k));
        }
    }

    Result<void> solve(const Progress& progress) {
        const auto n = static_cast<Eigen::Index>(places_.size());
        BoundaryProblem problem{Eigen::VectorXd(n), Eigen::VectorXd(n)};
        Eigen::VectorXd turn(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            problem.lengths[i] = place(i + 1) - place(i);
            turn[i] = turnAt(place(i)) + 0.5 * (turnBetween(place(i - 1), place(i)) +
                                                turnBetween(place(i), place(i + 1)));
        }
        problem.angles = std::numbers::pi - turn.array();  // what is over is spread by the solver
        auto solved = solveBoundary(problem, BoundarySolver::Newton, progress);
        if (!solved) {
            return solved.error();
        }
        Points2 before(n, 2);
        for (Eigen::Index i = 0; i < n; ++i) {
            before.row(i) = exact_.flat().pointAt(places_[i]);
        }
        points_ = laidOver(solved->points, before);
        return {};
    }

    /// The place that a length along the outline in the plane has now.
    Eigen::RowVector2d pointAt(double flat) const {
        const double at = exact_.flat().wrap(flat);
        auto next = std::ranges::upper_bound(places_, at);
        const auto n = static_cast<Eigen::Index>(places_.size());
        const Eigen::Index i = (next - places_.begin() + n - 1) % n;
        const double from = at < places_[i] ? places_[i] - exact_.flat().length() : places_[i];
        const double length = place(i + 1) - place(i);
        const double t = length > 0 ? (at - from) / length : 0;
        return (1 - t) * points_.row(i) + t * points_.row((i + 1) % n);
    }

private:
    static constexpr double kSamePlace = 1e-6;  ///< mm

    bool isIn(double at, const std::pair<double, double>& run) const {
        const double past = exact_.flat().wrap(at - run.first);
        return past > kSamePlace && past < run.second - run.first - kSamePlace;
    }

    double place(Eigen::Index i) const {
        const auto n = static_cast<Eigen::Index>(places_.size());
        const Eigen::Index k = (i % n + n) % n;
        const Eigen::Index turns = (i - k) / n;
        return places_[k] + static_cast<double>(turns) * exact_.flat().length();
    }

    /// What all vertices before a place turn by, over any number of turns.
    double turnedBefore(double at) const {
        const ClosedLine& flat = exact_.flat();
        const double turns = std::floor(at / flat.length());
        const auto next =
            std::lower_bound(flat.arc().begin(), flat.arc().end() - 1, at - turns * flat.length());
        return turns * turned_.back() + turned_[next - flat.arc().begin()];
    }

    double turnAt(double at) const {
        return turnedBefore(at + kSamePlace) - turnedBefore(at - kSamePlace);
    }
    double turnBetween(double from, double to) const {
        return turnedBefore(to - kSamePlace) - turnedBefore(from + kSamePlace);
    }

    const ExactOutline& exact_;
    std::vector<double> places_;     ///< in the plane, of what is left of the vertices
    std::vector<double> turned_{0};  ///< of all vertices before each, and of all
    Points2 points_;
};

/// Divides an outline into the steps of its line.
class Steps {
public:
    Steps(const ExactOutline& exact, const OutlinePlan& plan) {
        const double perimeter = exact.flat().length();
        const double longest = std::clamp(kStep, perimeter / kMaxSteps, perimeter / kMinSteps);
        for (const OutlinePlan::Stretch& stretch : plan.stretches) {
            const double from = exact.flatAt(stretch.from), to = exact.flatAt(stretch.to);
            const auto count =
                std::max(1, static_cast<int>(std::ceil((to - from) / longest - 1e-9)));
            const int first = count_;
            for (int k = 0; k < count; ++k) {
                flat_.push_back(from + (to - from) * k / count);
                steps_.push_back((to - from) / count);
                tolerance_.push_back(std::min(stretch.tolerance, kPerimeterPart * perimeter));
            }
            count_ += count;
            if (stretch.straight) {
                straight_.push_back({first, count_});
            }
            starts_.emplace_back(stretch.from, first);
        }
    }

    int count() const { return count_; }
    double flat(int k) const { return flat_[k]; }
    const std::vector<double>& steps() const { return steps_; }
    const std::vector<double>& tolerance() const { return tolerance_; }
    const std::vector<FairProblem::Run>& straight() const { return straight_; }
    /// The node at which a stretch begins.
    int nodeAt(double place) const {
        const auto nearest = std::ranges::min_element(
            starts_, {}, [place](const auto& start) { return std::abs(start.first - place); });
        return nearest->second;
    }

private:
    int count_ = 0;
    std::vector<double> flat_, steps_, tolerance_;
    std::vector<FairProblem::Run> straight_;
    std::vector<std::pair<double, int>> starts_;
};

/// Where two stretches are the sides of a narrow band, neither strays by more than a part of its
/// width.
void boundByWidth(const Points2& line, const std::vector<double>& steps,
                  Eigen::VectorXd& tolerance) {
    const int n = static_cast<int>(line.rows());
    std::vector<geometry::Segment2> segments;
    std::vector<double> arc{0};
    for (int k = 0; k < n; ++k) {
        segments.push_back({line.row(k), line.row((k + 1) % n)});
        arc.push_back(arc.back() + steps[k]);
    }
    const double margin = tolerance.maxCoeff() / kBandPart;
    const auto isBand = [&](int i, int j, double width) {
        const double way = std::abs(arc[i] - arc[j]);
        const Eigen::RowVector2d a = segments[i].b - segments[i].a;
        const Eigen::RowVector2d b = segments[j].b - segments[j].a;
        return std::min(way, arc.back() - way) > kBandWay * width + 2 * kStep && a.dot(b) < 0;
    };
    geometry::visitSegmentPairs(segments, margin, [&](int i, int j, const geometry::PlaneCell&) {
        const double width =
            std::min({geometry::distanceToSegment(segments[i].a, segments[j].a, segments[j].b),
                      geometry::distanceToSegment(segments[i].b, segments[j].a, segments[j].b),
                      geometry::distanceToSegment(segments[j].a, segments[i].a, segments[i].b),
                      geometry::distanceToSegment(segments[j].b, segments[i].a, segments[i].b)});
        if (width < margin && isBand(i, j, width)) {
            const double most = std::max(kLeastTolerance, kBandPart * width);
            for (const int node : {i, (i + 1) % n, j, (j + 1) % n}) {
                tolerance[node] = std::min(tolerance[node], most);
            }
        }
        return true;
    });
}

}  // namespace

OutlinePlan planOutline(const OutlineSegments& segments, const LineSettings& settings,
                        const std::vector<double>& turnChanges) {
    const Fairing fairing = settings.fairing.value_or(Fairing{});
    OutlinePlan plan;
    plan.smoothing = fairing.smoothing;
    for (const Segment& segment : segments.segments) {
        plan.stretches.push_back({segment.at.start, segment.at.end,
                                  segment.settings.tolerance.value_or(fairing.tolerance),
                                  segment.settings.straight});
    }
    for (std::size_t k = 0; k < segments.turnPoints.size(); ++k) {
        const TurnPoint& point = segments.turnPoints[k];
        if (point.isCorner) {
            plan.corners.push_back({point.at, point.turn + turnChanges[k]});
        }
    }
    return plan;
}

Result<FlatLine> fairOutline(const OutlineReference& reference, const OutlinePlan& plan,
                             const Progress& progress) {
    const ExactOutline outline(reference);
    const Steps steps(outline, plan);
    StraightenedOutline straightened(outline, plan);
    if (!steps.straight().empty()) {
        if (const auto solved = straightened.solve(progress); !solved) {
            return solved.error();
        }
    }
    FairProblem problem;
    problem.reference.resize(steps.count(), 2);
    for (int k = 0; k < steps.count(); ++k) {
        problem.reference.row(k) = steps.straight().empty() ? outline.flat().pointAt(steps.flat(k))
                                                            : straightened.pointAt(steps.flat(k));
    }
    problem.steps = Eigen::Map<const Eigen::VectorXd>(steps.steps().data(), steps.count());
    problem.tolerance = Eigen::Map<const Eigen::VectorXd>(steps.tolerance().data(), steps.count());
    boundByWidth(problem.reference, steps.steps(), problem.tolerance);
    const double meanStep = problem.steps.sum() / static_cast<double>(problem.steps.size());
    problem.smoothing = std::min(plan.smoothing, kMaxSmoothedSteps * meanStep);
    problem.straight = steps.straight();
    for (const OutlinePlan::Corner& corner : plan.corners) {
        problem.corners.push_back({steps.nodeAt(corner.at), corner.turn});
    }
    const auto fair = fairLine(problem, progress);
    if (!fair) {
        return fair.error();
    }
    FlatLine line;
    line.points = fair->points;
    line.iterations = fair->iterations;
    line.converged = fair->converged;
    for (int k = 0; k < steps.count(); ++k) {
        line.arc.push_back(outline.arcAt(steps.flat(k)));
        line.farthest = std::max(
            line.farthest, (line.points.row(k) - outline.flat().pointAt(steps.flat(k))).norm());
    }
    line.arc.push_back(line.arc.front() + outline.byArc().length());
    return line;
}

Points2 verticesOn(const FlatLine& line, const Piece& piece) {
    const ClosedLine closed(line.points, line.arc);
    const std::vector<double> arc = outlineArc(piece);
    Points2 points(static_cast<Eigen::Index>(piece.boundary.size()), 2);
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        points.row(k) = closed.pointAt(arc[k]);
    }
    return points;
}

}  // namespace toile
