// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/reshaped_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/flatten/boundary/boundary_problem.h"
#include "core/geometry/segment.h"
#include "core/pattern/outline_reference.h"

namespace toile {
namespace {

constexpr double kSamePlace = 1e-6;  ///< mm

/// A triangle over the mouth of a dart, its tip on the left.
struct Mouth {
    double first = 0, second = 0;  ///< legs, mm
    double intake = 0;

    bool isTriangle() const { return intake > std::abs(first - second) && intake < first + second; }
    /// Position of the tip: along the intake from the first end, and at right angles to it.
    double along() const {
        return ((first - second) * (first + second) + intake * intake) / (2 * intake);
    }
    double across() const { return std::sqrt((first - along()) * (first + along())); }
    double angleAtFirst() const { return std::atan2(across(), along()); }
    double angleAtSecond() const { return std::atan2(across(), intake - along()); }
};

/// A stretch of outline that becomes a single edge; lengths in the plane.
struct EdgeRun {
    double from = 0, to = 0;
    double tip = -1;  ///< of a dart
    Mouth mouth{};

    bool isDart() const { return tip >= 0; }
    double length() const { return isDart() ? mouth.intake : to - from; }
};

class Reshaping {
public:
    Reshaping(const OutlineReference& reference, const OutlinePlan& plan)
        : reference_(reference), exact_(reference) {
        addRuns(plan);
        const geometry::Line& flat = exact_.flat();
        for (int k = 0; k < flat.count(); ++k) {
            const double at = flat.arc()[k];
            if (std::ranges::none_of(runs_, [&](const EdgeRun& run) { return isIn(at, run); })) {
                places_.push_back(at);
            }
        }
        for (const EdgeRun& run : runs_) {
            places_.push_back(flat.wrap(run.from));
            places_.push_back(flat.wrap(run.to));
        }
        std::ranges::sort(places_);
        const auto same = [](double a, double b) { return b - a < kSamePlace; };
        places_.erase(std::unique(places_.begin(), places_.end(), same), places_.end());
        for (int k = 0; k < flat.count(); ++k) {
            turned_.push_back(turned_.back() + exact_.turnAt(k));
        }
        runOf_.assign(places_.size(), nullptr);
        for (const EdgeRun& run : runs_) {
            runOf_[indexOf(run.from)] = &run;
        }
    }

    Result<void> solve(const Progress& progress) {
        const auto n = static_cast<Eigen::Index>(places_.size());
        const bool reaches = std::ranges::all_of(
            runs_, [](const EdgeRun& run) { return !run.isDart() || run.mouth.isTriangle(); });
        if (n < 3 || !reaches) {
            return Error{ErrorCode::LineNotDrawn};
        }
        BoundaryProblem problem{Eigen::VectorXd(n), Eigen::VectorXd(n)};
        Eigen::VectorXd turn(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            problem.lengths[i] = runOf_[i] ? runOf_[i]->length() : place(i + 1) - place(i);
            turn[i] = turnAt(place(i)) + turnedBefore(i) + turnedAfter(i);
        }
        problem.angles = std::numbers::pi - turn.array();  // the solver spreads the excess
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

    /// Precondition: it is solved.
    OutlineReference reshaped() const {
        const geometry::Line& flat = exact_.flat();
        std::vector<std::pair<double, int>> rows;  // places, and vertices there
        rows.reserve(static_cast<std::size_t>(flat.count()));
        for (int k = 0; k < flat.count(); ++k) {
            rows.emplace_back(flat.arc()[k], k);
        }
        const auto add = [&](double at) {
            if (snapped(at) == at && vertexNear(at) < 0) {
                rows.emplace_back(flat.wrap(at), -1);
            }
        };
        for (const EdgeRun& run : runs_) {
            add(run.from);
            add(run.to);
            if (run.isDart()) {
                add(run.tip);
            }
        }
        std::ranges::sort(rows);
        rows.erase(std::unique(rows.begin(), rows.end(),
                               [](const auto& a, const auto& b) {
                                   return b.first - a.first < kSamePlace && b.second < 0;
                               }),
                   rows.end());
        OutlineReference made;
        made.points.resize(static_cast<Eigen::Index>(rows.size()), 2);
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const auto& [at, vertex] = rows[r];
            made.points.row(static_cast<Eigen::Index>(r)) = pointAt(at);
            made.arc.push_back(vertex < 0 ? exact_.arcAt(at) : reference_.arc[vertex]);
            made.turn.push_back(vertex < 0 ? 0 : reference_.turn[vertex]);
        }
        made.arc.push_back(reference_.arc.back());
        return made;
    }

private:
    void addRuns(const OutlinePlan& plan) {
        for (const OutlinePlan::Dart& dart : plan.darts) {
            EdgeRun run;
            run.from = snapped(exact_.flatAt(dart.from));
            run.tip = snapped(exact_.flatAt(dart.tip));
            run.to = snapped(exact_.flatAt(dart.to));
            run.mouth = {run.tip - run.from, run.to - run.tip, dart.intake};
            runs_.push_back(run);
        }
        const std::vector<EdgeRun> darts = runs_;
        for (const OutlinePlan::Stretch& stretch : plan.stretches) {
            const double from = snapped(exact_.flatAt(stretch.from));
            const double to = snapped(exact_.flatAt(stretch.to));
            const double middle = exact_.flat().wrap(0.5 * (from + to));
            const auto holds = [&](const EdgeRun& dart) { return isIn(middle, dart); };
            if (stretch.straight && std::ranges::none_of(darts, holds)) {
                runs_.push_back({from, to});
            }
        }
    }

