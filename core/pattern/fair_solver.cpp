// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/fair_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>

#include "core/geometry/segment.h"

namespace toile::fairing {
namespace {

constexpr int kPhi = 2, kKappa = 3;  // indices in a state; 0 and 1 are p

using Eigen::Matrix4d;
using Eigen::Vector4d;

/// Penalty weight of x_n = x_0, in addition to its multipliers. It does not change the solution,
/// but bounds x_n in the first steps of the recursion, which have no other terms.
constexpr double kEndWeight = 1;
constexpr double kSingular = 1e-14;

}  // namespace

/// Gradients by the first state and by the end that a right-hand side leads to.
struct CyclicKkt::Ends {
    State state = State::Zero();
    State end = State::Zero();
};

void CyclicKkt::factorise(const std::vector<KktStep>& steps) {
    assert(!steps.empty());
    steps_ = steps;
    links_.resize(steps.size());
    negative_ = 0;
    Matrix4d P = kEndWeight * Matrix4d::Identity();  // of the cost-to-go, by the state
    Matrix4d W = Matrix4d::Identity();               // by state and end
    Matrix4d M = Matrix4d::Zero();                   // by the end
    for (std::size_t j = steps.size(); j-- > 0;) {
        const KktStep& step = steps[j];
        Link& link = links_[j];
        // phi_(j+1) = phi_j + spacing kappa_(j+1)
        P.row(kKappa) += step.spacing * P.row(kPhi);
        P.col(kKappa) += step.spacing * P.col(kPhi);
        W.row(kKappa) += step.spacing * W.row(kPhi);
        // kappa_(j+1) is eliminated, or given.
        link.weight = P(kKappa, kKappa);
        link.inverse = step.held ? 0 : 1 / (link.weight + step.bend);
        negative_ += link.inverse < 0 ? 1 : 0;
        link.coupling << P.col(kKappa).head<3>(), -step.bend;
        link.end = W.row(kKappa).transpose();
        P.row(kKappa).setZero();
        P.col(kKappa).setZero();
        W.row(kKappa).setZero();
        P.noalias() -= (link.inverse * link.coupling) * link.coupling.transpose();
        P(kKappa, kKappa) = step.held ? step.bend : step.bend * link.weight * link.inverse;
        W.noalias() -= (link.inverse * link.coupling) * link.end.transpose();
        M.noalias() -= (link.inverse * link.end) * link.end.transpose();
        // p_(j+1) = p_j + lever phi_j + gap
        link.byPlace = P.leftCols<2>();
        link.endByPlace = W.topRows<2>().transpose();
        P.row(kPhi) += step.lever.transpose() * P.topRows<2>();
        P.col(kPhi) += P.leftCols<2>() * step.lever;
        W.row(kPhi) += step.lever.transpose() * W.topRows<2>();
        P.topLeftCorner<2, 2>() += step.hold;
        P(kPhi, kPhi) += step.tension;
    }
    Eigen::Matrix<double, 8, 8> K;
    K << P - kEndWeight * Matrix4d::Identity(), W - Matrix4d::Identity(),
        (W - Matrix4d::Identity()).transpose(), M;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 8, 8>> eigen(K);
    const Eigen::Matrix<double, 8, 1>& values = eigen.eigenvalues();
    // If all curvatures are held the equations are singular; this takes the least-norm solution.
    const double least = kSingular * values.cwiseAbs().maxCoeff();
    Eigen::Matrix<double, 8, 1> inverses;
    for (int k = 0; k < 8; ++k) {
        negative_ += values[k] < -least ? 1 : 0;
        inverses[k] = std::abs(values[k]) > least ? 1 / values[k] : 0;
    }
    closing_ = eigen.eigenvectors() * inverses.asDiagonal() * eigen.eigenvectors().transpose();
}

CyclicKkt::Ends CyclicKkt::sweepBack(const std::vector<KktRight>& right,
                                     std::vector<KktMove>& moves) const {
    Ends ends;
    Vector4d& q = ends.state;
    for (std::size_t j = steps_.size(); j-- > 0;) {
        const KktStep& step = steps_[j];
        const KktRight& r = right[j];
        const Link& link = links_[j];
        const double own = q[kKappa] + step.spacing * q[kPhi];
        const double push = own + step.bend * r.slope;
        const double kappa = step.held ? r.given : -link.inverse * push;
        q.head<3>() += kappa * link.coupling.head<3>();
        // Equal to -bend (kappa + slope), without its cancellation.
        q[kKappa] = step.held ? -step.bend * (kappa + r.slope)
                              : step.bend * link.inverse * (own - link.weight * r.slope);
        ends.end += kappa * link.end + link.endByPlace * r.gap;
        q += link.byPlace * r.gap;
        q[kPhi] += step.lever.dot(q.head<2>());
        q.head<2>() += r.force;
        moves[j].kappa = kappa;  // without the effect of state and end
    }
    return ends;
}

void CyclicKkt::solve(const std::vector<KktRight>& right, std::vector<KktMove>& moves) const {
    assert(right.size() == steps_.size());
    moves.resize(steps_.size());
    const Ends ends = sweepBack(right, moves);
    Eigen::Matrix<double, 8, 1> gradient;
    gradient << ends.state, ends.end;
    const Eigen::Matrix<double, 8, 1> closed = -(closing_ * gradient);
    Vector4d x = closed.head<4>();
    const Vector4d end = closed.tail<4>();
    for (std::size_t j = 0; j < steps_.size(); ++j) {
        const KktStep& step = steps_[j];
        KktMove& move = moves[j];
        move.p = x.head<2>();
        move.phi = x[kPhi];
        x.head<2>() += step.lever * x[kPhi] + right[j].gap;
        move.kappa -= links_[j].inverse * (links_[j].coupling.dot(x) + links_[j].end.dot(end));
        x[kPhi] += step.spacing * move.kappa;
        x[kKappa] = move.kappa;
    }
    addMultipliers(right, end + kEndWeight * closed.head<4>(), moves);
}

/// Backwards: the pull of a step is that of the next step plus the forces on the node between.
void CyclicKkt::addMultipliers(const std::vector<KktRight>& right, const State& end,
                               std::vector<KktMove>& moves) const {
    State costate = end;
    for (std::size_t j = steps_.size(); j-- > 0;) {
        const KktStep& step = steps_[j];
        KktMove& move = moves[j];
        const double before = moves[j > 0 ? j - 1 : steps_.size() - 1].kappa;
        const double bending = step.bend * (move.kappa - before + right[j].slope);
        move.pull = costate.head<2>();
        move.torque = step.held ? costate[kKappa] + step.spacing * costate[kPhi] + bending : 0;
        costate[kPhi] += step.lever.dot(move.pull) + step.tension * move.phi;
        costate[kKappa] = -bending;
        costate.head<2>() += step.hold * move.p + right[j].force;
    }
}

double CyclicKkt::curvature(const std::vector<KktMove>& moves) const {
    double sum = 0;
    double before = moves.back().kappa;
    for (std::size_t j = 0; j < steps_.size(); ++j) {
        const KktStep& step = steps_[j];
        const double change = moves[j].kappa - before;
        sum += step.bend * change * change + step.tension * moves[j].phi * moves[j].phi +
               moves[j].p.dot(step.hold * moves[j].p);
        before = moves[j].kappa;
    }
    return sum;
}

namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kPi = std::numbers::pi;
constexpr double kRoomLeft = 0.05;  // of a node's room: with a fixed distance one node blocks all

Vector2d along(double phi) {
    return {std::cos(phi), std::sin(phi)};
}

/// `angle` plus the multiple of 2 pi that brings it nearest to `other`.
double nearestTurn(double angle, double other) {
    return angle - 2 * kPi * std::round((angle - other) / (2 * kPi));
}

}  // namespace

