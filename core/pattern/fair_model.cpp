// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/fair_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/geometry/segment.h"

namespace toile::fairing {
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

}  // namespace toile::fairing
