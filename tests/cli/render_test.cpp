// SPDX-License-Identifier: GPL-3.0-or-later
// `toile render` as other programs meet it: the built program, run without a display.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/project/project_file.h"
#include "tests/cli/run_program.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

const std::string kCap = std::string(TOILE_SOURCE_DIR) + "/resources/samples/cap.obj";

/// @param settings  of the environment: NAME=VALUE
test::ProgramRun render(std::vector<std::string> arguments,
                        const std::vector<std::string>& settings = {}) {
    std::vector<std::string> all = settings;
    all.insert(all.end(), {TOILE_PROGRAM, "render"});
    all.insert(all.end(), arguments.begin(), arguments.end());
    return test::run("env", all);
}

#ifdef TOILE_GUI

bool isOneSentence(const std::string& said) {
    return said.starts_with("toile: ") && std::count(said.begin(), said.end(), '\n') == 1;
}

/// Width and height as the file's head has them.
std::pair<unsigned, unsigned> sizeOf(const std::string& png) {
    const auto number = [&png](std::size_t at) -> unsigned {
        unsigned value = 0;
        for (std::size_t i = at; i < at + 4; ++i) {
            value = 256 * value + static_cast<unsigned char>(png.at(i));
        }
        return value;
    };
    return {number(16), number(20)};
}

/// Draws, or skips by name where this computer has no driver that does without a display.
#define TOILE_NEEDS_DRAWING(run)                                                    \
    do {                                                                            \
        if ((run).status == 3 && (run).err.find("xvfb-run") != std::string::npos) { \
            GTEST_SKIP() << (run).err;                                              \
        }                                                                           \
    } while (false)

TEST(Render, NeedsNoDisplayOrSaysWhoLendsOne) {
    const test::TemporaryFolder folder;
    const std::string out = (folder / "out.png").string();
    for (const std::vector<std::string>& settings :
         {std::vector<std::string>{},
          {"DISPLAY=:4711"},
          {"QT_QPA_PLATFORM=xcb"},
          {"QT_QPA_PLATFORM=wayland", "WAYLAND_DISPLAY=nobody"}}) {
        fs::remove(out);
        const auto run = render({kCap, "--unit", "mm", "-o", out, "--size", "320x200"}, settings);
        EXPECT_TRUE(run.status == 0 || run.status == 3) << run.status << run.err;
        EXPECT_EQ(fs::exists(out), run.status == 0);
        EXPECT_EQ(run.out, "");
        if (run.status == 0) {
            EXPECT_EQ(run.err, "");
            EXPECT_EQ(sizeOf(folder.read("out.png")), std::pair(320U, 200U));
        } else {
            EXPECT_TRUE(isOneSentence(run.err)) << run.err;
            EXPECT_NE(run.err.find("xvfb-run"), std::string::npos) << run.err;
        }
    }
}

TEST(Render, WithoutADriverTooItSaysWhoLendsADisplay) {
    const test::TemporaryFolder folder;
    const auto run = render({kCap, "--unit", "mm", "-o", (folder / "out.png").string()},
                            {"__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere.json"});
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_TRUE(isOneSentence(run.err)) << run.err;
    EXPECT_NE(run.err.find("xvfb-run"), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(folder / "out.png"));
}

TEST(Render, TheSameInputGivesTheSameBytesWithoutATime) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a.png", "b.png"}) {
        const auto run = render({kCap, "--unit", "mm", "--overlay", "strain", "-o",
                                 (folder / name).string(), "--size", "640x360"});
        TOILE_NEEDS_DRAWING(run);
        ASSERT_EQ(run.status, 0) << run.err;
    }
    const std::string bytes = folder.read("a.png");
    EXPECT_EQ(bytes, folder.read("b.png"));
    EXPECT_EQ(bytes.find("tIME"), std::string::npos);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / ""), fs::directory_iterator()), 2)
        << "nothing is left beside the pictures";
}

