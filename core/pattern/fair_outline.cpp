// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/fair_outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/geometry/segment_pairs.h"
#include "core/pattern/fair_solver.h"
#include "core/pattern/outline_reference.h"
#include "core/pattern/piece_grain.h"
#include "core/pattern/reshaped_outline.h"
#include "core/quality/outline_crossings.h"

namespace toile {
namespace {

using fairing::FairModel;
using fairing::FairSolver;
using fairing::LineState;

/// Fraction of lambda per stage; the weight lambda^6 grows eightfold from stage to stage.
constexpr double kShares[] = {0.08838834764831845, 0.125, 0.17677669529663687, 0.25,
                              0.35355339059327373, 0.5,   0.70710678118654752, 1};
constexpr int kStages = 8;
constexpr int kDirectStage = 4;        // first stage to try, usually enough for garments
constexpr int kDirectIterations = 20;  // limit for it; if exceeded, start at stage 0
constexpr double kStageDone = 0.03;    // radians: largest change of a direction
constexpr double kDone = 1e-4;         // of the last stage, where convergence is quadratic
constexpr double kClosed = 1e-10;      // of the perimeter

bool isFinite(const FairProblem& problem) {
    bool finite = problem.reference.allFinite() && problem.steps.allFinite() &&
                  problem.tolerance.allFinite() && std::isfinite(problem.smoothing);
    for (const FairProblem::Corner& corner : problem.corners) {
        finite = finite && std::isfinite(corner.turn);
    }
    return finite;
}

/// Writes the line along a state's directions. False if it does not close or leaves the tolerance.
bool writeLine(const FairProblem& problem, const FairModel& model, const LineState& state,
               FairLine& line) {
    double gap = 0;
    line.points = model.walked(state, gap);
    line.directions = state.phi;
    const Eigen::ArrayXd away = (line.points - problem.reference).rowwise().norm();
    line.farthest = away.maxCoeff();
    return gap <= kClosed && (away < problem.tolerance.array()).all();
}

/// Fallback if the tolerance has no room for the lengths and turns: meets only these.
void writeExact(const FairProblem& problem, const Progress& progress, FairLine& line) {
    FairProblem loose = problem;
    loose.tolerance.setConstant(problem.steps.sum());
    const FairModel model(loose);
    FairSolver solver(model, progress);
    LineState state = model.start();
    solver.restore(state);
    writeLine(problem, model, state, line);
}

/// Runs all stages; false if one fails. `settled` is the state after the last converged stage.
bool climb(FairSolver& solver, LineState& settled) {
    int stage = kDirectStage;
    if (solver.iterate(kShares[stage], kStageDone, kDirectIterations)) {
        settled = solver.state();
        ++stage;
    } else {
        solver.restart();
        stage = 0;
    }
    for (; stage < kStages; ++stage) {
        const double done = stage + 1 < kStages ? kStageDone : kDone;
        if (!solver.iterate(kShares[stage], done, kMaxFairIterations)) {
            return false;
        }
        settled = solver.state();
    }
    return true;
}

}  // namespace

Result<FairLine> fairLine(const FairProblem& problem, const Progress& progress) {
    if (!isFinite(problem)) {
        return Error{ErrorCode::NotFinite};
    }
    const FairModel model(problem);
    FairSolver solver(model, progress);
    LineState settled = model.start();
    FairLine line;
    line.converged = climb(solver, settled);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    line.iterations = solver.iterations();
    for (LineState state : {solver.state(), settled, model.start()}) {
        if (solver.restore(state) && writeLine(problem, model, state, line)) {
            return line;
        }
        line.converged = false;
    }
    writeExact(problem, progress, line);
    return line;
}

namespace {

/// Step of the line, mm: in 400 mm its chords are a few micrometres shorter than a curve.
constexpr double kStep = 2;
/// Approximate limits on the number of steps, whatever the size of the piece.
constexpr double kMaxSteps = 20000, kMinSteps = 24;
/// Largest smoothing length, in steps; beyond it the solver loses precision.
constexpr double kMaxSmoothedSteps = 40;
/// Largest tolerance, as a fraction of the outline's length.
constexpr double kPerimeterPart = 0.02;
/// Sides of a band are farther apart along the outline than this times the band's width.
constexpr double kBandWay = 6;
/// Largest tolerance of either side, as a fraction of the band's width.
constexpr double kBandPart = 0.25;
/// Smallest tolerance, mm; below it the line looks identical to the exact one.
constexpr double kMinTolerance = 0.02;
/// A line that crosses itself is drawn again, at most kMaxYields times. Each time, steps shrink by
/// kFinerSteps, and the tolerance by kYieldingPart around the crossings, within a distance in mm
/// that doubles.
constexpr int kMaxYields = 4;
constexpr double kYieldingPart = 0.25, kYieldingReach = 10, kFinerSteps = 0.5;

/// Divides an outline into the steps of its line; a single step spans the mouth of each dart, which
/// keeps its shape.
class Steps {
public:
    /// A point of the line: a node, or on the legs of a dart.
    struct LinePoint {
        double flat = 0;
        int node = -1, dart = -1;
    };

