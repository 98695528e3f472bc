// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as other programs meet it: the built program, run without a display.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

const std::string kSample = std::string(TOILE_SOURCE_DIR) + "/resources/samples/tshirt.obj";

constexpr const char* kTriangle = "v 0 0 0\nv 300 0 0\nv 0 400 0\no flap\nf 1 2 3\n";
constexpr const char* kBall =
    "v 0 0 5\nv 1 0 5\nv 0 1 5\nv 0 0 6\n"
    "o ball\nf -4 -3 -2\nf -4 -1 -3\nf -3 -1 -2\nf -4 -2 -1\n";

test::ProgramRun toileRun(const std::vector<std::string>& arguments) {
    return test::run(TOILE_PROGRAM, arguments);
}

TEST(Contract, HelpAndVersionNeedNoDisplay) {
    EXPECT_EQ(toileRun({"--help"}).status, 0);
    const auto version = toileRun({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_EQ(version.out, "toile " TOILE_VERSION "\n");
}

TEST(Contract, FlattenWritesEveryFormatAndPrintsATable) {
    const test::TemporaryFolder folder;
    const auto run =
        toileRun({"flatten", kSample, "--unit", "mm", "-o", (folder / "a.svg").string(), "-o",
                  (folder / "a.dxf").string(), "-o", (folder / "a.obj").string(), "--report",
                  (folder / "a.json").string()});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    for (const char* piece : {"front", "back", "sleeve_left", "sleeve_right", "neckband"}) {
        EXPECT_NE(run.out.find(piece), std::string::npos);
    }
    for (const char* file : {"a.svg", "a.dxf", "a.obj", "a.json"}) {
        EXPECT_GT(folder.read(file).size(), 1000U) << file;
    }
}

TEST(Contract, TheReportHasEveryPromisedField) {
    const test::TemporaryFolder folder;
    toileRun({"flatten", kSample, "--unit", "mm", "--report", (folder / "a.json").string()});
    const auto report = nlohmann::json::parse(folder.read("a.json"));
    EXPECT_TRUE(report.contains("version"));
    ASSERT_EQ(report["files"].size(), 1U);
    EXPECT_EQ(report["files"][0]["unit"], "mm");
    EXPECT_TRUE(report["files"][0]["problems"].is_array());
    ASSERT_GE(report["pieces"].size(), 5U);
    for (const auto& piece : report["pieces"]) {
        for (const char* field :
             {"name", "area_3d", "area_2d", "perimeter_3d", "perimeter_2d", "pi_theta", "pi_l",
              "pi_e", "pi_a", "max_boundary_length_error", "symmetric_dirichlet",
              "quasi_conformal_mean", "quasi_conformal_max", "strain_min", "strain_max",
              "strain_mean_abs", "flipped_triangles", "outline_crossings", "boundary_iterations"}) {
            EXPECT_TRUE(piece.contains(field)) << field;
        }
        for (const char* part : {"read", "boundary", "interior", "total"}) {
            EXPECT_TRUE(piece["seconds"].contains(part)) << part;
        }
    }
}

TEST(Contract, AFailedPieceIsStatusOneAndTheRestIsWritten) {
    const test::TemporaryFolder folder;
    const auto input = folder.write("mixed.obj", std::string(kTriangle) + kBall);
    const auto run =
        toileRun({"flatten", input.string(), "--unit", "mm", "-o", (folder / "out.svg").string()});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("ball"), std::string::npos) << run.err;
    EXPECT_NE(folder.read("out.svg").find("piece-flap-cut"), std::string::npos);
}

TEST(Contract, WrongUsageIsStatusTwoAndWritesNothing) {
    const test::TemporaryFolder folder;
    const auto run = toileRun({"flatten", kSample, "-o", (folder / "out.pdf").string()});
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_TRUE(run.out.empty());
}

TEST(Contract, UnreadableInputIsStatusThreeInOneSentence) {
    const test::TemporaryFolder folder;
    for (const auto& input : {folder / "missing.obj", folder.write("empty.obj", ""),
                              folder.write("thing.xyz", "x"), folder / ""}) {
        const auto run = toileRun({"flatten", input.string()});
        EXPECT_EQ(run.status, 3) << input;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    }
}

TEST(Contract, NeverWritesOverAnInput) {
    const test::TemporaryFolder folder;
    const auto input = folder.write("flap.obj", kTriangle);
    const auto run = toileRun({"flatten", input.string(), "-o", (folder / "./flap.obj").string()});
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(folder.read("flap.obj"), kTriangle);
}

TEST(Contract, TheNumberOfThreadsLeavesNoTrace) {
    const auto input = test::sharedFile("disks/maxface.obj");
    TOILE_NEEDS_SHARED(input);
    const test::TemporaryFolder folder;
    for (const char* threads : {"1", "2"}) {
        const auto run = test::run("env", {std::string("OPENBLAS_NUM_THREADS=") + threads,
                                           std::string("OMP_NUM_THREADS=") + threads, TOILE_PROGRAM,
                                           "flatten", input.string(), "--unit", "mm", "-o",
                                           (folder / (std::string(threads) + ".obj")).string()});
        ASSERT_EQ(run.status, 0) << run.err;
    }
    EXPECT_EQ(folder.read("1.obj"), folder.read("2.obj"));
}

TEST(Contract, StrictRefusesWhatIsMendedOtherwise) {
    const test::TemporaryFolder folder;
    const auto input = folder.write("yoke.obj",
                                    "v 0 0 0\nv 900 0 0\nv 0 900 0\nv 900 900 0\n"
                                    "f 1 2 3\nf 2 3 4\n");
    const auto mended = toileRun({"flatten", input.string(), "--unit", "mm"});
    EXPECT_EQ(mended.status, 0);
    EXPECT_NE(mended.err.find("turned"), std::string::npos) << mended.err;
    const auto refused = toileRun({"flatten", input.string(), "--unit", "mm", "--strict"});
    EXPECT_EQ(refused.status, 1) << refused.err;  // the piece stays as it is and is named
    EXPECT_FALSE(refused.err.empty());
}

TEST(Contract, SeveralInputsArePrefixed) {
    const test::TemporaryFolder folder;
    const auto run = toileRun({"flatten", folder.write("left.obj", kTriangle).string(),
                               folder.write("right.obj", kTriangle).string(), "--unit", "mm"});
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.out.find("left/flap"), std::string::npos);
    EXPECT_NE(run.out.find("right/flap"), std::string::npos);
}