TEST(Render, EveryViewAndSideIsAnotherPicture) {
    const test::TemporaryFolder folder;
    std::vector<std::string> pictures;
    for (const std::vector<std::string>& options : {std::vector<std::string>{},
                                                    {"--view", "garment"},
                                                    {"--view", "pattern"},
                                                    {"--look", "back"},
                                                    {"--look", "-30.5,20"},
                                                    {"--morph", "0.5"},
                                                    {"--wireframe"},
                                                    {"--xray"},
                                                    {"--dark"},
                                                    {"--seams-shown", "off"},
                                                    {"--bar", "on"},
                                                    {"--overlay", "none"},
                                                    {"--overlay", "area"},
                                                    {"--overlay", "area", "--bar", "off"}}) {
        std::vector<std::string> typed{
            kCap, "--unit", "mm", "--size", "400x300", "-o", (folder / "out.png").string()};
        typed.insert(typed.end(), options.begin(), options.end());
        const auto run = render(typed);
        TOILE_NEEDS_DRAWING(run);
        ASSERT_EQ(run.status, 0) << run.err;
        pictures.push_back(folder.read("out.png"));
        EXPECT_EQ(sizeOf(pictures.back()), std::pair(400U, 300U));
    }
    std::ranges::sort(pictures);
    EXPECT_EQ(std::ranges::adjacent_find(pictures), pictures.end());
}

TEST(Render, WhatIsTypedGoesBeforeWhatAProjectSays) {
    const test::TemporaryFolder folder;
    Project project;
    project.files = {FileReference{.path = kCap}};
    project.loading.unit = LengthUnit::Millimetre;
    project.view.overlay = "strain";
    ASSERT_TRUE(writeProject(folder / "cap.toile", project));
    const auto picture = [&](std::vector<std::string> typed) -> std::string {
        fs::remove(folder / "out.png");
        typed.insert(typed.end(), {"--size", "400x300", "-o", (folder / "out.png").string()});
        const auto run = render(typed);
        return run.status == 3 && run.err.find("xvfb-run") != std::string::npos
                   ? "skip"
                   : run.err + folder.read("out.png");
    };
    const std::string said = picture({(folder / "cap.toile").string()});
    if (said == "skip") {
        GTEST_SKIP() << "no driver here draws without a display";
    }
    EXPECT_EQ(said, picture({kCap, "--unit", "mm", "--overlay", "strain"}));
    const std::string typed = picture({(folder / "cap.toile").string(), "--overlay", "checker"});
    EXPECT_EQ(typed, picture({kCap, "--unit", "mm"}));
    EXPECT_NE(typed, said);
}

TEST(Render, WhatAProjectLeavesOutIsNotInThePattern) {
    const test::TemporaryFolder folder;
    Project project;
    project.files = {
        {folder.write("two.obj", std::string(test::kPanel) + "v 500 0 0\nv 900 0 0\nv 900 300 0\n"
                                                             "o collar\nf -3 -2 -1\n")}};
    project.loading.unit = LengthUnit::Millimetre;
    ProjectPiece& collar = project.pieces.emplace_back();
    collar.name = "collar";
    collar.settings.leftOut = true;
    ASSERT_TRUE(writeProject(folder / "two.toile", project));
    const auto picture = [&](std::vector<std::string> typed) -> std::string {
        typed.insert(typed.end(), {"--view", "pattern", "--size", "400x300", "-o",
                                   (folder / "out.png").string()});
        const auto run = render(typed);
        return run.status == 3 ? "" : run.err + folder.read("out.png");
    };
    const std::string both = picture({(folder / "two.obj").string(), "--unit", "mm"});
    if (both.empty()) {
        GTEST_SKIP() << "no driver here draws without a display";
    }
    const std::string one = picture({(folder / "two.toile").string()});
    EXPECT_NE(one, both);
    EXPECT_EQ(one, picture({folder.write("one.obj", test::kPanel).string(), "--unit", "mm"}));
}

