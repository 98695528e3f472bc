// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/rest_place.h"

#include <algorithm>

#include "core/linalg/sparse_cholesky.h"
#include "core/mesh/cotangents.h"

namespace toile::prove {

Result<Points2> harmonicPlaces(const FreshMesh& mesh, const Points2& given) {
    /// So that no two triangles across a rim draw an edge apart.
    constexpr double kLeastWeight = 1e-6;
    const auto known = static_cast<int>(given.rows());
    const auto count = static_cast<int>(mesh.Q.rows());
    Points2 places(count, 2);
    places.topRows(known) = given;
    if (known == count) {
        return places;
    }
    MeshArrays flat{Points3::Zero(count, 3), mesh.F};
    flat.V.leftCols<2>() = mesh.Q;
    const EdgeTable table = buildEdgeTable(mesh.F, count);
    const Eigen::VectorXd weights = cotangentWeights(flat, table);
    linalg::SymmetricBuilder builder(count - known);
    Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(count - known, 2);
    std::vector<char> isUsed(static_cast<std::size_t>(count - known), 0);
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        const int a = table.edges(e, 0) - known, b = table.edges(e, 1) - known;
        const double weight = std::max(weights[e], kLeastWeight);
        for (const auto& [here, there] : {std::pair(a, b), std::pair(b, a)}) {
            if (here >= 0) {
                isUsed[here] = 1;
                builder.add(here, here, weight);
                if (there < 0) {
                    pull.row(here) += weight * given.row(there + known);
                }
            }
        }
        if (a >= 0 && b >= 0) {
            builder.add(a, b, -weight);
        }
    }
    for (int k = 0; k < count - known; ++k) {
        if (isUsed[k] == 0) {
            builder.add(k, k, 1);
        }
    }
    linalg::SparseCholesky cholesky;
    if (const auto done = cholesky.factorise(builder.build()); !done) {
        return done.error();
    }
    const auto solved = cholesky.solve(pull);
    if (!solved) {
        return solved.error();
    }
    places.bottomRows(count - known) = *solved;
    return places;
}

}  // namespace toile::prove
