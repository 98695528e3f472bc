// SPDX-License-Identifier: GPL-3.0-or-later
// What a project keeps of proving its pattern.
#include <filesystem>
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/base/json_fields.h"
#include "core/project/project_file.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

const std::filesystem::path kProofFolder = "/garments/dress";

Project provenProject() {
    Project project;
    project.files.push_back({"/garments/meshes/dress.obj", std::nullopt, {}});
    ProofPlan& plan = project.proof;
    plan.sewn = SewnPattern::Designer;
    plan.body = "/garments/bodies/ada.obj";
    plan.bodyUnit = FileUnit::ofMillimetres(12.1866);
    plan.settings = {.edge = 7.1,
                     .pressure = -1.0 / 3,
                     .hasGravity = true,
                     .touchesItself = true,
                     .thickness = 0.7,
                     .stiffness = {34.1, std::nullopt, 18, 19e-6, 187}};
    return project;
}

ReadProject again(const Project& project) {
    auto read = parseProject(projectText(project, kProofFolder), "p.toile", kProofFolder);
    EXPECT_TRUE(read) << sentence(read.error());
    return read ? std::move(*read) : ReadProject{};
}

std::string faultOfProof(const std::function<void(JsonDocument&)>& damage) {
    auto document = *parseJson(projectText(provenProject(), kProofFolder), "p.toile",
                               ErrorCode::MalformedProject);
    damage(document["proof"]);
    const auto read = parseProject(document.dump(), "p.toile", kProofFolder);
    return read ? "" : read.error().detail;
}

TEST(ProofOfAProject, ComesBackAsItWasSaid) {
    const Project project = provenProject();
    const ReadProject read = again(project);
    EXPECT_TRUE(read.notes.empty());
    EXPECT_TRUE(read.project.proof == project.proof);
    EXPECT_EQ(projectText(read.project, kProofFolder), projectText(project, kProofFolder));
}

TEST(ProofOfAProject, OnlyWhatIsSaidIsWritten) {
    Project project = provenProject();
    project.proof = {};
    EXPECT_EQ(projectText(project, kProofFolder).find("proof"), std::string::npos);
    EXPECT_TRUE(again(project).project.proof == ProofPlan{});
    project.proof.settings.pressure = 3;
    const auto document =
        *parseJson(projectText(project, kProofFolder), "p.toile", ErrorCode::MalformedProject);
    EXPECT_EQ(document["proof"], JsonDocument({{"pressure", 3.0}}));
    project.proof.settings = {.stiffness = {.weight = 0}};
    EXPECT_TRUE(again(project).project.proof == project.proof);
    project.proof.settings = {.threads = 3};  // the machine's
    EXPECT_TRUE(again(project).project.proof == ProofPlan{});
    EXPECT_EQ(projectText(project, kProofFolder).find("threads"), std::string::npos);
}

TEST(ProofOfAProject, EachPatternThatCanBeSewnComesBack) {
    for (const auto& [sewn, word] : kSewnPatternWords) {
        Project project = provenProject();
        project.proof.sewn = sewn;
        EXPECT_TRUE(again(project).project.proof.sewn == sewn) << word;
    }
}

TEST(ProofOfAProject, AFaultNamesItsPlace) {
    const auto is = [](const char* key, const JsonDocument& value, const std::string& fault) {
        EXPECT_EQ(faultOfProof([&](JsonDocument& proof) { proof[key] = value; }), fault) << value;
    };
    EXPECT_EQ(faultOfProof([](JsonDocument&) {}), "");
    is("sewn", "both", R"("proof.sewn" must be "own", "designer" or "reference")");
    is("sewn", 1, R"("proof.sewn" must be "own", "designer" or "reference")");
    is("edge", 0, R"("proof.edge" must be a number from 1 to 500)");
    is("edge", 1e300, R"("proof.edge" must be a number from 1 to 500)");
    is("pressure", -2e5, R"("proof.pressure" must be a number from -1e+05 to 1e+05)");
    is("pressure", nullptr, R"("proof.pressure" must be a number)");
    is("gravity", 1, R"("proof.gravity" must be true or false)");
    is("selfContact", "yes", R"("proof.selfContact" must be true or false)");
    is("thickness", 0, R"("proof.thickness" must be a number from 0.1 to 10)");
    is("stiffness", JsonDocument::array(), R"("proof.stiffness" must be an object)");
    is("stiffness", {{"warp", 0}}, R"("proof.stiffness.warp" must be a number from 1 to 1e+07)");
    is("stiffness", {{"bending", -1e-9}},
       R"("proof.stiffness.bending" must be a number from 0 to 10)");
    is("body", "ada.obj", R"("proof.body" must be an object)");
    is("body", JsonDocument::object(), R"("proof.body.path" is missing)");
    is("body", {{"path", std::string("a\0.obj", 6)}}, R"("proof.body.path" must be a path)");
    EXPECT_NE(faultOfProof([](JsonDocument& proof) {
                  proof["bodyUnit"] = "ell";
              }).find(R"("proof.bodyUnit")"),
              std::string::npos);
    EXPECT_EQ(faultOfProof([](JsonDocument& proof) { proof = 7; }), R"("proof" must be an object)");
}

TEST(ProofOfAProject, AKeyOfTomorrowIsNamed) {
    auto document = *parseJson(projectText(provenProject(), kProofFolder), "p.toile",
                               ErrorCode::MalformedProject);
    document["proof"]["friction"] = 0.4;
    const auto read = parseProject(document.dump(), "p.toile", kProofFolder);
    ASSERT_TRUE(read) << sentence(read.error());
    ASSERT_EQ(read->notes.size(), 1U);
    EXPECT_NE(sentence(read->notes.front()).find("proof.friction"), std::string::npos);
    EXPECT_TRUE(read->project.proof == provenProject().proof);
}

TEST(ProofOfAProject, TheBodyLiesWhereTheProjectDoes) {
    const auto document = *parseJson(projectText(provenProject(), kProofFolder), "p.toile",
                                     ErrorCode::MalformedProject);
    EXPECT_EQ(document["proof"]["body"]["path"], "../bodies/ada.obj");
    EXPECT_EQ(document["proof"]["body"]["absolute"], "/garments/bodies/ada.obj");
    const auto moved =
        parseProject(projectText(provenProject(), kProofFolder), "p.toile", "/elsewhere/dress");
    ASSERT_TRUE(moved) << sentence(moved.error());
    EXPECT_EQ(moved->project.proof.body, "/elsewhere/bodies/ada.obj");
    EXPECT_EQ(moved->project.bodyElsewhere, "/garments/bodies/ada.obj");
}

TEST(ProofOfAProject, ABodyThatWasLeftBehindIsFound) {
    const test::TemporaryFolder folder;
    const auto body = folder.write("ada.obj", "v 0 0 0\n");
    Project project = provenProject();
    project.proof.body = folder / "moved" / "ada.obj";
    project.bodyElsewhere = body;
    locateMeshes(project);
    EXPECT_EQ(project.proof.body, body);
    project.proof.body = folder / "nowhere.obj";  // it stays asked for
    project.bodyElsewhere.clear();
    locateMeshes(project);
    EXPECT_EQ(project.proof.body, folder / "nowhere.obj");
}

}  // namespace
}  // namespace toile
