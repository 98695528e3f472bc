// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/interior/interior.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/flatten/interior/interior_edit.h"
#include "core/mesh/cotangents.h"

namespace toile {
namespace {

/// Of the time that `InteriorSystem::make` takes, about, on a piece of a million triangles: what is
/// done when the matrix is there, and when the factor is laid out.
constexpr double kAssemblyShare = 0.05;
constexpr double kAnalysisShare = 0.3;
/// Residual of an edited system's equation, in parts of the size of its terms. What a new
/// factorisation leaves is of this size.
constexpr double kFineResidual = 1e-13;
/// From this ratio of the largest diagonal entry to the least, rounding may come to decide whether
/// the matrix is positive definite, which an edited factor does not notice.
constexpr double kMostSpread = 1e10;
constexpr int kMostRefinements = 3;

/// Laplacian of the interior vertices. The edges are sorted as a symmetric matrix is, and
/// numbering the interior in vertex order keeps that, so the matrix is written in one pass.
SymmetricMatrix interiorLaplacian(const WeightedEdges& graph, const std::vector<int>& interiorIndex,
                                  const Eigen::VectorXd& diagonal) {
    const auto interiorCount = static_cast<int>(diagonal.size());
    std::size_t inside = 0;
    for (int e = 0; e < graph.edges.rows(); ++e) {
        const int i = interiorIndex[graph.edges(e, 0)];
        const int j = interiorIndex[graph.edges(e, 1)];
        inside += i >= 0 && j >= 0 ? 1 : 0;
    }
    SymmetricMatrix L;
    L.size = interiorCount;
    L.columnStart.reserve(static_cast<std::size_t>(interiorCount) + 1);
    L.row.reserve(inside + interiorCount);
    L.value.reserve(inside + interiorCount);
    const auto openColumnsUpTo = [&](int column) {
        while (static_cast<int>(L.columnStart.size()) <= column) {
            const auto next = static_cast<int>(L.columnStart.size());
            L.columnStart.push_back(static_cast<int>(L.row.size()));
            L.row.push_back(next);
            L.value.push_back(diagonal[next]);
        }
    };
    for (int e = 0; e < graph.edges.rows(); ++e) {
        const int i = interiorIndex[graph.edges(e, 0)];
        const int j = interiorIndex[graph.edges(e, 1)];
        if (i >= 0 && j >= 0) {
            openColumnsUpTo(i);
            L.row.push_back(j);
            L.value.push_back(-graph.weights[e]);
        }
    }
    openColumnsUpTo(interiorCount - 1);
    L.columnStart.push_back(static_cast<int>(L.row.size()));
    return L;
}

}  // namespace

Result<InteriorSystem> InteriorSystem::make(WeightedEdges graph, int vertexCount,
                                            const std::vector<int>& boundary,
                                            const Progress& progress) {
    InteriorSystem system = numbered(std::move(graph), vertexCount, boundary);
    if (system.interior_.empty()) {
        return system;
    }
    const auto factorised = system.factorise(progress);
    if (!factorised) {
        return factorised.error();
    }
    return system;
}

InteriorSystem InteriorSystem::numbered(WeightedEdges graph, int vertexCount,
                                        const std::vector<int>& boundary) {
    InteriorSystem system;
    system.graph_ = std::move(graph);
    system.boundary_ = boundary;
    system.interiorIndex_.assign(static_cast<std::size_t>(vertexCount), 0);
    for (const int v : boundary) {
        system.interiorIndex_[v] = -1;
    }
    for (int v = 0; v < vertexCount; ++v) {
        if (system.interiorIndex_[v] >= 0) {
            system.interiorIndex_[v] = static_cast<int>(system.interior_.size());
            system.interior_.push_back(v);
        }
    }
    return system;
}

Eigen::VectorXd InteriorSystem::diagonal() const {
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(interior_.size()));
    for (int e = 0; e < graph_.edges.rows(); ++e) {
        for (const int v : {graph_.edges(e, 0), graph_.edges(e, 1)}) {
            if (interiorIndex_[v] >= 0) {
                diagonal[interiorIndex_[v]] += graph_.weights[e];
            }
        }
    }
    return diagonal;
}

