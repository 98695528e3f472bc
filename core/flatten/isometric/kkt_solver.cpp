// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/kkt_solver.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/flatten/isometric/coarsening.h"
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

namespace {

constexpr int kMaxMultiplierUpdates = 12;
/// Change of a length, relative to the largest motion, that a step may leave: the lengths are
/// restored after it, and the next step starts from its multipliers.
constexpr double kLinearisedLengths = 1e-3;
/// Added to the diagonal, relative to it.
constexpr double kRegularisation[] = {1e-9, 1e-6, 1e-3};
/// Cost of a factorisation, in back-substitutions.
constexpr double kFactorisingCost = 12;
/// Rounds of conjugate gradients that take about as long as a factorisation or two: after so many,
/// more will follow, and back-substitutions would be cheaper.
constexpr int kManyRounds = 100;
/// Cost of a new coarse level, in solutions by conjugate gradients.
constexpr double kCoarseningCost = 1;

}  // namespace

KktSolver::KktSolver(const MeshArrays& mesh, const EdgeTable& table, const Eigen::VectorXd& lengths,
                     const LengthConstraints& constraints, bool keepOutlineSimple,
                     const KktSizes& sizes, const Progress& progress)
    : constraints_(constraints),
      progress_(progress),
      large_(mesh.V.rows() >= sizes.large),
      huge_(mesh.V.rows() >= sizes.huge) {
    if (large_) {
        twoLevel_.emplace(mesh, table, constraints.loops(), lengths, keepOutlineSimple, progress,
                          sizes.accuracy);
    }
}

double KktSolver::renewingCost() const {
    return twoLevel_ ? kCoarseningCost : kFactorisingCost;
}

Result<void> KktSolver::renew(IsometricObjective& objective, const ModelPoint& point) {
    adopted_ = nullptr;
    factorised_ = false;
    directions_ = constraints_.directions(point.Q);
    if (twoLevel_ && !huge_ && twoLevel_->rounds() > kManyRounds) {
        twoLevel_.reset();
    }
    Result<void> ready = Error{ErrorCode::FactorisationFailed};
    for (const double regularisation : kRegularisation) {
        const auto hessian = objective.hessian(point.Q, point.at);
        laidOut_ = laidOut_ && hessian.samePattern;
        K_ = &hessian.matrix;
        addSpring(hessian.matrix, constraints_.loops().vertex(0));
        stiffness_ = lengthStiffness(hessian.matrix, constraints_.loops());
        addLengths(hessian.matrix, constraints_, point, stiffness_, regularisation);
        ready = layOut(point, regularisation);
        if (ready || ready.error().code != ErrorCode::FactorisationFailed) {
            break;
        }
    }
    return ready;
}

Result<void> KktSolver::layOut(const ModelPoint& point, double regularisation) {
    if (twoLevel_) {
        auto ready = twoLevel_->renew(*K_, point, stiffness_, regularisation);
        if (ready || ready.error().code != ErrorCode::FactorisationFailed) {
            return ready;
        }
        twoLevel_.reset();
    }
    return factorise(*K_);
}

Result<void> KktSolver::factorise(const linalg::BlockMatrix& K) {
    if (cholesky_ == nullptr || cholesky_.use_count() > 1) {
        cholesky_ = std::make_shared<linalg::SparseCholesky>();  // a shared factor must not change
        laidOut_ = false;
    }
    if (!laidOut_) {
        if (auto analysed = cholesky_->analyse(K.matrix()); !analysed) {
            return analysed;
        }
        laidOut_ = true;
    }
    auto factorised = cholesky_->refactorise(K.matrix());
    factorised_ = factorised.ok();
    return factorised;
}

std::shared_ptr<const KktModel> KktSolver::share() const {
    if (adopted_ || !factorised_ || large_) {
        return adopted_;
    }
    return std::make_shared<const KktModel>(KktModel{cholesky_, directions_, stiffness_});
}

Result<Points2> KktSolver::solve(const Points2& right, const Eigen::VectorXd& c,
                                 Eigen::VectorXd& y) {
    const Points2& directions = adopted_ ? adopted_->directions : directions_;
    const Eigen::VectorXd& stiffness = adopted_ ? adopted_->stiffness : stiffness_;
    Points2 P = Points2::Zero(right.rows(), 2);
    double first = 0;  // error that conjugate gradients start with
    for (int k = 0; k < kMaxMultiplierUpdates; ++k) {
        Points2 forces = right;
        constraints_.addForces(directions, -(y + stiffness.cwiseProduct(c)), forces);
        if (const auto solved = solveOnce(forces, P, first); !solved) {
            return solved.error();
        }
        constraints_.loops().clearHeld(P);
        const Eigen::VectorXd left = constraints_.along(directions, P) + c;
        y += stiffness.cwiseProduct(left);
        if (left.lpNorm<Eigen::Infinity>() <= kLinearisedLengths * P.lpNorm<Eigen::Infinity>()) {
            break;
        }
    }
    return P;
}

