// SPDX-License-Identifier: GPL-3.0-or-later
// Darts that go on as seams, through the whole pipeline.
#include <gtest/gtest.h>

#include "core/assemble/file_space.h"
#include "core/assemble/seams_file.h"
#include "core/pattern/dart_places.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

Garment shirtCutBy(const SeamsFile& seams) {
    LoadOptions options;
    options.seams = seams;
    Progress progress;
    auto garment = loadGarment({test::dataFile("samples/tshirt.obj")}, options, progress);
    EXPECT_TRUE(garment);
    return garment ? std::move(*garment) : Garment{};
}

std::vector<int> dartsOf(const Garment& garment) {
    std::vector<int> darts;
    for (int s = 0; s < static_cast<int>(garment.seams.seams.size()); ++s) {
        if (dartPlace(garment, s)) {
            darts.push_back(s);
        }
    }
    return darts;
}

TEST(DartDivision, MakesOneSeamOfADartAndTheCutBeyondIt) {
    auto seams = readSeamsFile(test::sourceFile("resources/samples/tshirt.seams.json"));
    ASSERT_TRUE(seams);
    giveIds(seams->cuts);
    const Garment garment = shirtCutBy(*seams);
    Progress progress;
    const PieceResults results = flattenGarment(garment, {}, progress);
    const std::vector<int> darts = dartsOf(garment);
    ASSERT_EQ(darts.size(), 2U);
    for (const int dart : darts) {
        SCOPED_TRACE(garment.seams.seams[static_cast<std::size_t>(dart)].name);
        EXPECT_FALSE(cutBeyondTip(garment, dart));
        auto cut = cutBeyondDart(garment, results, dart);
        ASSERT_TRUE(cut);
        SeamsFile more = *seams;
        for (Eigen::Vector3d& point : cut->points) {
            point = inFileSpace(point, *seams, garment);
        }
        cut->name = "beyond";
        more.cuts.push_back(*cut);
        giveIds(more.cuts);
        const Garment divided = shirtCutBy(more);
        EXPECT_TRUE(divided.problems.empty());
        EXPECT_EQ(divided.pieces.size(), garment.pieces.size() + 1);
        EXPECT_EQ(dartsOf(divided).size(), 1U);
        int found = 0;
        for (int s = 0; s < static_cast<int>(divided.seams.seams.size()); ++s) {
            const auto beyond = cutBeyondTip(divided, s);
            if (beyond) {
                ++found;
                const Seam& seam = divided.seams.seams[static_cast<std::size_t>(s)];
                EXPECT_EQ(seam.kind, SeamKind::Seam);
                EXPECT_EQ(*beyond, more.cuts.back().id);
                EXPECT_NEAR(seam.length3d[0], seam.length3d[1], 1e-6);
                EXPECT_GT(seam.length3d[0],
                          garment.seams.seams[static_cast<std::size_t>(dart)].length3d[0] + 10);
            }
        }
        EXPECT_EQ(found, 1);
    }
}

TEST(DartDivision, ACutFromTheEndOfAnotherOnTheRimLeadsOnFromNoTip) {
    auto seams = readSeamsFile(test::sourceFile("resources/samples/tshirt.seams.json"));
    ASSERT_TRUE(seams);
    UserCut slit = seams->cuts.front();  // down the whole back
    slit.name = "slit";
    slit.alongEdges = false;
    slit.points.back() = {-60, 1000, -130};
    seams->cuts.push_back(slit);
    giveIds(seams->cuts);
    const Garment garment = shirtCutBy(*seams);
    EXPECT_TRUE(garment.problems.empty());
    EXPECT_EQ(garment.cuts.size(), seams->cuts.size());
    for (int s = 0; s < static_cast<int>(garment.seams.seams.size()); ++s) {
        EXPECT_FALSE(cutBeyondTip(garment, s)) << garment.seams.seams[std::size_t(s)].name;
    }
}

}  // namespace
}  // namespace toile
