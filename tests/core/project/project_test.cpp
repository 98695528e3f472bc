// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"

#include <gtest/gtest.h>

#include "core/base/content_hash.h"
#include "core/io/soup.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

Garment garmentOfFile(std::optional<std::uint64_t> hash) {
    Garment garment;
    auto file = std::make_shared<SourceFile>();
    file->path = "/garments/dress.obj";
    file->soup.contentHash = hash;
    garment.files = {file};
    garment.pieces = {test::asPiece(test::planeGrid(2, 2, 10), "front"),
                      test::asPiece(test::planeGrid(2, 2, 10), "back")};
    return garment;
}

TEST(Project, SettingsFollowThePiecesNames) {
    Project project;
    project.pieces["back"].quantity = 7;
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
    EXPECT_EQ(problems[0].where, "dress.obj");
}

TEST(Project, APieceThatIsGoneIsNamed) {
    Project project;
    project.pieces["collar"];
    project.pieces["back"];
    const Problems problems = differencesTo(project, garmentOfFile({}));
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].code, ErrorCode::PieceGone);
    EXPECT_EQ(problems[0].where, "collar");
}

TEST(Project, ManyPiecesThatAreGoneAreNamedInOneSentence) {
    Project project;
    for (int k = 0; k < 1000; ++k) {
        project.pieces["sleeve " + std::to_string(k)];
    }
    const Problems problems = differencesTo(project, garmentOfFile({}));
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].where, R"("sleeve 0", "sleeve 1", "sleeve 10" and 997 more)");
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
    const auto byName = settingsByName(garment, settings, {results[0], nullptr});
    EXPECT_EQ(byName.at("front").anchors.size(), results[0]->piece->boundary.size());
    EXPECT_EQ(byName.at("back"), settings[1]);
}

}  // namespace
}  // namespace toile
