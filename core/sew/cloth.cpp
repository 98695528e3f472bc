// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/cloth.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/geometry/disjoint_sets.h"

namespace toile::sew {
namespace {

/// A triangle whose height is below this fraction of its longest edge has no area.
constexpr double kNoHeight = 1e-9;

Eigen::Matrix2d restEdges(const Points2& Q, const Triangles& F, Eigen::Index f) {
    Eigen::Matrix2d edges;
    edges.col(0) = (Q.row(F(f, 1)) - Q.row(F(f, 0))).transpose();
    edges.col(1) = (Q.row(F(f, 2)) - Q.row(F(f, 0))).transpose();
    return edges;
}

bool hasRestArea(const Points2& Q, const Triangles& F, Eigen::Index f) {
    const Eigen::Matrix2d edges = restEdges(Q, F, f);
    return std::abs(edges.determinant()) > kNoHeight * edges.squaredNorm();
}

}  // namespace

Cloth sewTogether(const CutCloth& cut) {
    const int points = static_cast<int>(cut.Q.rows());
    geometry::DisjointSets sets(points);
    for (const auto& [a, b] : cut.sewn) {
        sets.join(a, b);
    }
    Cloth cloth;
    cloth.Q = cut.Q;
    const Eigen::Index count = cut.F.rows();
    cloth.patternF.resize(count, 3);
    cloth.F.resize(count, 3);
    Eigen::Index kept = 0;
    std::vector<char> isUsed(static_cast<std::size_t>(points), 0);  // of roots
    for (Eigen::Index f = 0; f < count; ++f) {
        const Eigen::RowVector3i roots(sets.root(cut.F(f, 0)), sets.root(cut.F(f, 1)),
                                       sets.root(cut.F(f, 2)));
        if (roots[0] == roots[1] || roots[1] == roots[2] || roots[2] == roots[0] ||
            !hasRestArea(cut.Q, cut.F, f)) {
            ++cloth.collapsed;
            continue;
        }
        cloth.patternF.row(kept) = cut.F.row(f);
        cloth.F.row(kept++) = roots;
        cloth.pieceOf.push_back(cut.pieceOf[f]);
        isUsed[roots[0]] = isUsed[roots[1]] = isUsed[roots[2]] = 1;
    }
    cloth.patternF.conservativeResize(kept, 3);
    cloth.F.conservativeResize(kept, 3);
    cloth.clothVertex.assign(static_cast<std::size_t>(points), -1);
    std::vector<int> members;
    for (int p = 0; p < points; ++p) {
        const int root = sets.root(p);  // the smallest of its set
        if (isUsed[root] && root == p) {
            cloth.clothVertex[p] = static_cast<int>(members.size());
            members.push_back(0);
        } else if (isUsed[root]) {
            cloth.clothVertex[p] = cloth.clothVertex[root];
        }
        if (isUsed[root]) {
            ++members[cloth.clothVertex[p]];
        }
    }
    cloth.X = Points3::Zero(static_cast<Eigen::Index>(members.size()), 3);
    for (int p = 0; p < points; ++p) {
        if (const int v = cloth.clothVertex[p]; v >= 0) {
            cloth.X.row(v) += cut.V.row(p) / members[v];
        }
    }
    for (int& corner : cloth.F.reshaped()) {
        corner = cloth.clothVertex[corner];
    }
    return cloth;
}

std::vector<char> sewnVertices(const Cloth& cloth) {
    std::vector<char> seen(static_cast<std::size_t>(cloth.X.rows()), 0), sewn = seen;
    for (const int v : cloth.clothVertex) {
        if (v >= 0) {
            sewn[v] = seen[v];
            seen[v] = 1;
        }
    }
    return sewn;
}

std::size_t pieceCount(const Cloth& cloth) {
    const auto last = std::ranges::max_element(cloth.pieceOf);
    return last == cloth.pieceOf.end() ? 0 : static_cast<std::size_t>(*last) + 1;
}

Eigen::VectorXd restAreas(const Cloth& cloth) {
    Eigen::VectorXd areas(cloth.F.rows());
    for (Eigen::Index f = 0; f < cloth.F.rows(); ++f) {
        areas[f] = std::abs(restEdges(cloth.Q, cloth.patternF, f).determinant()) / 2;
    }
    return areas;
}

Eigen::VectorXd vertexAreas(const Cloth& cloth) {
    const Eigen::VectorXd areas = restAreas(cloth);
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(cloth.X.rows());
    for (Eigen::Index f = 0; f < cloth.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            sums[cloth.F(f, k)] += areas[f] / 3;
        }
    }
    return sums;
}

std::vector<RestShape> restShapes(const Cloth& cloth) {
    std::vector<RestShape> shapes;
    shapes.reserve(static_cast<std::size_t>(cloth.F.rows()));
    for (Eigen::Index f = 0; f < cloth.F.rows(); ++f) {
        const Eigen::Matrix2d edges = restEdges(cloth.Q, cloth.patternF, f);
        const Eigen::Matrix2d inverse = edges.inverse();
        RestShape& shape = shapes.emplace_back();
        shape.area = std::abs(edges.determinant()) / 2;
        shape.b[1] = inverse.row(0).transpose();
        shape.b[2] = inverse.row(1).transpose();
        shape.b[0] = -shape.b[1] - shape.b[2];
    }
    return shapes;
}

}  // namespace toile::sew