FairModel::FairModel(const FairProblem& problem)
    : unit_(problem.smoothing),
      reference_(problem.reference / unit_),
      steps_(problem.steps / unit_),
      tolerance_(problem.tolerance / unit_),
      spacing_(steps_.size()),
      bends_(2 * steps_.cwiseInverse()),
      held_(static_cast<std::size_t>(steps_.size()), 0),
      wanted_(VectorXd::Zero(steps_.size())),
      first_(steps_.size()) {
    const int n = count();
    for (const FairProblem::Run& run : problem.straight) {
        for (int j = run.first + 1; j < run.last; ++j) {
            held_[j % n] = 1;
        }
    }
    for (const FairProblem::Corner& corner : problem.corners) {
        held_[corner.node] = corner.isFree ? 0 : 1;
        wanted_[corner.node] = corner.turn;
        bends_[corner.node] = bends_[(corner.node + n - 1) % n] = 0;
    }
    for (int j = 0; j < n; ++j) {
        spacing_[next(j)] = 0.5 * (steps_[j] + steps_[next(j)]);
    }
    // At a cusp the sign of the turn is ambiguous; the wanted turn decides.
    for (int j = 0; j < n; ++j) {
        const Vector2d before = reference_.row(j) - reference_.row((j + n - 1) % n);
        const Vector2d after = reference_.row(next(j)) - reference_.row(j);
        const double turn = nearestTurn(geometry::turnBetween(before, after), wanted_[j]);
        first_[j] = j == 0 ? std::atan2(after.y(), after.x()) : first_[j - 1] + turn;
        round_ += turn;
    }
    round_ = 2 * kPi * std::round(round_ / (2 * kPi));
}

LineState FairModel::start() const {
    return {first_, reference_, VectorXd::Ones(count()), Points2::Zero(count(), 2)};
}

double FairModel::turn(const VectorXd& phi, int j) const {
    return j == 0 ? phi[0] - phi[count() - 1] + round_ : phi[j] - phi[j - 1];
}

double FairModel::room(const Points2& p, int j) const {
    return 1 - (p.row(j) - reference_.row(j)).squaredNorm() / (tolerance_[j] * tolerance_[j]);
}

