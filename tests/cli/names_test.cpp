// SPDX-License-Identifier: GPL-3.0-or-later
// What files call things comes to the terminal readable and short.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/project/project_file.h"
#include "tests/cli/run_program.h"
#include "tests/core/support/project_pieces.h"

namespace toile {
namespace {

// An escape, a NUL, a line of its own, a turn of the writing, and no end.
std::string nastyName() {
    return "x\x1B[31m" + std::string(1, '\0') + "\r\ny\u202E" + std::string(100000, 'n');
}

constexpr const char* kPanel =
    "v 0 0 0\nv 300 0 0\nv 300 400 0\nv 0 400 0\no flap\nf 1 2 3\nf 1 3 4\n";

/// Neither raw nor long, on either stream.
void expectReadable(const test::ProgramRun& run) {
    for (const std::string& text : {run.out, run.err}) {
        EXPECT_EQ(
            std::ranges::count_if(text, [](char c) { return c >= 0 && c < ' ' && c != '\n'; }), 0);
        EXPECT_EQ(text.find("\u202E"), std::string::npos);
        EXPECT_LT(text.size(), 20000U);
    }
}

TEST(Names, OfCutsSeamsAndPiecesAreShownReadableAndShort) {
    const test::TemporaryFolder folder;
    Project project;
    project.files = {{folder.write("flap.obj", kPanel)}};
    project.loading.unit = LengthUnit::Millimetre;
    SeamsFile& seams = project.loading.seams;
    seams.cuts = {
        {nastyName(), UserCut::Kind::Path, {{0, 210, 0}, {300, 210, 0}}, false},
        {nastyName() + "2", UserCut::Kind::Dart, {{9000, 9000, 0}, {9001, 9000, 0}}, false}};
    seams.ease[nastyName()] = 0.5;
    test::said(project, nastyName()).quantity = 2;
    ASSERT_TRUE(writeProject(folder / "flap.toile", project));
    const std::string asProject = (folder / "flap.toile").string();
    folder.write("flap.seams.json", writeSeamsFile(seams));
    for (const char* command : {"flatten", "info", "check", "compare"}) {
        const auto run = test::run(TOILE_PROGRAM, {command, asProject});
        EXPECT_LT(run.status, 2) << command;
        expectReadable(run);
        const auto withSeams =
            test::run(TOILE_PROGRAM, {command, (folder / "flap.obj").string(), "--unit", "mm",
                                      "--seams", (folder / "flap.seams.json").string()});
        EXPECT_LT(withSeams.status, 2) << command;
        expectReadable(withSeams);
    }
    expectReadable(test::run(TOILE_PROGRAM, {"flatten", asProject, "--ledger"}));
}

TEST(Names, InWhatIsWrongWithAFileAreShownReadableAndShort) {
    const test::TemporaryFolder folder;
    const std::string mesh = folder.write("flap.obj", kPanel).string();
    const std::string key = R"("\u001b\u0000\u202e)" + std::string(100000, 'n') + '"';
    const std::string seams =
        folder.write("s.json", R"({"version": 1, )" + key + R"(: 1, "ease": {)" + key + ": 5}}")
            .string();
    expectReadable(test::run(TOILE_PROGRAM, {"flatten", mesh, "--seams", seams}));
    const std::string wrong =
        folder.write("w.json", R"({"version": 1, "ease": {)" + key + R"(: "x"}})").string();
    const auto run = test::run(TOILE_PROGRAM, {"flatten", mesh, "--seams", wrong});
    EXPECT_EQ(run.status, 3);
    expectReadable(run);
}

}  // namespace
}  // namespace toile
