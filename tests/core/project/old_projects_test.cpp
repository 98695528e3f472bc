// SPDX-License-Identifier: GPL-3.0-or-later
// Projects as programs before version 2 of the format have written them.
#include <map>

#include <gtest/gtest.h>

#include "core/project/project_file.h"
#include "core/seam/seam_settings.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

struct OldProject {
    const char* file;
    std::map<std::string, int> quantities;  ///< of all its pieces
    std::map<std::string, double> ease;     ///< of all seams with one
    std::vector<std::string> unknownSeams;  ///< whose ease was lost by another cut already then
    bool isLaidOut;
};

class OldProjects : public testing::TestWithParam<OldProject> {};

/// What a project says of its pieces and seams, by their names.
void expectAll(const Project& project, const Garment& garment, const OldProject& old) {
    EXPECT_TRUE(differencesTo(project, garment).empty());
    const std::vector<PieceSettings> settings = settingsFor(project, garment);
    std::map<std::string, int> quantities;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const Piece& piece = *garment.pieces[i];
        quantities[piece.name] = settings[i].quantity;
        EXPECT_TRUE(settings[i].placement) << piece.name;
        EXPECT_EQ(settings[i].grain.has_value(), old.isLaidOut) << piece.name;
        for (const Anchor& anchor : settings[i].anchors) {
            EXPECT_LT(anchor.vertex, piece.mesh.V.rows()) << piece.name;
        }
    }
    EXPECT_EQ(quantities, old.quantities);
    std::map<std::string, double> ease = easeByName(garment.seams);
    ASSERT_EQ(ease.size(), old.ease.size());
    for (const auto& [seam, value] : old.ease) {
        EXPECT_EQ(ease[seam], value) << seam;
    }
}

TEST_P(OldProjects, OpenWithAllTheySayAndAreSavedAsNewOnes) {
    const fs::path file = test::sourceFile(std::string("tests/data/") + GetParam().file);
    auto read = readProject(file);
    ASSERT_TRUE(read) << sentence(read.error());
    EXPECT_TRUE(read->notes.empty());
    Project& project = read->project;
    ASSERT_TRUE(locateMeshes(project).empty());
    Progress progress;
    const auto garment = loadGarment({project.files[0].path}, project.loading, progress);
    ASSERT_TRUE(garment);
    expectAll(project, *garment, GetParam());
    std::vector<std::string> named;
    for (const Error& problem : garment->problems) {
        EXPECT_EQ(problem.code, ErrorCode::NoSuchSeam);
        named.push_back(problem.subject.name);
    }
    EXPECT_EQ(named, GetParam().unknownSeams);

    Project saved = project;
    saved.loading = resolveNames(project.loading, *garment);
    saved.loading.known = knownPieces(*garment);
    saved.pieces = projectPieces(*garment, settingsFor(project, *garment), {});
    EXPECT_TRUE(saved.loading.seams.ease.empty());
    const auto again =
        parseProject(projectText(saved, file.parent_path()), "new.toile", file.parent_path());
    ASSERT_TRUE(again);
    EXPECT_EQ(again->project.loading, saved.loading);
    EXPECT_EQ(again->project.pieces, saved.pieces);
    const auto reopened = loadGarment({saved.files[0].path}, again->project.loading, progress);
    ASSERT_TRUE(reopened);
    expectAll(again->project, *reopened, GetParam());
    EXPECT_EQ(settingsFor(again->project, *reopened), settingsFor(project, *garment));
}

INSTANTIATE_TEST_SUITE_P(Files, OldProjects,
                         testing::Values(OldProject{"version_1_tshirt.toile",
                                                    {{"front 1", 2},
                                                     {"front 2", 3},
                                                     {"back", 4},
                                                     {"sleeve_left", 5},
                                                     {"sleeve_right", 6},
                                                     {"neckband", 7}},
                                                    {{"waist", 0.02},
                                                     {"back / neckband, seam 1", -0.04},
                                                     {"back / sleeve_left", 0.05}},
                                                    {},
                                                    true},
                                         OldProject{"version_1_trousers.toile",
                                                    {{"front_left + front_right", 2},
                                                     {"back_left", 3},
                                                     {"back_right", 4},
                                                     {"waistband", 5}},
                                                    {{"back_left / back_right", 0.03}},
                                                    {},
                                                    true},
                                         OldProject{"version_1_cut.toile",
                                                    {{"front 1", 2},
                                                     {"front 2", 2},
                                                     {"back", 3},
                                                     {"sleeve_left", 4},
                                                     {"sleeve_right", 5},
                                                     {"neckband", 6}},
                                                    {},
                                                    {"front / sleeve_left"},
                                                    false}),
                         [](const auto& test) {
                             const std::string name = test.param.file;
                             return name.substr(10, name.find('.') - 10);
                         });

}  // namespace
}  // namespace toile
