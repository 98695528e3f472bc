// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/seam/seam_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "core/quality/measures.h"
#include "tests/core/support/shapes.h"

namespace toile::test {

MeshArrays rectangle(double x, double y, double width, double height, int columns, int rows) {
    MeshArrays mesh = planeGrid(columns, rows, 1);
    mesh.V.col(0) = (mesh.V.col(0) * (width / columns)).array() + x;
    mesh.V.col(1) = (mesh.V.col(1) * (height / rows)).array() + y;
    return mesh;
}

MeshArrays woundAgainst(MeshArrays mesh) {
    mesh.F.col(1).swap(mesh.F.col(2));
    return mesh;
}

MeshArrays withSlit(MeshArrays mesh, int columns, int column, int steps) {
    const auto old = static_cast<int>(mesh.V.rows());
    const double x = mesh.V(column, 0);
    mesh.V.conservativeResize(old + steps, 3);
    for (int r = 0; r < steps; ++r) {
        mesh.V.row(old + r) = mesh.V.row(r * (columns + 1) + column);
    }
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        double middle = 0;
        for (int k = 0; k < 3; ++k) {
            middle += mesh.V(mesh.F(f, k), 0) / 3;
        }
        for (int k = 0; k < 3 && middle > x; ++k) {
            const int r = mesh.F(f, k) / (columns + 1);
            if (mesh.F(f, k) % (columns + 1) == column && r < steps) {
                mesh.F(f, k) = old + r;
            }
        }
    }
    return mesh;
}

Pieces welded(const Pieces& pieces) {
    std::map<std::array<double, 3>, int> positions;
    Pieces result;
    for (const auto& piece : pieces) {
        auto copy = std::make_shared<Piece>(*piece);
        for (Eigen::Index v = 0; v < copy->mesh.V.rows(); ++v) {
            const auto p = copy->mesh.V.row(v);
            const auto next = static_cast<int>(positions.size());
            copy->sourceVertex.push_back(
                positions.try_emplace({p[0], p[1], p[2]}, next).first->second);
        }
        result.push_back(std::move(copy));
    }
    return result;
}

std::vector<Seam> only(const SeamGraph& graph, SeamKind kind) {
    std::vector<Seam> found;
    std::copy_if(graph.seams.begin(), graph.seams.end(), std::back_inserter(found),
                 [kind](const Seam& seam) { return seam.kind == kind; });
    return found;
}

Seam named(const SeamGraph& graph, const std::string& name) {
    std::string all;
    for (const Seam& seam : graph.seams) {
        if (seam.name == name) {
            return seam;
        }
        all += "\n  " + seam.name;
    }
    ADD_FAILURE() << "no \"" << name << "\" among:" << all;
    return {};
}

std::vector<std::string> summary(const SeamGraph& graph, double unit, int digits) {
    std::vector<std::string> lines;
    for (const Seam& seam : graph.seams) {
        std::array<double, 2> lengths{seam.length3d[0] / unit, seam.length3d[1] / unit};
        if (seam.right.piece == seam.left.piece) {
            std::sort(lengths.begin(), lengths.end());
        }
        lines.push_back(seam.name + " " + fixed(lengths[0], digits) + " " +
                        fixed(lengths[1], digits) + (seam.stacked ? " stacked" : "") +
                        (seam.closed ? " closed" : ""));
    }
    std::sort(lines.begin(), lines.end());
    return lines;
}

void expectValid(const SeamGraph& graph, const Pieces& pieces) {
    ASSERT_EQ(graph.seamsOfEdge.size(), pieces.size());
    std::vector<double> covered(pieces.size(), 0);
    std::vector<bool> layered(pieces.size(), false);
    for (std::size_t k = 0; k < graph.seams.size(); ++k) {
        const Seam& seam = graph.seams[k];
        SCOPED_TRACE(seam.name);
        for (const SeamSide& side : {seam.left, seam.right}) {
            if (side.piece < 0) {
                EXPECT_EQ(seam.kind, SeamKind::Free);
                EXPECT_TRUE(seam.matches.empty());
                continue;
            }
            if (side.loop > 0) {  // the rim of a hole
                const auto& ofHoles = graph.seamsOfHoles[side.piece];
                EXPECT_EQ(std::count(ofHoles.begin(), ofHoles.end(), static_cast<int>(k)), 1);
                EXPECT_GT(side.length(), 0);
                continue;
            }
            const auto& edges = graph.seamsOfEdge[side.piece];
            const int n = static_cast<int>(edges.size());
            ASSERT_TRUE(side.first >= 0 && side.first < n && side.count > 0 && side.count <= n + 1);
            EXPECT_GT(side.length(), 0);
            EXPECT_GE(std::min(side.start, side.end), 0);
            for (int e = 0; e < side.count; ++e) {
                const auto& list = edges[(side.first + e) % n];
                EXPECT_TRUE(std::count(list.begin(), list.end(), static_cast<int>(k)) == 1);
            }
            covered[side.piece] += side.length();
            layered[side.piece] = layered[side.piece] || seam.stacked;
        }
        if (seam.kind == SeamKind::Free) {
            continue;
        }
        ASSERT_GE(seam.matches.size(), 2U);
        EXPECT_FALSE(seam.left.reversed);
        EXPECT_EQ(seam.matches.front().left, seam.left.start);
        EXPECT_EQ(seam.matches.back().left, seam.left.end);
        EXPECT_EQ(seam.matches.front().right, seam.right.start);
        EXPECT_EQ(seam.matches.back().right, seam.right.end);
        for (std::size_t m = 1; m < seam.matches.size(); ++m) {
            const SeamMatch &p = seam.matches[m - 1], &q = seam.matches[m];
            EXPECT_GE(q.left, p.left);
            EXPECT_GE(seam.right.reversed ? p.right - q.right : q.right - p.right, 0);
        }
    }
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const auto lengths = boundaryLengths3d(pieces[p]->mesh.V, pieces[p]->boundary);
        const double slack = lengths.size() > 0 ? lengths.maxCoeff() : 0;
        if (!layered[p]) {
            EXPECT_NEAR(covered[p], lengths.sum(), 2 * slack) << pieces[p]->name;
        }
    }
}

}  // namespace toile::test
