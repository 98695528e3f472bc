// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/isometric_objective.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/quality/measures.h"

namespace toile::isometric {
namespace {

/// Energy of one radian at every vertex of the outline: enough that the outline of a strongly
/// compressed piece does not buckle, too little to matter elsewhere (docs/methods/isometric.md).
constexpr double kOutlineStiffness = 0.02;
/// Stiffness of a held vertex, relative to its own. A step moves it only in the eighth digit, which
/// `KktSolver` removes, and its neighbours are not affected.
constexpr double kHeldStiffness = 1e8;

std::pair<int, int> ordered(int v, int w) {
    return {std::min(v, w), std::max(v, w)};
}

}  // namespace

IsometricObjective::IsometricObjective(const MeshArrays& mesh, const EdgeTable& table,
                                       EdgeLoops loops, const Eigen::VectorXd& lengths,
                                       bool keepOutlineSimple, const EnergyModel& model)
    : table_(table),
      loops_(std::move(loops)),
      vertexCount_(static_cast<int>(mesh.V.rows())),
      energy_(model.make(mesh, table)),
      bending_(loops_, boundaryAngles3d(mesh, loops_.vertices()), lengths, kOutlineStiffness) {
    for (int k = 0; k < loops_.loopCount() && keepOutlineSimple; ++k) {
        const int first = loops_.start(k);
        barriers_.emplace_back(loops_.loop(k), lengths.segment(first, loops_.start(k + 1) - first));
    }
}

IsometricObjective::Value IsometricObjective::evaluate(const Points2& Q) const {
    Value value{energy_->energy(Q), {}};
    if (std::isfinite(value.total)) {
        value.total += bending_.energy(Q);
        for (const OutlineBarrier& barrier : barriers_) {
            const auto contacts = barrier.contacts(Q);
            value.contacts.insert(value.contacts.end(), contacts.begin(), contacts.end());
        }
        value.total += OutlineBarrier::energy(value.contacts);
    }
    return value;
}

Points2 IsometricObjective::gradient(const Points2& Q, const Value& at) const {
    Points2 g = energy_->gradient(Q);
    bending_.addGradient(Q, g);
    OutlineBarrier::addGradient(at.contacts, g);
    loops_.clearHeld(g);
    return g;
}

IsometricObjective::Hessian IsometricObjective::hessian(const Points2& Q, const Value& at) {
    const bool samePattern = layOut(at.contacts);
    matrix_->setZero();
    energy_->addHessian(Q, edgeOf_, *matrix_);
    bending_.addHessian(Q, *matrix_);
    OutlineBarrier::addHessian(at.contacts, *matrix_);
    for (int i = 0; i < loops_.start(1) && loops_.holdsOutline(); ++i) {
        const int v = loops_.vertex(i);
        const double stiffness = kHeldStiffness * matrix_->largestOnDiagonal(v);
        matrix_->addVertex(v, stiffness * Eigen::Matrix2d::Identity());
    }
    return {*matrix_, samePattern};
}

double IsometricObjective::largestStep(const Points2& Q, const Points2& P, double limit) const {
    double step = energy_->largestStep(Q, P, limit);
    for (const OutlineBarrier& barrier : barriers_) {
        step = barrier.largestStep(Q, P, step);
    }
    return step;
}

/// Adds the mesh's edges, the pairs of each boundary vertex and the next but one, and the vertices
/// of contacts. True if the pattern is unchanged.
bool IsometricObjective::layOut(const std::vector<OutlineBarrier::Contact>& contacts) {
    const int n = loops_.count();
    std::vector<std::pair<int, int>> extra;
    extra.reserve(static_cast<std::size_t>(n) + 2 * contacts.size());
    for (int i = 0; i < n; ++i) {
        extra.push_back(ordered(loops_.vertex(i), loops_.end(loops_.next(i))));
    }
    for (const OutlineBarrier::Contact& c : contacts) {
        extra.push_back(ordered(c.vertex, c.from));
        extra.push_back(ordered(c.vertex, c.to));
    }
    std::sort(extra.begin(), extra.end());
    extra.erase(std::unique(extra.begin(), extra.end()), extra.end());
    if (matrix_ && extra == extra_) {
        return true;
    }
    extra_ = std::move(extra);
    std::vector<std::pair<int, int>> mesh, all;
    for (int e = 0; e < table_.edges.rows(); ++e) {
        mesh.emplace_back(table_.edges(e, 0), table_.edges(e, 1));
    }
    std::ranges::set_union(mesh, extra_, std::back_inserter(all));
    geometry::VertexPairs pairs(static_cast<Eigen::Index>(all.size()), 2);
    for (std::size_t e = 0; e < all.size(); ++e) {
        pairs.row(static_cast<Eigen::Index>(e)) << all[e].first, all[e].second;
    }
    matrix_.emplace(pairs, vertexCount_);
    edgeOf_.clear();
    for (const auto& [v, w] : mesh) {
        edgeOf_.push_back(matrix_->findEdge(v, w));
    }
    return false;
}

namespace {

constexpr double kStiffness = 1e4;

}  // namespace

Eigen::VectorXd lengthStiffness(const linalg::BlockMatrix& hessian, const EdgeLoops& loops) {
    Eigen::VectorXd stiffness(loops.count());
    for (int i = 0; i < loops.count(); ++i) {
        stiffness[i] = kStiffness * std::max(hessian.largestOnDiagonal(loops.vertex(i)),
                                             hessian.largestOnDiagonal(loops.end(i)));
    }
    return stiffness;
}

void addSpring(linalg::BlockMatrix& hessian, int v) {
    hessian.addVertex(v, hessian.largestOnDiagonal(v) * Eigen::Matrix2d::Identity());
}

void addLengths(linalg::BlockMatrix& hessian, const LengthConstraints& constraints,
                const ModelPoint& point, const Eigen::VectorXd& stiffness, double regularisation) {
    hessian.scaleDiagonal(1 + regularisation);
    constraints.addHessian(point.Q, stiffness, point.multipliers, hessian);
}

}  // namespace toile::isometric