TEST(Contract, InfoTellsWhatAFileHolds) {
    const auto run = toileRun({"info", kSample});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("unit mm"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("disk"), std::string::npos);
}

/// Every nasty file ends with an orderly status and no NaN in what is written.
TEST(Contract, NastyInputNeverCrashes) {
    const auto nasty = test::sharedFile("nasty");
    TOILE_NEEDS_SHARED(nasty);
    const test::TemporaryFolder folder;
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(nasty)) {
        SCOPED_TRACE(entry.path().filename());
        const auto run = toileRun(
            {"flatten", entry.path().string(), "--unit", "mm", "-o", (folder / "out.obj").string(),
             "-o", (folder / "out.svg").string(), "--report", (folder / "out.json").string()});
        EXPECT_TRUE(run.status == 0 || run.status == 1 || run.status == 3) << run.status << run.err;
        EXPECT_TRUE(run.status == 0 || !run.err.empty());
        if (run.status != 3) {
            for (const char* out : {"out.obj", "out.svg", "out.json"}) {
                const std::string text = folder.read(out);
                EXPECT_FALSE(text.empty()) << out;
                EXPECT_EQ(text.find(" nan"), std::string::npos) << out;
                EXPECT_EQ(text.find(": NaN"), std::string::npos) << out;
            }
        }
        ++files;
    }
    EXPECT_GE(files, 25);
}

}  // namespace
}  // namespace toile
