// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/fair_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace toile::fairing {
namespace {

constexpr double kSufficientDecrease = 1e-4;
constexpr double kMeritRounding = 1e-13;
constexpr double kShorter = 0.6;
constexpr double kShortest = 1e-6;  // fraction of the moves
constexpr double kFull = 0.99;
/// Radians: smaller moves skip the line search, which rounding of the merit would make fail.
constexpr double kInBasin = 1e-7;
constexpr double kDualShare = 0.95;  // of the way to the bound z = 0
constexpr double kDualSpread = 10;   // z stays within this factor of 1 / room
constexpr int kMaxRestorations = 10;
constexpr double kRestored = 1e-12;      // of the perimeter
constexpr double kRestoringShare = 0.1;  // of lambda: enough to spread a correction

double largestTurn(const std::vector<KktMove>& moves) {
    double largest = 0;
    for (const KktMove& move : moves) {
        largest = std::max(largest, std::abs(move.phi));
    }
    return largest;
}

LineState moved(const LineState& from, const std::vector<KktMove>& moves, double taken) {
    LineState to = from;
    for (Eigen::Index j = 0; j < to.phi.size(); ++j) {
        to.phi[j] += taken * moves[j].phi;
        to.p.row(j) += taken * moves[j].p.transpose();
    }
    return to;
}

}  // namespace

bool FairSolver::iterate(double share, double done, int limit) {
    if (share_ > 0) {
        // Forces scale with the weight; unscaled multipliers would make the first move overshoot.
        const double growth = std::pow(share / share_, 6);
        state_.z *= growth;
        state_.pull *= growth;
    }
    share_ = share;
    bool convex = false;
    while (iterations_ < limit && !progress_.isCancelled()) {
        ++iterations_;
        progress_.step();
        if (!findMoves(share, convex)) {
            return false;
        }
        const double change = largestTurn(moves_);
        const bool wasConvex = convex;
        convex = !take(share);
        if (convex && wasConvex) {
            return false;
        }
        if (!convex && change < done && taken_ > kFull) {
            return true;
        }
    }
    return false;
}

void FairSolver::beginAnew() {
    state_ = model_.start();
    share_ = 0;
}

/// Computes the Newton step; if it would ascend, without the compression of the line.
bool FairSolver::findMoves(double share, bool convex) {
    model_.writeGradients(state_, right_);
    model_.writeConstraints(state_, right_);
    model_.writeMatrix(state_, share, convex, steps_);
    kkt_.factorise(steps_);
    if (!kkt_.isConvex() && !convex) {
        model_.writeMatrix(state_, share, true, steps_);
        kkt_.factorise(steps_);
    }
    kkt_.solve(right_, moves_);
    return std::isfinite(largestTurn(moves_)) && std::isfinite(moves_.front().p.sum());
}

/// Takes the largest fraction of the moves that decreases the merit. False if none does.
bool FairSolver::take(double share) {
    const double weight = 2 * model_.largestMultiplier(moves_);
    const double violation = model_.violation(right_);
    const double before = model_.objective(state_, share) + weight * violation;
    const double slope = model_.slope(right_, moves_, share) - weight * violation;
    const auto isBetter = [&](const LineState& trial, double taken) {
        model_.writeConstraints(trial, trialRight_);
        const double after =
            model_.objective(trial, share) + weight * model_.violation(trialRight_);
        return after <= before + kSufficientDecrease * taken * std::min(slope, 0.0) +
                            kMeritRounding * std::abs(before);
    };
    const double longest = model_.longestShare(state_.p, moves_);
    if (longest == 1 && largestTurn(moves_) < kInBasin) {
        accept(moved(state_, moves_, 1), 1);
        return true;
    }
    double taken = longest;
    while (taken > kShortest) {
        LineState trial = moved(state_, moves_, taken);
        bool better = isBetter(trial, taken);
        if (!better && taken == longest) {
            correct(trial);  // second-order correction for curved constraints
            better = isBetter(trial, taken);
        }
        if (better) {
            accept(std::move(trial), taken);
            return true;
        }
        taken *= kShorter;
    }
    return false;
}

void FairSolver::accept(LineState trial, double taken) {
    const int n = model_.count();
    Eigen::VectorXd change(n);
    double share = 1;  // separate from `taken`: the z may move farther than the nodes
    for (int j = 0; j < n; ++j) {
        change[j] = model_.dualMove(state_, moves_[j], j);
        if (change[j] < 0) {
            share = std::min(share, -kDualShare * state_.z[j] / change[j]);
        }
    }
    for (int j = 0; j < n; ++j) {
        const double centre = 1 / model_.room(trial.p, j);
        trial.z[j] =
            std::clamp(state_.z[j] + share * change[j], centre / kDualSpread, centre * kDualSpread);
        trial.pull.row(j) += taken * (moves_[j].pull.transpose() - state_.pull.row(j));
    }
    state_ = std::move(trial);
    taken_ = taken;
}

/// One Newton step for the constraints only, with the last factorisation as its metric.
void FairSolver::correct(LineState& state) {
    trialRight_.assign(right_.size(), {});
    model_.writeConstraints(state, trialRight_);
    kkt_.solve(trialRight_, corrections_);
    state = moved(state, corrections_, 1);
}

bool FairSolver::restore(LineState& state) {
    right_.resize(static_cast<std::size_t>(model_.count()));
    for (int k = 0; k < kMaxRestorations; ++k) {
        model_.writeConstraints(state, right_);
        if (model_.violation(right_) < kRestored * model_.perimeter()) {
            return true;
        }
        for (int j = 0; j < model_.count(); ++j) {
            const double room = model_.room(state.p, j);
            if (!(room > 0)) {
                return false;
            }
            state.z[j] = 1 / room;
        }
        model_.writeMatrix(state, kRestoringShare, true, steps_);
        kkt_.factorise(steps_);
        correct(state);
    }
    return false;
}

}  // namespace toile::fairing
