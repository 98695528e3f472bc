// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/cut/surface_paths.h"
#include "core/geometry/segment.h"
#include "core/io/soup.h"
#include "core/io/triangulate.h"
#include "core/mesh/edge_table.h"
#include "tests/core/cut/auto_cut_checks.h"
#include "tests/core/cut/cut_checks.h"
#include "tests/core/cut/cut_shapes.h"
#include "tests/core/support/sewn_sample.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

/// Sum of the angles by which a line turns in space.
double turningOf(const MeshArrays& mesh, const PathPolyline& path) {
    std::vector<Eigen::Vector3d> points;
    for (const SurfacePoint& point : path.points) {
        const Eigen::Vector3d at = positionOf(mesh, point);
        if (points.empty() || (at - points.back()).norm() > 1e-9 * path.length) {
            points.push_back(at);
        }
    }
    double sum = 0;
    for (std::size_t i = 2; i < points.size(); ++i) {
        sum += geometry::angleBetween(points[i - 1] - points[i - 2], points[i] - points[i - 1]);
    }
    return sum;
}

void expectPiecesOpen(const std::filesystem::path& path, int components, int expectedCuts) {
    const std::string name = path.filename().string();
    Progress progress;
    const auto soup = readSoup(path, progress);
    ASSERT_TRUE(soup);
    MeshArrays all;
    all.F = triangulate(*soup, name).F;
    all.V.resize(static_cast<int>(soup->positions.size()), 3);
    for (std::size_t v = 0; v < soup->positions.size(); ++v) {
        all.V.row(static_cast<int>(v)) = soup->positions[v];
    }
    const auto labels = faceComponents(all.F, static_cast<int>(all.V.rows()));
    EXPECT_EQ(test::componentCount(all), components);
    int cuts = 0;
    for (int part = 0; part < components; ++part) {
        const MeshArrays piece = test::without(all, [&](int f) { return labels[f] != part; });
        const EdgeTable table = buildEdgeTable(piece.F, static_cast<int>(piece.V.rows()));
        const SurfaceLinks links(piece, table);
        const AutoCut proposal = test::expectOneDisk(piece, name);
        cuts += static_cast<int>(proposal.cuts.size());
        for (const PathPolyline& cut : proposal.cuts) {
            const Eigen::RowVector3d size =
                piece.V.colwise().maxCoeff() - piece.V.colwise().minCoeff();
            const auto shortest = geodesicPath(links, cut.points.front(), cut.points.back());
            ASSERT_TRUE(shortest);
            EXPECT_LE(turningOf(piece, cut), 1.5 * turningOf(piece, *shortest));  // no saw-tooth
            EXPECT_LT(cut.length, size.norm());  // no way around: seams of a leg, an arm, a front
        }
    }
    EXPECT_EQ(cuts, expectedCuts);
}

TEST(AutoCut, OpensTheLeggings) {
    const auto path = test::sharedFile("garments/leggings.ply");
    TOILE_NEEDS_SHARED(path);
    expectPiecesOpen(path, 1, 2);
}

TEST(AutoCut, OpensTheSuit) {
    const auto path = test::sharedFile("garments/suit_mh.obj");
    TOILE_NEEDS_SHARED(path);
    expectPiecesOpen(path, 2, 5);
}

TEST(AutoCut, OpensOurOwnGarmentsSewnTogether) {
    // One cut less than there are openings.
    for (const auto& [name, cuts] : {std::pair("trousers", 2), std::pair("tshirt", 3),
                                     std::pair("skirt", 1), std::pair("bodice", 3)}) {
        SCOPED_TRACE(name);
        const test::TemporaryFolder folder;
        expectPiecesOpen(test::writeSewnSample(name, folder.path()).string() + ".obj", 1, cuts);
    }
}

}  // namespace
}  // namespace toile
