// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/pattern/pattern.h"
#include "core/project/piece_settings.h"
#include "core/project/project_file.h"
#include "core/toile/garment_flattener.h"
#include "tests/core/support/project_pieces.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

Garment sheets() {
    Garment garment;
    garment.pieces = {test::asPiece(test::planeGrid(4, 4, 10), "front"),
                      test::asPiece(test::planeGrid(2, 2, 5), "button")};
    return garment;
}

std::vector<PieceSettings> secondLeftOut() {
    std::vector<PieceSettings> settings(2);
    settings[1].leftOut = true;
    return settings;
}

TEST(LeftOut, IsInNoPatternAndNoFailure) {
    const Garment garment = sheets();
    Progress progress;
    const PieceResults results =
        withoutLeftOut(flattenGarment(garment, {}, progress), garment, secondLeftOut());
    EXPECT_EQ(statusOf(*results[0]), "flat");
    EXPECT_EQ(statusOf(*results[1]), "left-out");
    EXPECT_FALSE(results[1]->flat);
    EXPECT_TRUE(isNote(results[1]->error->code));
    const Pattern pattern = makePattern(garment, results);
    EXPECT_GT(pattern.pieces[0].outline.rows(), 0);
    EXPECT_EQ(pattern.pieces[1].outline.rows(), 0);
}

TEST(LeftOut, TakenInAgainItIsAsItWas) {
    const Garment garment = sheets();
    Progress progress;
    GarmentFlattener flattener;
    const PieceResults all = flattener.flatten(garment, {}, progress);
    const PieceResults some = withoutLeftOut(all, garment, secondLeftOut());
    EXPECT_EQ(flattener.flatten(garment, {}, progress, 0, some)[1], all[1]);
    EXPECT_EQ(withoutLeftOut(some, garment, std::vector<PieceSettings>(2))[1], nullptr);
}

TEST(LeftOut, ProjectsKeepWhatIsLeftOutAndWhatIsHidden) {
    const test::TemporaryFolder folder;
    Project project;
    project.files.resize(1);
    project.files[0].path = folder.write("dress.obj", "mesh");
    test::said(project, "front").hidden = true;
    test::said(project, "button").leftOut = true;
    const auto file = folder.path() / "garment.toile";
    ASSERT_TRUE(writeProject(file, project));
    const auto read = readProject(file);
    ASSERT_TRUE(read);
    Project again = read->project;
    EXPECT_TRUE(test::said(again, "front").hidden);
    EXPECT_FALSE(test::said(again, "front").leftOut);
    EXPECT_TRUE(test::said(again, "button").leftOut);
}

TEST(LeftOut, SmallPartsAreKnownByTheirArea) {
    const Garment garment = sheets();
    EXPECT_NEAR(wornArea(*garment.pieces[0]), 1600, 1e-9);
    EXPECT_NEAR(wornArea(*garment.pieces[1]), 100, 1e-9);
}

}  // namespace
}  // namespace toile