Result<void> KktSolver::solveOnce(const Points2& forces, Points2& P, double& first) {
    if (twoLevel_ && !adopted_) {
        if (twoLevel_->solve(forces, P, first)) {
            return {};
        }
        if (progress_.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        // Rare: factorise after all, which needs more memory.
        twoLevel_.reset();
        if (auto factorised = factorise(*K_); !factorised) {
            return factorised;
        }
    }
    const Eigen::Map<const Eigen::VectorXd> b(forces.data(), forces.size());
    const auto solved = (adopted_ ? *adopted_->factor : *cholesky_).solve(b);
    if (!solved) {
        return solved.error();
    }
    if (!solved->allFinite()) {
        return Error{ErrorCode::NotFinite, {}, "a step of the isometric descent"};
    }
    P = Eigen::Map<const Points2>(solved->data(), forces.rows(), 2);
    return {};
}

namespace {

/// Remaining error of a follow-up solution, in the energy norm, relative to its first guess: even a
/// small change of the right side must have an effect.
constexpr double kAccuracyAfter = 0.1;
/// Errors below this are rounding.
constexpr double kNoError = 1e-8;
constexpr int kMaxIterations = 200;

}  // namespace

/// The coarse piece and its matrix.
struct TwoLevelSolver::Coarse {
    Coarse(const MeshArrays& mesh, const EdgeTable& fine, const EdgeLoops& loops, const Points2& Q,
           const Eigen::VectorXd& lengths, bool keepOutlineSimple, const Progress& progress)
        : piece(mesh, fine, loops, Q, progress),
          table(buildEdgeTable(piece.mesh().F, static_cast<int>(piece.mesh().V.rows()))),
          objective(piece.mesh(), table, piece.loops(), lengths, keepOutlineSimple),
          constraints(piece.loops(), lengths) {}
    Coarse(const Coarse&) = delete;
    Coarse& operator=(const Coarse&) = delete;

    Coarsening piece;
    EdgeTable table;
    IsometricObjective objective;
    LengthConstraints constraints;
    linalg::SparseCholesky cholesky;
};

TwoLevelSolver::TwoLevelSolver(const MeshArrays& mesh, const EdgeTable& table, EdgeLoops loops,
                               const Eigen::VectorXd& lengths, bool keepOutlineSimple,
                               const Progress& progress, double accuracy)
    : mesh_(mesh),
      table_(table),
      loops_(std::move(loops)),
      lengths_(lengths),
      keepOutlineSimple_(keepOutlineSimple),
      progress_(progress),
      accuracy_(accuracy) {}

TwoLevelSolver::~TwoLevelSolver() = default;

Result<void> TwoLevelSolver::renew(const linalg::BlockMatrix& K, const ModelPoint& point,
                                   const Eigen::VectorXd& stiffness, double regularisation) {
    K_ = &K;
    coarse_.reset();
    // Coarsened again each time: its triangles must not be flipped at this point.
    coarse_ = std::make_unique<Coarse>(mesh_, table_, loops_, point.Q, lengths_, keepOutlineSimple_,
                                       progress_);
    if (progress_.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    if (!coarse_->piece.savesWork()) {
        return Error{ErrorCode::FactorisationFailed, {}, "no coarse piece"};
    }
    const Points2 Q = coarse_->piece.restricted(point.Q);
    const auto at = coarse_->objective.evaluate(Q);
    linalg::BlockMatrix& coarse = coarse_->objective.hessian(Q, at).matrix;
    addSpring(coarse, coarse_->piece.loops().vertex(0));
    addLengths(coarse, coarse_->constraints, {Q, at, point.multipliers}, stiffness, regularisation);
    if (progress_.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    return coarse_->cholesky.factorise(coarse.matrix());
}

bool TwoLevelSolver::solve(const Points2& right, Points2& x, double& first) {
    // Conjugate gradients [NW06].
    Points2 r = right - K_->product(x);
    Points2 d;
    double rz = 0;
    double enough = 0;
    for (int k = 0; k < kMaxIterations; ++k) {
        const auto z = precondition(r);
        if (!z) {
            return false;
        }
        const double before = std::exchange(rz, dot(r, *z));
        if (k == 0) {
            const bool follows = first > 0;
            first = follows ? first : rz;
            enough = accuracy_ * accuracy_ * first;
            if (follows) {
                enough = std::clamp(kAccuracyAfter * kAccuracyAfter * rz,
                                    kNoError * kNoError * first, enough);
            }
        }
        if (!(rz >= 0 && std::isfinite(rz))) {
            return false;
        }
        if (rz <= enough) {
            return true;
        }
        if (k == 0) {
            d = *z;
        } else {
            d = *z + rz / before * d;
        }
        ++rounds_;
        const Points2 Kd = K_->product(d);
        const double stiffness = dot(d, Kd);
        if (!(stiffness > 0)) {
            return false;
        }
        x += rz / stiffness * d;
        r -= rz / stiffness * Kd;
    }
    return false;
}

std::optional<Points2> TwoLevelSolver::precondition(const Points2& residual) {
    // Forward sweep, coarse level, backward sweep: symmetric and positive definite.
    Points2 z = residual;
    K_->sweepForth(z);
    Points2 left = -K_->upperProduct(z);
    if (progress_.isCancelled()) {
        return std::nullopt;
    }
    const Points2 coarse = coarse_->piece.restrictedForces(left);
    const auto solved =
        coarse_->cholesky.solve(Eigen::Map<const Eigen::VectorXd>(coarse.data(), coarse.size()));
    if (!solved) {
        return std::nullopt;
    }
    const Points2 motion =
        coarse_->piece.prolongedMotion(Eigen::Map<const Points2>(solved->data(), coarse.rows(), 2));
    if (progress_.isCancelled()) {
        return std::nullopt;
    }
    z += motion;
    left -= K_->product(motion);
    K_->sweepBack(left);
    z += left;
    return z;
}

}  // namespace toile::isometric