    /// @param fineness  factor for the length of steps
    Steps(const ExactOutline& shaped, const OutlinePlan& plan, double fineness) {
        const double perimeter = shaped.flat().length();
        const double longest =
            fineness * std::clamp(kStep, perimeter / kMaxSteps, perimeter / kMinSteps);
        mouths_.assign(plan.darts.size(), -1);
        for (const OutlinePlan::Stretch& stretch : plan.stretches) {
            const double from = shaped.flatAt(stretch.from), to = shaped.flatAt(stretch.to);
            const auto count =
                std::max(1, static_cast<int>(std::ceil((to - from) / longest - 1e-9)));
            const double tolerance = std::min(stretch.tolerance, kPerimeterPart * perimeter);
            const double middle = 0.5 * (stretch.from + stretch.to);
            const int dart = dartAt(plan, shaped.byArc().length(), middle);
            const bool isMouth =
                dart >= 0 && shaped.byArc().apart(stretch.from, plan.darts[dart].from) < kAtMouth;
            if (dart < 0 || isMouth) {
                starts_.emplace_back(stretch.from, count_);
            }
            if (isMouth) {
                mouths_[dart] = count_;
                addNode(from, plan.darts[dart].intake, tolerance);
            }
            const int first = count_;
            for (int k = 0; k < count; ++k) {
                const double flat = from + (to - from) * k / count;
                if (dart < 0) {
                    addNode(flat, (to - from) / count, tolerance);
                } else if (k > 0 || !isMouth) {
                    line_.push_back({flat, -1, dart});
                }
            }
            if (stretch.straight && dart < 0) {
                straight_.push_back({first, count_});
            }
        }
    }

    int count() const { return count_; }
    double flat(int k) const { return flat_[k]; }
    const std::vector<double>& steps() const { return steps_; }
    const std::vector<double>& tolerance() const { return tolerance_; }
    const std::vector<FairProblem::Run>& straight() const { return straight_; }
    const std::vector<LinePoint>& line() const { return line_; }
    /// The node at which the first leg of a dart begins.
    int mouth(int dart) const { return mouths_[dart]; }
    /// The node at which a stretch begins.
    int nodeAt(double place, const geometry::Line& byArc) const {
        const auto nearest = std::ranges::min_element(
            starts_, {}, [&](const auto& start) { return byArc.apart(start.first, place); });
        return nearest->second;
    }

private:
    static constexpr double kAtMouth = 1e-3;  ///< mm

    static int dartAt(const OutlinePlan& plan, double perimeter, double at) {
        const auto found = std::ranges::find_if(plan.darts, [&](const OutlinePlan::Dart& dart) {
            return isWithin(dart, perimeter, at);
        });
        return found == plan.darts.end() ? -1 : static_cast<int>(found - plan.darts.begin());
    }
    void addNode(double flat, double step, double tolerance) {
        line_.push_back({flat, count_++, -1});
        flat_.push_back(flat);
        steps_.push_back(step);
        tolerance_.push_back(tolerance);
    }

