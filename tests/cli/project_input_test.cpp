// SPDX-License-Identifier: GPL-3.0-or-later
// Project files on the command line, with the built program.
#include <gtest/gtest.h>

#include "core/project/project_file.h"
#include "tests/cli/run_program.h"
#include "tests/core/support/project_pieces.h"

namespace toile {
namespace {

std::string writeSomeProject(const test::TemporaryFolder& folder) {
    Project project;
    project.files = {{folder.write("flap.obj", test::kPanel)}};
    project.loading.unit = LengthUnit::Millimetre;
    project.loading.seams.cuts = {
        {"waist", UserCut::Kind::Path, {{0, 210, 0}, {300, 210, 0}}, false}};
    EXPECT_TRUE(writeProject(folder / "flap.toile", project));
    return (folder / "flap.toile").string();
}

TEST(ProjectInput, IsReadAndCutAsItSays) {
    const test::TemporaryFolder folder;
    const std::string project = writeSomeProject(folder);
    const auto run = test::toileRun({"flatten", project, "-o", (folder / "a.svg").string()});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("flap 1"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("flap 2"), std::string::npos) << run.out;
    EXPECT_TRUE(std::filesystem::exists(folder / "a.svg"));
    EXPECT_NE(test::toileRun({"info", project}).out.find("flap 2"), std::string::npos);
}

TEST(ProjectInput, PiecesLieAndAreCutAsItSays) {
    const test::TemporaryFolder folder;
    Project project;
    project.files = {{folder.write("flap.obj", test::kPanel)}};
    project.loading.unit = LengthUnit::Millimetre;
    test::said(project, "flap").quantity = 2;
    test::said(project, "flap").mirroredPair = true;
    test::said(project, "flap").grain = 0.5;
    test::said(project, "flap").placement = Placement{{0, 0}, 0, true};
    ASSERT_TRUE(writeProject(folder / "flap.toile", project));
    const auto run = test::toileRun({"flatten", (folder / "flap.toile").string(), "-o",
                                     (folder / "a.svg").string(), "-o", (folder / "a.dxf").string(),
                                     "--report", (folder / "a.json").string()});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char* file : {"a.svg", "a.dxf"}) {
        const std::string bytes = folder.read(file);
        EXPECT_NE(bytes.find("cut 2 pairs"), std::string::npos) << file;
        EXPECT_NE(bytes.find("wrong side of the fabric up"), std::string::npos) << file;
    }
    EXPECT_NE(folder.read("a.svg").find("layer-grain"), std::string::npos);
    EXPECT_NE(folder.read("a.json").find("\"mirrored_pair\": true"), std::string::npos);
    // The mesh alone says nothing of it.
    ASSERT_EQ(test::toileRun({"flatten", (folder / "flap.obj").string(), "--unit", "mm", "-o",
                              (folder / "b.svg").string()})
                  .status,
              0);
    EXPECT_EQ(folder.read("b.svg").find("cut 2"), std::string::npos);
}

TEST(ProjectInput, WhatCannotBeDoneIsOneSentence) {
    const test::TemporaryFolder folder;
    const std::string project = writeSomeProject(folder);
    const std::string mesh = (folder / "flap.obj").string();
    for (const auto& arguments :
         std::vector<std::vector<std::string>>{{"flatten", project, mesh},
                                               {"flatten", project, "--unit", "cm"},
                                               {"flatten", project, "-o", mesh}}) {
        const auto run = test::toileRun(arguments);
        EXPECT_EQ(run.status, 2) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    }
    EXPECT_EQ(folder.read("flap.obj"), test::kPanel);
    std::filesystem::remove(mesh);
    const auto run = test::toileRun({"flatten", project});
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("flap.obj"), std::string::npos) << run.err;
    EXPECT_EQ(test::toileRun({"flatten", folder.write("b.toile", "{")}).status, 3);
}

TEST(ProjectInput, OnlyWhatIsTypedGoesBeforeWhatItSays) {
    const test::TemporaryFolder folder;
    Project project;
    project.files = {{folder.write("flap.obj", test::kPanel)}};
    project.options.method = Method::Curvature;
    ASSERT_TRUE(writeProject(folder / "flap.toile", project));
    const auto methodOf = [&](const std::vector<std::string>& typed) -> std::string {
        std::vector<std::string> arguments{"flatten", (folder / "flap.toile").string(), "--report",
                                           (folder / "r.json").string()};
        arguments.insert(arguments.end(), typed.begin(), typed.end());
        EXPECT_EQ(test::toileRun(arguments).status, 0);
        const std::string report = folder.read("r.json");
        const std::string key = "\"method\": \"";
        const auto at = report.find(key) + key.size();
        return report.substr(at, report.find('"', at) - at);
    };
    EXPECT_EQ(methodOf({}), "curvature");
    EXPECT_EQ(methodOf({"--quality", "fine"}), "curvature");
    EXPECT_EQ(methodOf({"--method", "isometric"}), "isometric");  // the default, but typed
    EXPECT_EQ(methodOf({"--method", "natural"}), "natural");
}

TEST(ProjectInput, SaysWhatIsOtherThanItWas) {
    const test::TemporaryFolder folder;
    Project project;
    project.files = {{folder.write("flap.obj", test::kPanel), 1234}};
    test::said(project, "collar") = {};
    ASSERT_TRUE(writeProject(folder / "flap.toile", project));
    for (const char* command : {"flatten", "info", "compare"}) {
        const auto run = test::toileRun({command, (folder / "flap.toile").string()});
        EXPECT_NE(run.err.find("flap.obj"), std::string::npos) << run.err;
        EXPECT_NE(run.err.find("collar"), std::string::npos) << run.err;
    }
}

TEST(ProjectInput, TheWindowRefusesTheSameOptions) {
    const test::TemporaryFolder folder;
    const std::string project = writeSomeProject(folder);
    for (const auto& typed : std::vector<std::vector<std::string>>{
             {"--unit", "cm"}, {"--method", "isometric"}, {"--split", "uv"}}) {
        std::vector<std::string> arguments{project};
        arguments.insert(arguments.end(), typed.begin(), typed.end());
        const auto run = test::toileRun(arguments);
        EXPECT_EQ(run.status, 2) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    }
}

/// A flap, a collar and a ball that cannot be flat; the project leaves the last two out.
std::string writeProjectThatLeavesOut(const test::TemporaryFolder& folder) {
    Project project;
    project.files = {
        {folder.write("three.obj", std::string(test::kPanel) +
                                       "v 500 0 0\nv 560 0 0\nv 560 30 0\no collar\nf -3 -2 -1\n" +
                                       test::kBall)}};
    project.loading.unit = LengthUnit::Millimetre;
    test::said(project, "collar").leftOut = true;
    test::said(project, "ball").leftOut = true;
    EXPECT_TRUE(writeProject(folder / "three.toile", project));
    return (folder / "three.toile").string();
}

TEST(ProjectInput, WhatItLeavesOutIsNotComparedEither) {
    const test::TemporaryFolder folder;
    const std::string project = writeProjectThatLeavesOut(folder);
    const auto run = test::toileRun({"compare", project, "--methods", "lscm", "--per-piece"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("three.obj: 1 piece, 2 triangles"), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("collar"), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("failed"), std::string::npos) << run.out;
    const auto json = test::toileRun({"compare", project, "--methods", "lscm", "--json"});
    EXPECT_NE(json.out.find("\"pieces_flat\": 1"), std::string::npos) << json.out;
    EXPECT_NE(json.out.find("\"left-out\""), std::string::npos) << json.out;
}

}  // namespace
}  // namespace toile
