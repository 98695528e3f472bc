// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"

#include <gtest/gtest.h>

#include "core/base/id.h"
#include "core/io/soup.h"
#include "tests/core/support/project_pieces.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

Garment garmentOfFile(std::optional<std::uint64_t> hash) {
    Garment garment;
    auto file = std::make_shared<SourceFile>();
    file->path = "/garments/dress.obj";
    const auto soup = std::make_shared<PolygonSoup>();
    soup->contentHash = hash;
    file->soup = soup;
    garment.files = {file};
    garment.pieces = {test::asPiece(test::planeGrid(2, 2, 10), "front"),
                      test::asPiece(test::planeGrid(2, 2, 10), "back")};
    return garment;
}

TEST(Project, SettingsFollowThePiecesNames) {
    Project project;
    test::said(project, "back").quantity = 7;
    const auto settings = settingsFor(project, garmentOfFile({}));
    ASSERT_EQ(settings.size(), 2U);
    EXPECT_EQ(settings[0], PieceSettings{});
    EXPECT_EQ(settings[1].quantity, 7);
}

TEST(Project, AFileThatIsAnotherNowIsNamed) {
    Project project;
    project.files = {{"/garments/dress.obj", 1U, {}}};
    EXPECT_TRUE(differencesTo(project, garmentOfFile(1U)).empty());
    EXPECT_TRUE(differencesTo(project, garmentOfFile({})).empty());
    const Problems problems = differencesTo(project, garmentOfFile(2U));
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].code, ErrorCode::FileChanged);
    EXPECT_EQ(problems[0].subject.name, "dress.obj");
}

TEST(Project, APieceThatIsGoneIsNamed) {
    Project project;
    (void)test::said(project, "collar");
    (void)test::said(project, "back");
    const Problems problems = differencesTo(project, garmentOfFile({}));
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].code, ErrorCode::PieceGone);
    EXPECT_EQ(problems[0].subject.name, "collar");
}

TEST(Project, ManyPiecesThatAreGoneAreNamedInOneSentence) {
    Project project;
    for (int k = 0; k < 1000; ++k) {
        (void)test::said(project, "sleeve " + std::to_string(k));
    }
    const Problems problems = differencesTo(project, garmentOfFile({}));
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].subject.name, R"("sleeve 0", "sleeve 1", "sleeve 2" and 997 more)");
}

TEST(Project, ReadersRememberTheHashOfWhatTheyRead) {
    const test::TemporaryFolder folder;
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    Progress progress;
    const auto soup = readSoup(folder.write("a.obj", text), progress);
    ASSERT_TRUE(soup);
    EXPECT_EQ(soup->contentHash, contentHash(text));
}

TEST(Project, OnlyFlatPiecesGetAnchors) {
    const Garment garment = garmentOfFile({});
    Progress progress;
    const PieceResults results = flattenGarment(garment, {}, progress);
    std::vector<PieceSettings> settings(2);
    settings[1].anchors = {{1, {2, 3}}};  // of an earlier flattening: placement is about that
    const auto pieces = projectPieces(garment, settings, {results[0], nullptr});
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0].name, "front");
    EXPECT_EQ(pieces[0].settings.anchors.size(), results[0]->piece->boundary.size());
    const Anchor& kept = pieces[1].settings.anchors.at(0);
    EXPECT_EQ(kept.vertex, 1);
    EXPECT_EQ(kept.flat, settings[1].anchors[0].flat);
    EXPECT_EQ(*kept.point, Eigen::Vector3d(garment.pieces[1]->mesh.V.row(1).transpose()));
}

}  // namespace
}  // namespace toile
