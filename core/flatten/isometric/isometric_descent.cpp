// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/isometric_descent.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/flatten/isometric/refactorisation_policy.h"
#include "core/quality/measures.h"
#include "core/quality/outline_crossings.h"

namespace toile::isometric {
namespace {

constexpr int kMaxCorrections = 6;
constexpr int kMaxApproaches = 12;         // to exact lengths, from a start without
constexpr double kMinApproach = 0.05;      // smallest share of the way for another try
constexpr double kSmallCorrection = 1e-3;  // of an edge: the boundary alone may take it
constexpr double kLargestCorrection = 1;   // of an edge: the quadratic model is unreliable beyond
constexpr double kSufficientDecrease = 1e-4;
constexpr double kBackOff = 0.9;  // share of the way to the first triangle without area
constexpr int kMaxHalvings = 40;
constexpr int kMaxStaleHalvings = 3;  // of a step that may be improved by a new factorisation
/// Newton's step is too short for squeezed triangles: from s^-2 it moves s by a third.
constexpr double kLongestStep = 8;
constexpr double kStretch = 1.5;
constexpr double kShorten = 0.7;
constexpr int kMaxShortenings = 4;
constexpr int kRelaxingPasses = 3;
constexpr int kMaxOpenings = 3;  // of gaps, for a longer step than contacts allow
/// A step with an old factorisation that promises at most this many times the tolerance would need
/// a new one to find more, which is not worth its cost.
constexpr double kStaleTolerance = 2;
/// A descent is hopeless if it would not reach the wanted distortion even at the rate of the last
/// kLookBack steps, repeated kHopeless times: descents slow down.
constexpr int kLookBack = 6;
constexpr double kHopeless = 10;
/// An excess of energy below this is rounding.
constexpr double kNoExcess = 1e-10;

class Descent {
public:
    Descent(const MeshArrays& mesh, const EdgeTable& table, const EdgeLoops& loops,
            const DescentOptions& options, const Progress& progress)
        : progress_(progress),
          lengths_(loops.lengths(mesh.V)),
          objective_(mesh, table, loops, lengths_, options.keepOutlineSimple, options.energy),
          constraints_(loops, lengths_),
          kkt_(mesh, table, lengths_, constraints_, options.keepOutlineSimple, options.sizes,
               progress),
          multipliers_(options.multipliers.size() > 0 ? options.multipliers
                                                      : Eigen::VectorXd::Zero(lengths_.size())) {
        kkt_.adopt(options.model);
        for (int k = 0; k < loops.loopCount() && options.keepOutlineSimple; ++k) {
            simpleLoops_.push_back(loops.loop(k));
        }
    }

    const IsometricObjective& objective() const { return objective_; }

    /// Sets up the quadratic model at Q for the next steps.
    Result<void> renew(const Points2& Q, const IsometricObjective::Value& at) {
        return kkt_.renew(objective_, {Q, at, multipliers_});
    }

    /// The step of the quadratic programme, and the predicted fall of the objective. The model may
    /// be some steps old; the history of steps corrects its curvature.
    Result<Points2> step(const Points2& Q, const IsometricObjective::Value& at, double& predicted) {
        if (gradient_.rows() == 0) {
            gradient_ = objective_.gradient(Q, at);
        }
        const Points2 g = lagrangian(Q, gradient_);
        Points2 reduced = g;
        const std::vector<double> taken = history_.reduce(reduced);
        Eigen::VectorXd more = Eigen::VectorXd::Zero(lengths_.size());
        auto P = kkt_.solve(-reduced, Eigen::VectorXd::Zero(lengths_.size()), more);
        if (P) {
            history_.complete(taken, *P);
            multipliers_ += more;
            predicted = -0.5 * dot(g, *P);
        }
        return P;
    }

    /// Takes the last `step`, or the part of it that lowers the objective.
    /// @return that part; 0 if none lowers it
    double advance(Points2& Q, IsometricObjective::Value& at, const Points2& P, double predicted,
                   bool stale) {
        const auto take = [&](double t, bool opensGaps) {
            Points2 moved = Q + t * P;
            if (!regainLengths(moved, t * P, opensGaps ? &at.contacts : nullptr)) {
                return false;
            }
            IsometricObjective::Value reached = objective_.evaluate(moved);
            if (!(reached.total < at.total - 2 * kSufficientDecrease * t * predicted) ||
                !mayLieSo(moved)) {
                return false;
            }
            Points2 gradient = objective_.gradient(moved, reached);
            history_.add(moved - Q, lagrangian(moved, gradient) - lagrangian(Q, gradient_));
            gradient_ = std::move(gradient);
            Q = std::move(moved);
            at = std::move(reached);
            return true;
        };
        double t = usefulPart(Q, at, P);
        // A vertex that slides along an edge stops a straight step, so also correct its gap.
        double further = stale || at.contacts.empty() ? 0 : 1;
        for (int k = 0; k < kMaxOpenings && further > 2 * t; ++k, further *= 0.5) {
            if (take(further, true)) {
                return further;
            }
        }
        const int halvings = stale ? kMaxStaleHalvings : kMaxHalvings;
        for (int k = 0; k < halvings && !progress_.isCancelled(); ++k, t *= 0.5) {
            if (take(t, false)) {
                return t;
            }
        }
        return 0;
    }

