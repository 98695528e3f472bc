// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/interior.h"

#include "core/linalg/sparse_cholesky.h"
#include "core/mesh/cotangents.h"

namespace toile {
namespace {

/// Laplacian of the interior vertices. The edge table is sorted as a symmetric matrix is, and
/// numbering the interior in vertex order keeps that, so the matrix is written in one pass.
SymmetricMatrix interiorLaplacian(const EdgeTable& table, const Eigen::VectorXd& weights,
                                  const std::vector<int>& interiorIndex, int interiorCount) {
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(interiorCount);
    std::size_t inside = 0;
    for (int e = 0; e < table.edges.rows(); ++e) {
        const int i = interiorIndex[table.edges(e, 0)];
        const int j = interiorIndex[table.edges(e, 1)];
        if (i >= 0) {
            diagonal[i] += weights[e];
        }
        if (j >= 0) {
            diagonal[j] += weights[e];
        }
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
    for (int e = 0; e < table.edges.rows(); ++e) {
        const int i = interiorIndex[table.edges(e, 0)];
        const int j = interiorIndex[table.edges(e, 1)];
        if (i >= 0 && j >= 0) {
            openColumnsUpTo(i);
            L.row.push_back(j);
            L.value.push_back(-weights[e]);
        }
    }
    openColumnsUpTo(interiorCount - 1);
    L.columnStart.push_back(static_cast<int>(L.row.size()));
    return L;
}

}  // namespace

Result<Points2> fillInterior(const MeshArrays& mesh, const EdgeTable& table,
                             const std::vector<int>& boundary, const Points2& outline,
                             const Progress& progress) {
    std::vector<int> interiorIndex(static_cast<std::size_t>(mesh.V.rows()), 0);
    Points2 Q(mesh.V.rows(), 2);
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        interiorIndex[boundary[i]] = -1;
        Q.row(boundary[i]) = outline.row(static_cast<Eigen::Index>(i));
    }
    std::vector<int> interior;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        if (interiorIndex[v] >= 0) {
            interiorIndex[v] = static_cast<int>(interior.size());
            interior.push_back(v);
        }
    }
    if (interior.empty()) {
        return Q;
    }
    const Eigen::VectorXd weights = cotangentWeights(mesh, table);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(static_cast<int>(interior.size()), 2);
    for (int e = 0; e < table.edges.rows(); ++e) {
        const int a = table.edges(e, 0);
        const int b = table.edges(e, 1);
        if (interiorIndex[a] >= 0 && interiorIndex[b] < 0) {
            right.row(interiorIndex[a]) += weights[e] * Q.row(b);
        } else if (interiorIndex[b] >= 0 && interiorIndex[a] < 0) {
            right.row(interiorIndex[b]) += weights[e] * Q.row(a);
        }
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    SparseCholesky cholesky;
    const auto factorised = cholesky.factorise(
        interiorLaplacian(table, weights, interiorIndex, static_cast<int>(interior.size())));
    if (!factorised) {
        return factorised.error();
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    const auto solved = cholesky.solve(right);
    if (!solved) {
        return solved.error();
    }
    if (!solved->allFinite()) {
        return Error{ErrorCode::NotFinite, "", "interior positions"};
    }
    for (std::size_t i = 0; i < interior.size(); ++i) {
        Q.row(interior[i]) = solved->row(static_cast<Eigen::Index>(i));
    }
    return Q;
}

}  // namespace toile
