// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/seam/contacts.h"
#include "core/seam/find_seams.h"
#include "tests/core/seam/seam_shapes.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

using test::asPiece;
using test::rectangle;

/// A fan with corners at two radii in turn: all its edges crowd.
MeshArrays star(int corners, double outer, double inner) {
    MeshArrays mesh;
    mesh.V = Points3::Zero(corners + 1, 3);
    mesh.F.resize(corners, 3);
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners;
        const double radius = k % 2 == 0 ? outer : inner;
        mesh.V.row(k + 1) << radius * std::cos(angle), radius * std::sin(angle), 0;
        mesh.F.row(k) << 0, k + 1, (k + 1) % corners + 1;
    }
    return mesh;
}

seam::NearbyEdges nearbyOf(const seam::Outlines& outlines, const std::vector<double>& radius) {
    return seam::nearbyEdges(outlines, std::vector<char>(radius.size(), 0), radius);
}

std::vector<double> reachesOf(const seam::Outlines& outlines, double share) {
    std::vector<double> radius;
    for (const seam::Outline& outline : outlines.list) {
        for (const double spacing : outline.spacing) {
            radius.push_back(share * spacing);
        }
    }
    return radius;
}

double distanceBetween(const seam::Outlines& outlines, int a, int b) {
    const auto ends = [&outlines](int edge) {
        const seam::Outline& outline = outlines.of(edge);
        const int k = outlines.local(edge);
        return std::pair<Eigen::Vector3d, Eigen::Vector3d>{outline.line.point(k),
                                                           outline.line.point(k + 1)};
    };
    const auto [a0, a1] = ends(a);
    const auto [b0, b1] = ends(b);
    // In one plane edges that do not cross are nearest at an end of one of the two.
    double least = std::numeric_limits<double>::infinity();
    const auto toEdge = [](const Eigen::Vector3d& p, const Eigen::Vector3d& from,
                           const Eigen::Vector3d& to) -> double {
        const Eigen::Vector3d way = to - from;
        const double t = std::clamp(way.dot(p - from) / way.squaredNorm(), 0.0, 1.0);
        return (from + t * way - p).norm();
    };
    for (const double d :
         {toEdge(a0, b0, b1), toEdge(a1, b0, b1), toEdge(b0, a0, a1), toEdge(b1, a0, a1)}) {
        least = std::min(least, d);
    }
    return least;
}

TEST(NearbyEdges, AreAllThoseWithinReachHoweverUnevenTheSampling) {
    // Coarse beside fine, a strip across, and one that is far finer than all of them.
    const Pieces pieces{
        asPiece(rectangle(0, 0, 400, 600, 4, 6), "coarse"),
        asPiece(rectangle(401, 0, 400, 600, 20, 60), "fine"),
        asPiece(rectangle(100, 600.5, 300, 2, 30, 1), "strip"),
        asPiece(rectangle(398, 601, 3, 0.01, 100, 1), "finest"),
    };
    const seam::Outlines outlines = seam::buildOutlines(pieces);
    for (const double share : {0.01, 0.125}) {
        const auto radius = reachesOf(outlines, share);
        const seam::NearbyEdges nearby = nearbyOf(outlines, radius);
        EXPECT_TRUE(nearby.crowded.empty()) << share;
        EXPECT_TRUE(std::ranges::is_sorted(nearby.pairs));
        EXPECT_EQ(std::ranges::adjacent_find(nearby.pairs), nearby.pairs.end());
        int near = 0;
        for (int a = 0; a < outlines.edgeCount(); ++a) {
            for (int b = a + 1; b < outlines.edgeCount(); ++b) {
                if (distanceBetween(outlines, a, b) <=
                    radius[static_cast<std::size_t>(a)] + radius[static_cast<std::size_t>(b)]) {
                    ++near;
                    ASSERT_TRUE(std::ranges::binary_search(nearby.pairs, std::pair(a, b)))
                        << share << ": " << a << " and " << b;
                }
            }
        }
        EXPECT_GT(near, outlines.edgeCount());
    }
}

TEST(NearbyEdges, AreNotMoreThanAFewForEachEdgeWhereAllCrowd) {
    for (const int corners : {5000, 20000}) {
        const seam::Outlines outlines = seam::buildOutlines({asPiece(star(corners, 100, 50))});
        const seam::NearbyEdges nearby = nearbyOf(outlines, reachesOf(outlines, 0.02));
        EXPECT_LT(nearby.pairs.size(), 128U * static_cast<std::size_t>(corners));
        EXPECT_FALSE(nearby.crowded.empty());
        EXPECT_LT(nearby.crowded.size(), 16U * static_cast<std::size_t>(corners));
    }
}

TEST(NearbyEdges, AreNotMoreThanAFewForEachEdgeOfManyLayers) {
    const Pieces pieces(500, asPiece(rectangle(0, 0, 100, 100, 4, 4)));
    const seam::Outlines outlines = seam::buildOutlines(pieces);
    const seam::NearbyEdges nearby = nearbyOf(outlines, reachesOf(outlines, 0.125));
    EXPECT_LT(nearby.pairs.size(), 128U * static_cast<std::size_t>(outlines.edgeCount()));
    EXPECT_FALSE(nearby.crowded.empty());
}

TEST(NearbyEdges, ACrowdIsNotedAndTheOtherSeamsAreFound) {
    const Pieces pieces{asPiece(star(20000, 100, 50), "star"),
                        asPiece(rectangle(300, 0, 100, 200, 5, 10), "left"),
                        asPiece(rectangle(400, 0, 100, 200, 5, 10), "right")};
    const SeamGraph graph = findSeams(pieces);
    EXPECT_EQ(test::named(graph, "left / right").length3d[0], 200);
    ASSERT_FALSE(graph.notes.empty());  // others are guessed by nearness
    EXPECT_EQ(graph.notes[0].code, ErrorCode::EdgesCrowd);
    EXPECT_NE(graph.notes[0].detail.find(" edges, as at "), std::string::npos);
    EXPECT_TRUE(findSeams({pieces[1], pieces[2]}).notes.empty());
}

TEST(NearbyEdges, ManyGoresThatMeetInOnePointAreNoCrowd) {
    // A parasol of 24 gores: 48 edges end in its top.
    Pieces gores;
    for (int k = 0; k < 24; ++k) {
        MeshArrays gore = test::planeGrid(1, 20, 10);
        for (Eigen::Index v = 0; v < gore.V.rows(); ++v) {
            const double radius = gore.V(v, 1) + 1e-3;
            const double angle = 2 * std::numbers::pi * (k + gore.V(v, 0) / 10) / 24;
            gore.V.row(v) << radius * std::cos(angle), radius * std::sin(angle), -0.3 * radius;
        }
        gores.push_back(asPiece(std::move(gore), "gore " + std::to_string(k + 1)));
    }
    const SeamGraph graph = findSeams(gores);
    EXPECT_TRUE(graph.notes.empty());
    EXPECT_EQ(test::only(graph, SeamKind::Seam).size(), 24U);
}

}  // namespace
}  // namespace toile