    /// The vertex at a place; -1 if there is none.
    int vertexNear(double at) const {
        const geometry::Line& flat = exact_.flat();
        const int before = flat.edgeAt(at);
        for (const int k : {before, (before + 1) % flat.count()}) {
            if (flat.apart(flat.arc()[k], at) < kSamePlace) {
                return k;
            }
        }
        return -1;
    }
    /// The place of the vertex at a place, if there is one; else the place itself.
    double snapped(double at) const {
        const int vertex = vertexNear(at);
        return vertex < 0
                   ? at
                   : at - std::remainder(at - exact_.flat().arc()[vertex], exact_.flat().length());
    }

    bool isIn(double at, const EdgeRun& run) const {
        const double past = exact_.flat().wrap(at - run.from);
        return past > kSamePlace && past < run.to - run.from - kSamePlace;
    }

    std::size_t indexOf(double at) const {
        const auto nearest = std::ranges::min_element(
            places_, {}, [&](double place) { return exact_.flat().apart(place, at); });
        return static_cast<std::size_t>(nearest - places_.begin());
    }

    double place(Eigen::Index i) const {
        const auto n = static_cast<Eigen::Index>(places_.size());
        const Eigen::Index k = (i % n + n) % n;
        const Eigen::Index turns = (i - k) / n;
        return places_[k] + static_cast<double>(turns) * exact_.flat().length();
    }

    /// Sum of the turns of all vertices before a place, over any number of turns.
    double turnedUpTo(double at) const {
        const geometry::Line& flat = exact_.flat();
        const double turns = flat.arc().turnsBefore(at);
        const std::vector<double>& arc = flat.arc().values();
        const auto next = std::lower_bound(arc.begin(), arc.end() - 1, at - turns * flat.length());
        return turns * turned_.back() + turned_[next - arc.begin()];
    }

    double turnAt(double at) const {
        return turnedUpTo(at + kSamePlace) - turnedUpTo(at - kSamePlace);
    }
    double turnBetween(double from, double to) const {
        return turnedUpTo(to - kSamePlace) - turnedUpTo(from + kSamePlace);
    }

    /// Part of a run's turn given to its end: of the run before place i, and of the run after it.
    double turnedBefore(Eigen::Index i) const {
        const auto n = static_cast<Eigen::Index>(places_.size());
        const EdgeRun* run = runOf_[(i + n - 1) % n];
        return !run            ? 0
               : run->isDart() ? 0.5 * turnBetween(run->tip, run->to) - run->mouth.angleAtSecond()
                               : 0.5 * turnBetween(run->from, run->to);
    }
    double turnedAfter(Eigen::Index i) const {
        const EdgeRun* run = runOf_[i];
        return !run            ? 0
               : run->isDart() ? 0.5 * turnBetween(run->from, run->tip) - run->mouth.angleAtFirst()
                               : 0.5 * turnBetween(run->from, run->to);
    }

    /// The new position of a length along the outline in the plane.
    Eigen::RowVector2d pointAt(double flat) const {
        const double at = exact_.flat().wrap(flat);
        const auto next = std::ranges::upper_bound(places_, at);
        const auto n = static_cast<Eigen::Index>(places_.size());
        const Eigen::Index i = (next - places_.begin() + n - 1) % n;
        const double past =
            at - (at < places_[i] ? places_[i] - exact_.flat().length() : places_[i]);
        const Eigen::RowVector2d from = points_.row(i), to = points_.row((i + 1) % n);
        if (runOf_[i] && runOf_[i]->isDart()) {
            return onLegs(runOf_[i]->mouth, from, to, past);
        }
        const double length = place(i + 1) - place(i);
        const double t = length > 0 ? past / length : 0;
        return (1 - t) * from + t * to;
    }

    static Eigen::RowVector2d onLegs(const Mouth& mouth, const Eigen::RowVector2d& from,
                                     const Eigen::RowVector2d& to, double past) {
        const Eigen::RowVector2d along = (to - from).normalized();
        const Eigen::RowVector2d across(-along.y(), along.x());
        const Eigen::RowVector2d tip = from + mouth.along() * along + mouth.across() * across;
        const double back = std::clamp(past - mouth.first, 0.0, mouth.second);
        return back > 0 ? Eigen::RowVector2d(tip + back / mouth.second * (to - tip))
                        : Eigen::RowVector2d(from + past / mouth.first * (tip - from));
    }

    const OutlineReference& reference_;
    ExactOutline exact_;
    std::vector<EdgeRun> runs_;
    std::vector<double> places_;         ///< in the plane, of the remaining vertices
    std::vector<const EdgeRun*> runOf_;  ///< run that starts at each; null: none
    std::vector<double> turned_{0};      ///< of all vertices before each, and of all
    Points2 points_;
};

}  // namespace

Result<OutlineReference> reshapedOutline(const OutlineReference& reference, const OutlinePlan& plan,
                                         const Progress& progress) {
    const bool isRequested =
        !plan.darts.empty() || std::ranges::any_of(plan.stretches, &OutlinePlan::Stretch::straight);
    if (!isRequested) {
        return reference;
    }
    Reshaping reshaping(reference, plan);
    if (const auto solved = reshaping.solve(progress); !solved) {
        return solved.error();
    }
    return reshaping.reshaped();
}

}  // namespace toile
