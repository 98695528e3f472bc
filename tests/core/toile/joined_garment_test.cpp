// SPDX-License-Identifier: GPL-3.0-or-later
// Seams taken out of whole garments, by the points of a seams file.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/assemble/file_space.h"
#include "core/quality/measures.h"
#include "core/seam/seam_settings.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/sewn_sample.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

double areaOf(const Garment& garment) {
    double area = 0;
    for (const auto& piece : garment.pieces) {
        area += triangleAreas3d(piece->mesh).sum();
    }
    return area;
}

/// Adds the order that takes a seam of the garment out, as the window does.
void takeOut(const Garment& garment, const Seam& seam, SeamsFile& seams) {
    UserJoin join = joinAlong(seam, garment.pieces);
    for (Eigen::Vector3d& point : join.points) {
        point = inFileSpace(point, seams, garment);
    }
    seams.joins.push_back(std::move(join));
}

class JoinedGarments : public testing::TestWithParam<const char*> {};

TEST_P(JoinedGarments, TakeOutASeamAndPutItInAgain) {
    const test::TemporaryFolder folder;
    const std::filesystem::path path =
        test::garmentWithTruth(GetParam(), folder.path()).string() + ".obj";
    TOILE_NEEDS_SHARED(path);
    Progress progress;
    LoadOptions load;
    load.split = SplitMode::Uv;
    const auto before = loadGarment({path}, load, progress);
    ASSERT_TRUE(before);
    const Seam* sewn = nullptr;  // the first between two pieces
    for (const Seam& seam : before->seams.seams) {
        if (!sewn && seam.kind == SeamKind::Seam && seam.left.piece != seam.right.piece) {
            sewn = &seam;
        }
    }
    ASSERT_TRUE(sewn);
    takeOut(*before, *sewn, load.seams);
    const auto after = cutGarment(*before, load, progress);
    ASSERT_TRUE(after);
    ASSERT_EQ(after->joins.size(), 1U) << sentence(after->problems.front());
    EXPECT_EQ(after->joins[0].name, sewn->name);
    EXPECT_NEAR(after->joins[0].length, sewn->length3d[0], 1e-6 * sewn->length3d[0]);
    EXPECT_EQ(after->pieces.size(), before->pieces.size() - 1);
    EXPECT_EQ(after->uncut, before->uncut);
    EXPECT_NEAR(areaOf(*after), areaOf(*before), 1e-6 * areaOf(*before));
    // The pieces that it does not touch are the same.
    for (std::size_t i = 0; i < before->pieces.size(); ++i) {
        const bool touched =
            static_cast<int>(i) == sewn->left.piece || static_cast<int>(i) == sewn->right.piece;
        EXPECT_EQ(std::ranges::count(after->pieces, before->pieces[i]), touched ? 0 : 1);
    }
    load.seams.joins.clear();
    const auto again = cutGarment(*after, load, progress);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->pieces, before->pieces);
}

INSTANTIATE_TEST_SUITE_P(Samples, JoinedGarments, testing::Values("samples/tshirt"));
INSTANTIATE_TEST_SUITE_P(Shared, JoinedGarments, testing::Values("tshirt"));

TEST(JoinedGarment, ComesFromASeamsFileToo) {
    const test::TemporaryFolder folder;
    const auto path = folder.write("two.obj",
                                   "o left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\n"
                                   "o right\nv 2 0 0\nv 2 1 0\nf 2 5 6 4\n");
    const auto seams = parseSeamsFile(
        R"({"version": 1, "joins": [{"name": "middle", "points": [[1, 0, 0], [1, 1, 0]]}]})", "s");
    ASSERT_TRUE(seams);
    Progress progress;
    LoadOptions load;
    load.unit = LengthUnit::Centimetre;
    load.split = SplitMode::Objects;
    ASSERT_EQ(loadGarment({path}, load, progress)->pieces.size(), 2U);
    load.seams = *seams;
    const auto garment = loadGarment({path}, load, progress);
    ASSERT_TRUE(garment);
    ASSERT_EQ(garment->pieces.size(), 1U);
    EXPECT_EQ(garment->pieces[0]->name, "left + right");
    EXPECT_NEAR(garment->joins.at(0).length, 10, 1e-9);
    EXPECT_EQ(garment->uncut.size(), 2U);
}

TEST(SeamOrigin, KnowsTheSeamThatACutLeft) {
    const test::TemporaryFolder folder;
    const auto path = folder.write("two.obj",
                                   "o left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\n"
                                   "o right\nv 2 0 0\nv 2 1 0\nf 2 5 6 4\n");
    Progress progress;
    LoadOptions load;
    load.unit = LengthUnit::Centimetre;
    load.split = SplitMode::Objects;
    load.seams.cuts = {{"across", UserCut::Kind::Path, {{0, 0.5, 0}, {1, 0.5, 0}}, false}};
    const auto garment = loadGarment({path}, load, progress);
    ASSERT_TRUE(garment);
    ASSERT_EQ(garment->cuts.size(), 1U);
    int left = 0;
    for (const Seam& seam : garment->seams.seams) {
        const bool is = seam.cuts == std::vector{garment->cuts[0].id};
        EXPECT_EQ(is, seam.name == "across") << seam.name;
        left += is ? 1 : 0;
    }
    EXPECT_EQ(left, 1);
}

}  // namespace
}  // namespace toile