double FairModel::longestShare(const Points2& p, const std::vector<KktMove>& moves) const {
    double share = 1;
    for (int j = 0; j < count(); ++j) {
        // |d + t m|^2 = tol^2 (1 - kRoomLeft room), the larger root
        const Vector2d d = (p.row(j) - reference_.row(j)) / tolerance_[j];
        const Vector2d m = moves[j].p / tolerance_[j];
        const double a = m.squaredNorm(), b = d.dot(m);
        const double c = (1 - kRoomLeft) * (1 - d.squaredNorm());
        if (a + 2 * b > c) {
            share = std::min(share, c / (b + std::sqrt(b * b + a * c)));
        }
    }
    return share;
}

double FairModel::dualMove(const LineState& state, const KktMove& move, int j) const {
    const double s = room(state.p, j), z = state.z[j];
    const Vector2d d = state.p.row(j) - reference_.row(j);
    return 1 / s - z + 2 * (z / s) * d.dot(move.p) / (tolerance_[j] * tolerance_[j]);
}

double FairModel::objective(const LineState& state, double share) const {
    double bent = 0, away = 0;
    double before = kappa(state.phi, 0);
    for (int j = 0; j < count(); ++j) {
        const double s = room(state.p, j);
        if (!(s > 0)) {
            return std::numeric_limits<double>::infinity();
        }
        const double after = kappa(state.phi, next(j));
        bent += 0.5 * bends_[j] * (after - before) * (after - before);
        away -= spacing_[j] * tolerance_[j] * tolerance_[j] * std::log(s);
        before = after;
    }
    return std::pow(share, 6) * bent + away;
}

double FairModel::slope(const std::vector<KktRight>& right, const std::vector<KktMove>& moves,
                        double share) const {
    const double weight = std::pow(share, 6);
    double sum = 0;
    double before = moves.back().kappa;
    for (int j = 0; j < count(); ++j) {
        sum += weight * bends_[j] * right[j].slope * (moves[j].kappa - before) +
               right[j].force.dot(moves[j].p);
        before = moves[j].kappa;
    }
    return sum;
}

double FairModel::violation(const std::vector<KktRight>& right) const {
    double sum = 0;
    for (int j = 0; j < count(); ++j) {
        sum += right[j].gap.lpNorm<1>() + std::abs(right[j].given) * spacing_[next(j)];
    }
    return sum;
}

double FairModel::largestMultiplier(const std::vector<KktMove>& moves) const {
    double largest = 0;
    for (int j = 0; j < count(); ++j) {
        largest = std::max({largest, moves[j].pull.lpNorm<Eigen::Infinity>(),
                            std::abs(moves[j].torque) / spacing_[next(j)]});
    }
    return largest;
}

void FairModel::writeMatrix(const LineState& state, double share, bool convex,
                            std::vector<KktStep>& steps) const {
    steps.resize(steps_.size());
    const double bend = std::pow(share, 6);
    for (int j = 0; j < count(); ++j) {
        const Vector2d u = along(state.phi[j]);
        const double tension = -steps_[j] * u.dot(state.pull.row(j));
        const double s = room(state.p, j), z = state.z[j];
        const Vector2d d = (state.p.row(j) - reference_.row(j)) / tolerance_[j];
        steps[j].lever = steps_[j] * geometry::leftOf(u);
        steps[j].bend = bend * bends_[j];
        steps[j].spacing = spacing_[next(j)];
        steps[j].held = held_[next(j)] != 0;
        steps[j].tension = convex ? std::max(tension, 0.0) : tension;
        steps[j].hold =
            2 * spacing_[j] * z * (Eigen::Matrix2d::Identity() + (2 / s) * d * d.transpose());
    }
}

void FairModel::writeGradients(const LineState& state, std::vector<KktRight>& right) const {
    right.resize(steps_.size());
    for (int j = 0; j < count(); ++j) {
        const Vector2d d = state.p.row(j) - reference_.row(j);
        right[j].force = 2 * spacing_[j] / room(state.p, j) * d;
        right[j].slope = kappa(state.phi, next(j)) - kappa(state.phi, j);
    }
}

void FairModel::writeConstraints(const LineState& state, std::vector<KktRight>& right) const {
    right.resize(steps_.size());
    for (int j = 0; j < count(); ++j) {
        const int k = next(j);
        right[j].gap =
            steps_[j] * along(state.phi[j]) - (state.p.row(k) - state.p.row(j)).transpose();
        right[j].given = held_[k] != 0 ? (wanted_[k] - turn(state.phi, k)) / spacing_[k] : 0;
    }
}

Points2 FairModel::walked(const LineState& state, double& gap) const {
    Points2 points(count(), 2);
    Vector2d at = unit_ * state.p.row(0).transpose();
    const Vector2d begin = at;
    for (int j = 0; j < count(); ++j) {
        points.row(j) = at;
        at += unit_ * steps_[j] * along(state.phi[j]);
    }
    const double perimeter = unit_ * steps_.sum();
    const Vector2d rest = at - begin;
    double way = 0;
    for (int j = 0; j < count(); ++j) {
        points.row(j) -= (way / perimeter) * rest.transpose();
        way += unit_ * steps_[j];
    }
    gap = rest.norm() / perimeter;
    return points;
}

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

void FairSolver::restart() {
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