    int count_ = 0;
    std::vector<double> flat_, steps_, tolerance_;
    std::vector<FairProblem::Run> straight_;
    std::vector<std::pair<double, int>> starts_;
    std::vector<LinePoint> line_;
    std::vector<int> mouths_;
};

/// The corners of the plan except those on darts, which keep their shape, and the ends of the
/// darts' mouths, where the line turns onto the step across.
std::vector<FairProblem::Corner> cornersOf(const OutlinePlan& plan, const ExactOutline& shaped,
                                           const Steps& steps) {
    std::map<int, double> turns;
    std::set<int> free;
    for (const OutlinePlan::Corner& corner : plan.corners) {
        const bool isOnDart = std::ranges::any_of(plan.darts, [&](const OutlinePlan::Dart& dart) {
            return isWithin(dart, shaped.byArc().length(), corner.at);
        });
        if (!isOnDart) {
            const int node = steps.nodeAt(corner.at, shaped.byArc());
            turns[node] = corner.turn;
            if (corner.isFree && plan.darts.empty()) {
                free.insert(node);
            }
        }
    }
    const geometry::Line& flat = shaped.flat();
    const auto turnThere = [&](double at) {  // for ends without a corner in the plan
        const double step = 0.5 * kStep;
        return geometry::turnBetween(flat.pointAt(at) - flat.pointAt(at - step),
                                     flat.pointAt(at + step) - flat.pointAt(at));
    };
    for (const OutlinePlan::Dart& dart : plan.darts) {
        const double from = shaped.flatAt(dart.from), to = shaped.flatAt(dart.to);
        const Eigen::RowVector2d tip = flat.pointAt(shaped.flatAt(dart.tip));
        const Eigen::RowVector2d first = tip - flat.pointAt(from), second = flat.pointAt(to) - tip;
        const Eigen::RowVector2d mouth = flat.pointAt(to) - flat.pointAt(from);
        turns.try_emplace(steps.nodeAt(dart.from, shaped.byArc()), turnThere(from)).first->second -=
            geometry::turnBetween(mouth, first);
        turns.try_emplace(steps.nodeAt(dart.to, shaped.byArc()), turnThere(to)).first->second -=
            geometry::turnBetween(second, mouth);
    }
    std::vector<FairProblem::Corner> corners;
    corners.reserve(turns.size());
    for (const auto& [node, turn] : turns) {
        corners.push_back({node, turn, free.contains(node)});
    }
    return corners;
}

/// Moves points on the legs of a dart together with the ends of its mouth.
class MovedDart {
public:
    MovedDart(const Chord& from, const Chord& to) : from_(from.from), to_(to.from) {
        turn_ = Eigen::Rotation2Dd(geometry::turnBetween(from.to - from.from, to.to - to.from));
    }
    Eigen::RowVector2d operator()(const Eigen::RowVector2d& point) const {
        return (to_ + turn_ * (point.transpose() - from_)).transpose();
    }

private:
    Eigen::Vector2d from_, to_;
    Eigen::Rotation2Dd turn_{0};
};

/// Limits the tolerance on both sides of narrow bands to a fraction of the width.
void boundByWidth(const Points2& line, const std::vector<double>& steps,
                  Eigen::VectorXd& tolerance) {
    const int n = static_cast<int>(line.rows());
    std::vector<geometry::Segment2> segments;
    const std::vector<double> arc = geometry::arcOf(steps);
    for (int k = 0; k < n; ++k) {
        segments.push_back({line.row(k), line.row((k + 1) % n)});
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
            const double most = std::max(kMinTolerance, kBandPart * width);
            for (const int node : {i, (i + 1) % n, j, (j + 1) % n}) {
                tolerance[node] = std::min(tolerance[node], most);
            }
        }
        return true;
    });
}

}  // namespace

OutlinePlan planOutline(const OutlineSegments& segments, const LineSettings& settings,
                        const std::vector<double>& turnChanges, bool isWrinkled) {
    const Fairing fairing = settings.fairing.value_or(Fairing{});
    const bool isLoose = isWrinkled && !fairing.isFixed && fairing.tolerance == Fairing{}.tolerance;
    const double tolerance = isLoose ? kWrinkledTolerance : fairing.tolerance;
    OutlinePlan plan;
    plan.smoothing = (isLoose ? kWrinkledSmoothing : 1) * fairing.smoothing;
    plan.stated = isLoose ? fairing.tolerance : 0;
    for (const Segment& segment : segments.segments) {
        plan.stretches.push_back({segment.at.start, segment.at.end,
                                  segment.settings.tolerance.value_or(tolerance),
                                  segment.settings.straight});
    }
    for (std::size_t k = 0; k < segments.turnPoints.size(); ++k) {
        const TurnPoint& point = segments.turnPoints[k];
        if (keepsTurn(point)) {
            const bool isFree = isLoose && !point.byHand && turnChanges[k] == 0;
            plan.corners.push_back({point.at, point.turn + turnChanges[k], isFree});
        }
    }
    return plan;
}