Result<void> InteriorSystem::factorise(const Progress& progress) {
    const SymmetricMatrix L = interiorLaplacian(graph_, interiorIndex_, diagonal());
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    progress.report(kAssemblyShare);
    cholesky_ = std::make_shared<SparseCholesky>();
    if (const auto analysed = cholesky_->analyse(L); !analysed) {
        return analysed.error();
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    progress.report(kAnalysisShare);
    if (const auto factorised = cholesky_->refactorise(L); !factorised) {
        return factorised.error();
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    progress.report(1);
    return {};
}

Result<InteriorSystem> InteriorSystem::makeFrom(const InteriorSystem& before,
                                                const std::vector<int>& vertexBefore,
                                                WeightedEdges graph, int vertexCount,
                                                const std::vector<int>& boundary,
                                                const Progress& progress) {
    InteriorSystem system = numbered(std::move(graph), vertexCount, boundary);
    if (system.interior_.empty()) {
        return system;
    }
    if (!before.cholesky_) {
        return Error{ErrorCode::FactorisationFailed, "", "there is no factor to begin with"};
    }
    if (const auto held = system.holdDiagonal(); !held) {
        return held.error();
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    InteriorEdit edit = editBetween(
        {before.graph_, before.interiorIndex_, static_cast<int>(before.interior_.size())},
        {system.graph_, system.interiorIndex_, static_cast<int>(system.interior_.size())},
        vertexBefore);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    auto edited = EditedCholesky::make(before.cholesky_, edit.matrix);
    if (!edited) {
        return edited.error();
    }
    system.edited_ = std::make_shared<const EditedCholesky>(std::move(*edited));
    system.editedRow_ = std::move(edit.row);
    system.editedSize_ = static_cast<int>(before.interior_.size()) + edit.matrix.addedCount;
    return system;
}

/// Errors where it takes a factorisation to say whether there is one.
Result<void> InteriorSystem::holdDiagonal() {
    diagonal_ = diagonal();
    if (!diagonal_.allFinite() || diagonal_.minCoeff() <= 0 ||
        diagonal_.maxCoeff() > kMostSpread * diagonal_.minCoeff()) {
        return Error{ErrorCode::FactorisationFailed, "", "the weights differ by too much"};
    }
    return {};
}

Result<InteriorSystem> InteriorSystem::makeNear(const InteriorSystem& before, WeightedEdges graph,
                                                const Progress& progress) {
    InteriorSystem system = before;
    if (system.interior_.empty()) {
        return system;
    }
    system.cholesky_.reset();
    system.graph_ = std::move(graph);
    if (const auto held = system.holdDiagonal(); !held) {
        return held.error();
    }
    const auto count = static_cast<int>(system.interior_.size());
    if (before.cholesky_) {
        auto unedited = EditedCholesky::make(before.cholesky_, {});
        if (!unedited) {
            return unedited.error();
        }
        system.edited_ = std::make_shared<const EditedCholesky>(std::move(*unedited));
        system.editedSize_ = count;
        system.editedRow_.resize(system.interior_.size());
        std::iota(system.editedRow_.begin(), system.editedRow_.end(), 0);
    }
    std::vector<int> same(system.interiorIndex_.size());
    std::iota(same.begin(), same.end(), 0);
    InteriorEdit edit = editBetween({before.graph_, system.interiorIndex_, count},
                                    {system.graph_, system.interiorIndex_, count}, same);
    for (auto& entry : edit.matrix.changed) {
        entry.row = system.editedRow_[entry.row];
        entry.column = system.editedRow_[entry.column];
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    auto nearby = NearbySolver::make(system.edited_, edit.matrix.changed);
    if (!nearby) {
        return nearby.error();
    }
    system.nearby_ = std::make_shared<const NearbySolver>(std::move(*nearby));
    return system;
}

std::size_t InteriorSystem::factorBytes() const {
    return cholesky_ ? cholesky_->bytes() : 0;
}

/// @param isOfTheChange  what a solution of `before` leaves (makeNear)
Eigen::MatrixXd InteriorSystem::solveEdited(const Eigen::MatrixXd& right,
                                            bool isOfTheChange) const {
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(editedSize_, right.cols());
    for (std::size_t i = 0; i < editedRow_.size(); ++i) {
        all.row(editedRow_[i]) = right.row(static_cast<Eigen::Index>(i));
    }
    if (nearby_) {
        all = isOfTheChange ? nearby_->solveChange(all) : nearby_->solve(all);
    } else {
        all = edited_->solve(all);
    }
    Eigen::MatrixXd x(right.rows(), right.cols());
    for (std::size_t i = 0; i < editedRow_.size(); ++i) {
        x.row(static_cast<Eigen::Index>(i)) = all.row(editedRow_[i]);
    }
    return x;
}

Eigen::MatrixXd InteriorSystem::residualOf(const Eigen::MatrixXd& x,
                                           const Eigen::MatrixXd& right) const {
    Eigen::MatrixXd residual = right;
    for (int e = 0; e < graph_.edges.rows(); ++e) {
        const int i = interiorIndex_[graph_.edges(e, 0)];
        const int j = interiorIndex_[graph_.edges(e, 1)];
        const double w = graph_.weights[e];
        for (Eigen::Index c = 0; c < x.cols(); ++c) {
            const double flow = w * ((i >= 0 ? x(i, c) : 0) - (j >= 0 ? x(j, c) : 0));
            if (i >= 0) {
                residual(i, c) -= flow;
            }
            if (j >= 0) {
                residual(j, c) += flow;
            }
        }
    }
    return residual;
}

/// False where something is not finite.
bool InteriorSystem::isFine(const Eigen::MatrixXd& residual, const Eigen::MatrixXd& x,
                            const Eigen::MatrixXd& right) const {
    for (Eigen::Index c = 0; c < x.cols(); ++c) {
        const double size = 2 * x.col(c).lpNorm<Eigen::Infinity>();
        for (Eigen::Index i = 0; i < x.rows(); ++i) {
            const double terms = std::abs(right(i, c)) + std::abs(diagonal_[i]) * size;
            if (!(std::abs(residual(i, c)) <= kFineResidual * terms)) {
                return false;
            }
        }
    }
    return x.allFinite();
}

Result<Eigen::MatrixXd> InteriorSystem::solveUnknowns(const Eigen::MatrixXd& right,
                                                      const Progress& progress,
                                                      const Eigen::MatrixXd* start) {
    if (edited_) {
        Eigen::MatrixXd x = start == nullptr
                                ? solveEdited(right)
                                : *start + solveEdited(residualOf(*start, right), true);
        for (int k = 0; k <= kMostRefinements; ++k) {
            if (progress.isCancelled()) {
                return Error{ErrorCode::Cancelled, "", ""};
            }
            const Eigen::MatrixXd residual = residualOf(x, right);
            if (isFine(residual, x, right)) {
                return x;
            }
            x += solveEdited(residual);
        }
        const auto factorised = factorise(progress);
        if (!factorised) {
            cholesky_.reset();
            return factorised.error();
        }
        edited_.reset();
        nearby_.reset();
        editedRow_ = {};
    }
    return cholesky_->solve(right);
}

/// What the boundary's values add to the equations of their neighbours inside. #V x k.
Eigen::MatrixXd InteriorSystem::boundaryTerms(const Eigen::MatrixXd& onBoundary) const {
    Eigen::MatrixXd values =
        Eigen::MatrixXd::Zero(static_cast<int>(interiorIndex_.size()), onBoundary.cols());
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
        values.row(boundary_[i]) = onBoundary.row(static_cast<Eigen::Index>(i));
    }
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(values.rows(), values.cols());
    for (int e = 0; e < graph_.edges.rows(); ++e) {
        const int a = graph_.edges(e, 0);
        const int b = graph_.edges(e, 1);
        if (interiorIndex_[a] >= 0 && interiorIndex_[b] < 0) {
            right.row(a) += graph_.weights[e] * values.row(b);
        } else if (interiorIndex_[b] >= 0 && interiorIndex_[a] < 0) {
            right.row(b) += graph_.weights[e] * values.row(a);
        }
    }
    return right;
}

Result<Eigen::MatrixXd> InteriorSystem::extend(const Eigen::MatrixXd& onBoundary,
                                               const Progress& progress,
                                               const Eigen::MatrixXd* start) {
    auto solved = solveAt(boundaryTerms(onBoundary), progress, start);
    if (!solved) {
        return solved.error();
    }
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
        solved->row(boundary_[i]) = onBoundary.row(static_cast<Eigen::Index>(i));
    }
    return solved;
}

Result<Eigen::MatrixXd> InteriorSystem::solve(const Eigen::MatrixXd& b, const Progress& progress) {
    return solveAt(b, progress, nullptr);
}

Result<Eigen::MatrixXd> InteriorSystem::solveAt(const Eigen::MatrixXd& b, const Progress& progress,
                                                const Eigen::MatrixXd* start) {
    const auto vertexCount = static_cast<Eigen::Index>(interiorIndex_.size());
    if (interior_.empty()) {
        return Eigen::MatrixXd(Eigen::MatrixXd::Zero(vertexCount, b.cols()));
    }
    const Eigen::MatrixXd right = b(interior_, Eigen::all);
    Eigen::MatrixXd startInside;
    if (start != nullptr) {
        startInside = (*start)(interior_, Eigen::all);
    }
    const auto solved = solveUnknowns(right, progress, start != nullptr ? &startInside : nullptr);
    if (!solved) {
        return solved.error();
    }
    if (!solved->allFinite()) {
        return Error{ErrorCode::NotFinite, "", "interior positions"};
    }
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(vertexCount, b.cols());
    for (std::size_t i = 0; i < interior_.size(); ++i) {
        values.row(interior_[i]) = solved->row(static_cast<Eigen::Index>(i));
    }
    return values;
}

Eigen::MatrixXd InteriorSystem::apply(const Eigen::MatrixXd& u) const {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(u.rows(), u.cols());
    for (int e = 0; e < graph_.edges.rows(); ++e) {
        const int a = graph_.edges(e, 0);
        const int b = graph_.edges(e, 1);
        const Eigen::RowVectorXd flow = graph_.weights[e] * (u.row(a) - u.row(b));
        result.row(a) += flow;
        result.row(b) -= flow;
    }
    return result;
}

Result<Points2> fillInterior(const MeshArrays& mesh, const EdgeTable& table,
                             const std::vector<int>& boundary, const Points2& outline,
                             const Progress& progress) {
    auto system = InteriorSystem::make({table.edges, cotangentWeights(mesh, table)},
                                       static_cast<int>(mesh.V.rows()), boundary, progress);
    if (!system) {
        return system.error();
    }
    auto points = system->extend(outline);
    if (!points) {
        return points.error();
    }
    return Points2(std::move(*points));
}

}  // namespace toile
