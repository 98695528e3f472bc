// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/cloth.h"

#include <cmath>

#include <Eigen/LU>

#include "core/geometry/disjoint_sets.h"

namespace toile::sew {
namespace {

/// A triangle with less height than this part of its longest edge has no area.
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
    cloth.clothVertex.assign(static_cast<std::size_t>(points), -1);
    std::vector<int> vertexOfRoot(static_cast<std::size_t>(points), -1), members;
    for (int p = 0; p < points; ++p) {
        int& vertex = vertexOfRoot[sets.root(p)];
        if (vertex < 0) {
            vertex = static_cast<int>(members.size());
            members.push_back(0);
        }
        cloth.clothVertex[p] = vertex;
        ++members[vertex];
    }
    cloth.X = Points3::Zero(static_cast<Eigen::Index>(members.size()), 3);
    for (int p = 0; p < points; ++p) {
        const int v = cloth.clothVertex[p];
        cloth.X.row(v) += cut.V.row(p) / members[v];
    }
    const Eigen::Index count = cut.F.rows();
    cloth.patternF.resize(count, 3);
    cloth.F.resize(count, 3);
    Eigen::Index kept = 0;
    for (Eigen::Index f = 0; f < count; ++f) {
        Eigen::RowVector3i corners;
        for (int k = 0; k < 3; ++k) {
            corners[k] = cloth.clothVertex[cut.F(f, k)];
        }
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0] ||
            !hasRestArea(cut.Q, cut.F, f)) {
            ++cloth.collapsed;
            continue;
        }
        cloth.patternF.row(kept) = cut.F.row(f);
        cloth.F.row(kept++) = corners;
        cloth.pieceOf.push_back(cut.pieceOf[f]);
    }
    cloth.patternF.conservativeResize(kept, 3);
    cloth.F.conservativeResize(kept, 3);
    return cloth;
}

std::vector<char> sewnVertices(const Cloth& cloth) {
    std::vector<char> seen(static_cast<std::size_t>(cloth.X.rows()), 0), sewn = seen;
    for (const int v : cloth.clothVertex) {
        sewn[v] = seen[v];
        seen[v] = 1;
    }
    return sewn;
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
