// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/interior/interior.h"

#include <utility>

#include "core/flatten/boundary/boundary_problem.h"
#include "core/garment/piece.h"
#include "core/linalg/elimination_order.h"
#include "core/mesh/cotangents.h"

namespace toile {
namespace {

constexpr int kDissected = 200000;  ///< from here on our own elimination order pays off

/// Laplacian of the interior vertices. The edges are sorted like a symmetric matrix, and numbering
/// the interior in vertex order keeps that, so the matrix is written in one pass.
linalg::SymmetricMatrix interiorLaplacian(const WeightedEdges& graph,
                                          const std::vector<int>& interiorIndex,
                                          std::size_t interiorCount) {
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(interiorCount));
    std::size_t inside = 0;
    for (int e = 0; e < graph.edges.rows(); ++e) {
        const int i = interiorIndex[graph.edges(e, 0)];
        const int j = interiorIndex[graph.edges(e, 1)];
        for (const int unknown : {i, j}) {
            if (unknown >= 0) {
                diagonal[unknown] += graph.weights[e];
            }
        }
        inside += i >= 0 && j >= 0 ? 1 : 0;
    }
    linalg::SymmetricMatrix L;
    L.size = static_cast<int>(interiorCount);
    L.columnStart.reserve(interiorCount + 1);
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
    openColumnsUpTo(L.size - 1);
    L.columnStart.push_back(static_cast<int>(L.row.size()));
    return L;
}

}  // namespace

std::vector<int> unknownsBut(std::span<const int> held, int vertexCount) {
    std::vector<int> unknown(static_cast<std::size_t>(vertexCount), 0);
    for (const int v : held) {
        unknown[v] = -1;
    }
    int next = 0;
    for (int& u : unknown) {
        u = u < 0 ? -1 : next++;
    }
    return unknown;
}

Result<InteriorSystem> InteriorSystem::make(WeightedEdges graph, const Points3& V,
                                            const std::vector<int>& boundary,
                                            const Progress& progress) {
    const auto vertexCount = static_cast<int>(V.rows());
    InteriorSystem system;
    system.graph_ = std::move(graph);
    system.boundary_ = boundary;
    system.interiorIndex_ = unknownsBut(boundary, vertexCount);
    for (int v = 0; v < vertexCount; ++v) {
        if (system.interiorIndex_[v] >= 0) {
            system.interior_.push_back(v);
        }
    }
    if (system.interior_.empty()) {
        return system;
    }
    const auto factorised = system.factorise(V, progress);
    return factorised ? Result<InteriorSystem>(std::move(system)) : factorised.error();
}

Result<void> InteriorSystem::factorise(const Points3& V, const Progress& progress) {
    const linalg::SymmetricMatrix L = interiorLaplacian(graph_, interiorIndex_, interior_.size());
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    progress.step();
    std::vector<int> order;
    if (L.size >= kDissected) {
        order = linalg::eliminationOrder(L, V(interior_, Eigen::all));
    }
    if (const auto analysed = cholesky_.analyse(L, std::move(order)); !analysed) {
        return analysed.error();
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    progress.step();
    if (const auto factorised = cholesky_.refactorise(L); !factorised) {
        return factorised.error();
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    progress.step();
    return {};
}

Result<Points2> InteriorSystem::extend(const Points2& onBoundary) const {
    Points2 values = Points2::Zero(std::ssize(interiorIndex_), 2);
    values(boundary_, Eigen::all) = onBoundary;
    // Contribution of the boundary's values to the equations of their neighbours inside.
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(values.rows(), 2);
    for (int e = 0; e < graph_.edges.rows(); ++e) {
        const int a = graph_.edges(e, 0);
        const int b = graph_.edges(e, 1);
        if (interiorIndex_[a] >= 0 && interiorIndex_[b] < 0) {
            right.row(a) += graph_.weights[e] * values.row(b);
        } else if (interiorIndex_[b] >= 0 && interiorIndex_[a] < 0) {
            right.row(b) += graph_.weights[e] * values.row(a);
        }
    }
    const auto solved = solve(right);
    if (!solved) {
        return solved.error();
    }
    values = *solved;
    values(boundary_, Eigen::all) = onBoundary;
    return values;
}

Result<Eigen::MatrixXd> InteriorSystem::solve(const Eigen::MatrixXd& b) const {
    const auto vertexCount = static_cast<Eigen::Index>(interiorIndex_.size());
    if (interior_.empty()) {
        return Eigen::MatrixXd(Eigen::MatrixXd::Zero(vertexCount, b.cols()));
    }
    const auto solved = cholesky_.solve(b(interior_, Eigen::all));
    if (!solved) {
        return solved.error();
    }
    if (!solved->allFinite()) {
        return Error{ErrorCode::NotFinite, {}, "interior positions"};
    }
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(vertexCount, b.cols());
    values(interior_, Eigen::all) = *solved;
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

Result<Points2> fillInterior(WeightedEdges graph, const Points3& V,
                             const std::vector<int>& boundary, const Points2& outline,
                             const Progress& progress) {
    const auto system = InteriorSystem::make(std::move(graph), V, boundary, progress);
    return system ? system->extend(outline) : system.error();
}

Result<Points2> tutteOnCircle(const Piece& piece, const Progress& progress,
                              const OutlineTargets& targets) {
    return circleOutline(outlineLengths(piece, targets)).andThen([&](const Points2& outline) {
        return fillInterior({piece.table.edges, Eigen::VectorXd::Ones(piece.table.edges.rows())},
                            piece.mesh.V, piece.boundary, outline, progress);
    });
}

}  // namespace toile