    bool hasLengths(const Points2& Q) const { return constraints_.areKept(Q); }

    /// Moves a start with nearly exact lengths to exact lengths along the cheapest path of the
    /// quadratic models; at once, or in steps that end before a triangle loses its area.
    Result<void> makeExact(Points2& Q, IsometricObjective::Value& at) {
        double part = 1;
        for (int k = 0; k <= kMaxApproaches && part > kMinApproach; ++k) {
            if (progress_.isCancelled()) {
                return Error{ErrorCode::Cancelled};
            }
            if (const auto renewed = renew(Q, at); !renewed) {
                return renewed.error();
            }
            Points2 exact = Q;
            if (regainLengths(exact, {}, nullptr)) {
                IsometricObjective::Value there = objective_.evaluate(exact);
                if (std::isfinite(there.total) && mayLieSo(exact)) {
                    Q = std::move(exact);
                    at = std::move(there);
                    return {};
                }
            }
            Eigen::VectorXd y = Eigen::VectorXd::Zero(lengths_.size());
            const auto P = kkt_.solve(Points2::Zero(Q.rows(), 2), constraints_.residual(Q), y);
            if (!P) {
                return P.error();
            }
            part = kBackOff * objective_.largestStep(Q, *P, 1 / kBackOff);
            Q += part * *P;
            at = objective_.evaluate(Q);
            relax(Q, at);
        }
        return Error{ErrorCode::BoundaryNotConverged, {}, "the lengths are too far from exact"};
    }

    /// Makes room after a step that single triangles stopped.
    void relax(Points2& Q, IsometricObjective::Value& at) {
        objective_.relax(Q, kRelaxingPasses, progress_);
        at = objective_.evaluate(Q);
        gradient_.resize(0, 2);
    }

    /// Cost of `renew`, in steps.
    double renewingCost() const { return kkt_.renewingCost(); }
    void clearHistory() { history_.clear(); }
    const Eigen::VectorXd& multipliers() const { return multipliers_; }
    const KktSolver& kkt() const { return kkt_; }

private:
    bool mayLieSo(const Points2& Q) const {
        return std::ranges::all_of(
            simpleLoops_, [&](const std::vector<int>& loop) { return outlineIsSimple(Q, loop); });
    }

    /// @param gradient  the objective's gradient at Q
    Points2 lagrangian(const Points2& Q, const Points2& gradient) const {
        Points2 g = gradient;
        constraints_.addForces(constraints_.directions(Q), multipliers_, g);
        return g;
    }

    /// The part of the step that lowers the objective most, ignoring the lengths; above 1 if the
    /// model is too stiff.
    double usefulPart(const Points2& Q, const IsometricObjective::Value& at,
                      const Points2& P) const {
        const double most = kBackOff * objective_.largestStep(Q, P, kLongestStep / kBackOff);
        const auto valueAt = [&](double t) -> double {
            return objective_.evaluate(Q + t * P).total;
        };
        double t = std::min(1.0, most);
        double reached = valueAt(t);
        for (int k = 0; k < kMaxHalvings && !(reached < at.total) && !progress_.isCancelled();
             ++k) {
            t *= 0.5;
            reached = valueAt(t);
        }
        bool stretched = false;
        while (t < most && !progress_.isCancelled()) {
            const double further = std::min(most, kStretch * t);
            const double there = valueAt(further);
            if (!(there < reached)) {
                break;
            }
            t = further;
            reached = there;
            stretched = true;
        }
        for (int k = 0; k < kMaxShortenings && !stretched && !progress_.isCancelled(); ++k) {
            const double there = valueAt(kShorten * t);
            if (!(there < reached)) {
                break;
            }
            t *= kShorten;
            reached = there;
        }
        return t;
    }

    /// Restores the exact boundary lengths after a step. If they are off by much, the whole piece
    /// moves by the quadratic model, with the step's own factorisation; moving the boundary alone
    /// would flip the triangles along it.
    /// @param contacts  null, or the model's contacts, whose gaps `step` must keep too
    bool regainLengths(Points2& Q, const Points2& step,
                       const std::vector<OutlineBarrier::Contact>* contacts) {
        for (int k = 0; k < kMaxCorrections; ++k) {
            const Eigen::VectorXd c = constraints_.residual(Q);
            const double worst = c.cwiseQuotient(lengths_).lpNorm<Eigen::Infinity>();
            Points2 forces = Points2::Zero(Q.rows(), 2);
            const bool isNarrow =
                contacts != nullptr && OutlineBarrier::addOpeningForces(*contacts, step, Q, forces);
            if (worst <= kSmallCorrection && !isNarrow) {
                break;
            }
            if (!(worst <= kLargestCorrection)) {
                return false;
            }
            Eigen::VectorXd y = Eigen::VectorXd::Zero(c.size());
            const auto P = kkt_.solve(forces, c, y);
            if (!P) {
                return false;
            }
            Q += *P;
        }
        return constraints_.restore(Q);
    }