TEST(Render, ThePatternThatAProjectComparesWithIsDrawnWhereItIsThere) {
    const test::TemporaryFolder folder;
    const fs::path pattern = folder / "cap.svg";
    ASSERT_EQ(
        test::run(TOILE_PROGRAM, {"flatten", kCap, "--unit", "mm", "-o", pattern.string()}).status,
        0);
    Project project;
    project.files = {FileReference{.path = kCap}};
    project.loading.unit = LengthUnit::Millimetre;
    project.view.referencePanels = true;
    const auto picture = [&](test::ProgramRun& run) -> std::string {
        fs::remove(folder / "out.png");
        EXPECT_TRUE(writeProject(folder / "cap.toile", project));
        run = render({(folder / "cap.toile").string(), "--size", "400x300", "-o",
                      (folder / "out.png").string()});
        return run.status == 0 ? folder.read("out.png") : std::string();
    };
    test::ProgramRun run;
    const std::string without = picture(run);
    TOILE_NEEDS_DRAWING(run);
    project.reference = FileReference{.path = pattern};
    EXPECT_NE(picture(run), without);
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "");
    fs::remove(pattern);
    EXPECT_EQ(picture(run), without);
    EXPECT_EQ(run.status, 0);
    EXPECT_TRUE(isOneSentence(run.err)) << run.err;
}

TEST(Render, FailuresHaveTheStatusOfTheOtherCommands) {
    const test::TemporaryFolder folder;
    const std::string out = (folder / "out.png").string();
    const auto missing = render({(folder / "missing.obj").string(), "-o", out});
    EXPECT_EQ(missing.status, 3);
    EXPECT_TRUE(isOneSentence(missing.err)) << missing.err;
    EXPECT_FALSE(fs::exists(out));
    const auto unwritable =
        render({kCap, "--unit", "mm", "-o", (folder / "no/such/out.png").string()});
    EXPECT_EQ(unwritable.status, 3);
    EXPECT_TRUE(isOneSentence(unwritable.err)) << unwritable.err;
    const auto mixed = folder.write("mixed.obj",
                                    "v 0 0 0\nv 300 0 0\nv 0 400 0\no flap\nf 1 2 3\n"
                                    "v 0 0 5\nv 1 0 5\nv 0 1 5\nv 0 0 6\n"
                                    "o ball\nf -4 -3 -2\nf -4 -1 -3\nf -3 -1 -2\nf -4 -2 -1\n");
    const auto some = render({mixed.string(), "--unit", "mm", "-o", out});
    TOILE_NEEDS_DRAWING(some);
    EXPECT_EQ(some.status, 1);
    EXPECT_NE(some.err.find("ball"), std::string::npos) << some.err;
    EXPECT_TRUE(fs::exists(out));
}

// File managers make the file, keep it open, and take a picture from it only where all is well.
TEST(Render, AThumbnailGoesIntoTheFileThereIsWhateverItsNameAndWhateverCannotLieFlat) {
    const test::TemporaryFolder folder;
    const auto ball = folder.write("ball.obj",
                                   "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 0 0 100\n"
                                   "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    fs::create_directory(folder / "alone");
    fs::permissions(folder / "alone", fs::perms::owner_all);
    const fs::path out = folder.write("alone/made-before", "empty as yet");
    fs::create_hard_link(out, folder / "kept-open");
    const auto run = render({ball.string(), "-o", out.string(), "--thumbnail", "128"},
                            {"-u", "XDG_RUNTIME_DIR", "TMPDIR=" + out.parent_path().string()});
    TOILE_NEEDS_DRAWING(run);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(sizeOf(folder.read("kept-open")), std::pair(128U, 128U));
    EXPECT_EQ(std::distance(fs::directory_iterator(out.parent_path()), {}), 1);
}

#else

TEST(Render, ABuildWithoutQtSaysThatItDrawsNothing) {
    const auto run = render({kCap, "-o", "out.png"});
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("cannot draw pictures"), std::string::npos) << run.err;
}

#endif

}  // namespace
}  // namespace toile