namespace {

std::vector<OutlineCrossing> crossingsOf(const Points2& points) {
    std::vector<int> loop(static_cast<std::size_t>(points.rows()));
    std::iota(loop.begin(), loop.end(), 0);
    return findOutlineCrossings(points, loop);
}

/// Places, by arc length in 3D, where the line or the polygon of the outline's vertices on it
/// crosses itself. Empty if neither has more crossings than the exact outline.
std::vector<double> newCrossings(const FlatLine& line, const ExactOutline& exact) {
    const auto closed = geometry::Line::closed(line.points, line.arc);
    const std::vector<double>& arc = exact.byArc().arc().values();
    Points2 vertices(exact.byArc().count(), 2);
    for (Eigen::Index k = 0; k < vertices.rows(); ++k) {
        vertices.row(k) = closed.pointAt(arc[k]);
    }
    const auto ofLine = crossingsOf(line.points), ofVertices = crossingsOf(vertices);
    std::vector<double> places;
    if (ofLine.empty() && ofVertices.empty()) {
        return places;
    }
    const std::size_t before = crossingsOf(exact.byArc().points()).size();
    const auto add = [&](const std::vector<OutlineCrossing>& found, const std::vector<double>& at) {
        for (std::size_t k = 0; k < found.size() && found.size() > before; ++k) {
            for (const int edge : {found[k].first, found[k].second}) {
                places.push_back(0.5 * (at[edge] + at[edge + 1]));
            }
        }
    };
    add(ofLine, line.arc);
    add(ofVertices, arc);
    return places;
}

/// Places where a line crossed itself, and the distance around them with a reduced tolerance, mm.
struct Yield {
    std::vector<double> places;
    double reach = 0;
};

FairProblem problemOf(const OutlinePlan& plan, const ExactOutline& shaped, const Steps& steps,
                      const std::vector<Yield>& yields) {
    FairProblem problem;
    problem.reference.resize(steps.count(), 2);
    for (int k = 0; k < steps.count(); ++k) {
        problem.reference.row(k) = shaped.flat().pointAt(steps.flat(k));
    }
    problem.steps = Eigen::Map<const Eigen::VectorXd>(steps.steps().data(), steps.count());
    problem.tolerance = Eigen::Map<const Eigen::VectorXd>(steps.tolerance().data(), steps.count());
    boundByWidth(problem.reference, steps.steps(), problem.tolerance);
    for (const Yield& yield : yields) {
        for (int k = 0; k < steps.count(); ++k) {
            const double at = shaped.arcAt(steps.flat(k));
            if (std::ranges::any_of(yield.places, [&](double place) {
                    return shaped.byArc().apart(place, at) < yield.reach;
                })) {
                problem.tolerance[k] *= kYieldingPart;
            }
        }
    }
    const double meanStep = problem.steps.sum() / static_cast<double>(problem.steps.size());
    problem.smoothing = std::min(plan.smoothing, kMaxSmoothedSteps * meanStep);
    problem.straight = steps.straight();
    problem.corners = cornersOf(plan, shaped, steps);
    return problem;
}

/// The line through the nodes of a solved problem and along the darts, which keep their shape.
FlatLine lineThrough(const FairLine& fair, const FairProblem& problem, const Steps& steps,
                     const OutlinePlan& plan, const ExactOutline& outline,
                     const ExactOutline& shaped) {
    std::vector<MovedDart> darts;
    for (std::size_t d = 0; d < plan.darts.size(); ++d) {
        const int from = steps.mouth(static_cast<int>(d)), to = (from + 1) % steps.count();
        darts.emplace_back(Chord{problem.reference.row(from), problem.reference.row(to)},
                           Chord{fair.points.row(from), fair.points.row(to)});
    }
    FlatLine line;
    line.points.resize(static_cast<Eigen::Index>(steps.line().size()), 2);
    line.iterations = fair.iterations;
    line.converged = fair.converged;
    for (std::size_t k = 0; k < steps.line().size(); ++k) {
        const auto& [flat, node, dart] = steps.line()[k];
        const Eigen::RowVector2d point = node >= 0 ? Eigen::RowVector2d(fair.points.row(node))
                                                   : darts[dart](shaped.flat().pointAt(flat));
        line.points.row(static_cast<Eigen::Index>(k)) = point;
        line.arc.push_back(shaped.arcAt(flat));
        line.farthest =
            std::max(line.farthest, (point - outline.byArc().pointAt(line.arc.back())).norm());
    }
    line.arc.push_back(line.arc.front() + outline.byArc().length());
    return line;
}

}  // namespace

Result<FlatLine> fairOutline(const OutlineReference& reference, const OutlinePlan& plan,
                             const Progress& progress) {
    const auto reshaped = reshapedOutline(reference, plan, progress);
    if (!reshaped) {
        return reshaped.error();
    }
    const ExactOutline outline(reference), shaped(*reshaped);
    std::vector<Yield> yields;
    double fineness = 1;
    for (int k = 0; k <= kMaxYields; ++k, fineness *= kFinerSteps) {
        const Steps steps(shaped, plan, fineness);
        const FairProblem problem = problemOf(plan, shaped, steps, yields);
        const auto fair = fairLine(problem, progress);
        if (!fair) {
            return fair.error();
        }
        FlatLine line = lineThrough(*fair, problem, steps, plan, outline, shaped);
        std::vector<double> crossings = newCrossings(line, shaped);
        if (crossings.empty()) {
            line.hasYielded = k > 0;
            return line;
        }
        yields.push_back({std::move(crossings), std::ldexp(kYieldingReach, k)});
    }
    return Error{ErrorCode::LineNotDrawn, {}, worded("it would cross itself")};
}

Points2 verticesOn(const FlatLine& line, const Piece& piece) {
    const auto closed = geometry::Line::closed(line.points, line.arc);
    const std::vector<double> arc = outlineArc(piece);
    Points2 points(static_cast<Eigen::Index>(piece.boundary.size()), 2);
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        points.row(k) = closed.pointAt(arc[k]);
    }
    return points;
}

}  // namespace toile
