// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/io/soup.h"
#include "core/io/triangulate.h"
#include "core/mesh/edge_table.h"
#include "tests/core/cut/auto_cut_checks.h"
#include "tests/core/cut/cut_checks.h"
#include "tests/core/cut/cut_shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

void expectSharedPiecesOpen(const char* name, int components, int expectedCuts) {
    const auto path = test::sharedFile(name);
    TOILE_NEEDS_SHARED(path);
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
        const AutoCut proposal = test::expectOneDisk(piece, name);
        cuts += static_cast<int>(proposal.cuts.size());
        for (const ProposedCut& cut : proposal.cuts) {
            const Eigen::RowVector3d size =
                piece.V.colwise().maxCoeff() - piece.V.colwise().minCoeff();
            EXPECT_LT(cut.length, size.norm());  // no way around: seams of a leg, an arm, a front
        }
    }
    EXPECT_EQ(cuts, expectedCuts);
}

TEST(AutoCut, OpensTheLeggings) {
    expectSharedPiecesOpen("garments/leggings.ply", 1, 2);
}

TEST(AutoCut, OpensTheSuit) {
    expectSharedPiecesOpen("garments/suit_mh.obj", 2, 5);
}

}  // namespace
}  // namespace toile
