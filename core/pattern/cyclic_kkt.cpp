// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/cyclic_kkt.h"

#include <cassert>
#include <cmath>

#include <Eigen/Eigenvalues>

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

}  // namespace toile::fairing