    const Progress& progress_;
    std::vector<std::vector<int>> simpleLoops_;  ///< those that must stay simple
    Eigen::VectorXd lengths_;
    IsometricObjective objective_;
    LengthConstraints constraints_;
    KktSolver kkt_;
    LbfgsHistory history_;
    Eigen::VectorXd multipliers_;
    Points2 gradient_;  ///< of the objective at the present point; no rows if unknown
};

}  // namespace

DescentOptions descentOptions(Quality quality, const EnergyModel& energy) {
    DescentOptions options;
    options.energy = energy;
    options.tolerance = quality == Quality::Draft      ? 2e-2
                        : quality == Quality::Standard ? 1e-4
                                                       : 1e-7;
    options.maxIterations = quality == Quality::Fine ? 5000 : options.maxIterations;
    return options;
}

double nearLimit(double before) {
    constexpr double kSlight = 2 * 0.05 * 0.05;
    constexpr double kMax = 2 * 0.16 * 0.16;
    constexpr double kShare = 10;  // of the energy, which is the square of the strain
    return before + std::max(kSlight, std::min(kMax, kShare * (before - 1)));
}

bool isNear(double energy, double before) {
    return energy <= nearLimit(before);
}

Result<DescentResult> lowerIsometricEnergy(const MeshArrays& mesh, const EdgeTable& table,
                                           const EdgeLoops& loops, const Points2& start,
                                           const DescentOptions& options,
                                           const Progress& progress) {
    Descent descent(mesh, table, loops, options, progress);
    DescentResult result;
    result.Q = start;
    IsometricObjective::Value at = descent.objective().evaluate(start);
    if (!std::isfinite(at.total)) {
        return Error{ErrorCode::NotFinite, {}, "the start has flipped triangles or touches itself"};
    }
    if (!descent.hasLengths(start)) {
        if (const auto exact = descent.makeExact(result.Q, at); !exact) {
            return exact.error();
        }
    }
    const Points2 exactStart = result.Q;
    RefactorisationPolicy policy(options.model == nullptr);
    std::vector<double> reached{at.total};
    while (result.iterations < options.maxIterations && !progress.isCancelled()) {
        const bool fresh = policy.isFresh();
        if (fresh) {
            descent.clearHistory();
            if (const auto renewed = descent.renew(result.Q, at); !renewed) {
                if (renewed.error().code == ErrorCode::OutOfMemory) {
                    return renewed.error();
                }
                break;  // keep the last valid result
            }
        }
        double predicted = 0;
        const auto step = descent.step(result.Q, at, predicted);
        if (!step && step.error().code == ErrorCode::OutOfMemory) {
            return step.error();
        }
        const double wanted = options.tolerance * std::max(at.total - 1, kNoExcess);
        const double enough = fresh ? wanted : kStaleTolerance * wanted;
        // A step that predicts a rise was not solved exactly enough to continue.
        result.converged = step && std::abs(predicted) <= enough;
        const double before = at.total;
        const double part = step && predicted > enough
                                ? descent.advance(result.Q, at, *step, predicted, !fresh)
                                : 0;
        if (part == 0) {
            if (fresh || result.converged) {
                break;
            }
            policy.renew();
            continue;
        }
        ++result.iterations;
        policy.count(part, predicted, before - at.total, descent.renewingCost());
        if (policy.hasArrived(wanted)) {
            result.converged = true;
            break;
        }
        if (policy.wasStopped()) {
            descent.relax(result.Q, at);
        }
        reached.push_back(at.total);
        if (reached.size() > kLookBack) {
            const double fallen = reached[reached.size() - 1 - kLookBack] - at.total;
            result.isHopeless = at.total - options.wanted > kHopeless * fallen;
            // Contacts stop each step, which `hasArrived` ignores; the outline is simple.
            const bool isHeldUp = options.keepOutlineSimple && at.total <= options.wanted &&
                                  fallen <= kLookBack * wanted;
            if (result.isHopeless || isHeldUp) {
                break;
            }
        }
        progress.step();
    }
    result.multipliers = descent.multipliers();
    if (options.sharesModel) {
        result.model = descent.kkt().share();
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    // The objective has fallen, but its small terms may have fallen at the cost of the distortion.
    const double before = descent.objective().distortion(exactStart);
    result.distortion = descent.objective().distortion(result.Q);
    if (result.distortion > before && !options.keepOutlineSimple) {
        result.Q = exactStart;
        result.distortion = before;
    }
    return result;
}

}  // namespace toile::isometric
