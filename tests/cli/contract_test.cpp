// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as other programs meet it: the built program, run without a display.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "core/base/sanitized.h"
#include "tests/cli/run_program.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

const std::string kShirt = std::string(TOILE_SOURCE_DIR) + "/resources/samples/tshirt.obj";

TEST(Contract, HelpAndVersionNeedNoDisplay) {
    EXPECT_EQ(test::toileRun({"--help"}).status, 0);
    const auto version = test::toileRun({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_EQ(version.out, "toile " TOILE_VERSION "\n");
}

TEST(Contract, OutputThatCannotBeWrittenIsStatus3) {
    for (const char* words : {"--help", "--version", "info --help"}) {
        const auto full =
            test::run("sh", {"-c", std::string(TOILE_PROGRAM) + ' ' + words + " >/dev/full"});
        EXPECT_EQ(full.status, 3) << words;
        EXPECT_TRUE(full.err.starts_with("toile: standard output cannot be written")) << full.err;
    }
}

TEST(Contract, AGarmentBeyondAllSizesIsToldApartFromABug) {
    const test::TemporaryFolder folder;
    folder.write("huge.obj", "v 0 0 0\nv 1e30 0 0\nv 0 1e30 0\nf 1 2 3\n");
    for (const char* ending : {"svg", "dxf", "pdf", "plt"}) {
        const auto run =
            test::toileRun({"flatten", (folder / "huge.obj").string(), "--unit", "mm", "-o",
                            (folder / (std::string("huge.") + ending)).string()});
        EXPECT_EQ(run.status, 3) << ending;
        EXPECT_EQ(run.err.find("report this"), std::string::npos) << run.err;
        EXPECT_NE(run.err.find("check the garment's unit"), std::string::npos) << run.err;
    }
}

TEST(Contract, DecimalCommasAreNamedWhereNoFaceIsLeft) {
    const test::TemporaryFolder folder;
    folder.write("commas.obj", "v 0,5 0 0\nv 100,5 0 0\nv 0 100,5 0\nf 1 2 3\n");
    const auto run = test::toileRun({"info", (folder / "commas.obj").string()});
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("decimal commas"), std::string::npos) << run.err;
}

TEST(Contract, FlattenWritesEveryFormatAndPrintsATable) {
    const test::TemporaryFolder folder;
    const auto run =
        test::toileRun({"flatten", kShirt, "--unit", "mm", "-o", (folder / "a.svg").string(), "-o",
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

/// A strip that winds up twice round an axis: flat it lies on itself.
std::string windingStrip() {
    std::string text = "o strip\n";
    constexpr int kSteps = 72;
    for (int k = 0; k <= kSteps; ++k) {
        const double angle = 4 * std::numbers::pi * k / kSteps;
        for (const double radius : {50.0, 60.0}) {
            text += "v " + std::to_string(radius * std::cos(angle)) + ' ' +
                    std::to_string(0.1 * k) + ' ' + std::to_string(radius * std::sin(angle)) + '\n';
        }
    }
    for (int k = 1; k <= 2 * kSteps; k += 2) {
        const auto face = [&text](int a, int b, int c) {
            text +=
                "f " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
        };
        face(k, k + 2, k + 1);
        face(k + 1, k + 2, k + 3);
    }
    return text;
}

TEST(Contract, AnOutlineThatCrossesIsStatus1UntilItIsCut) {
    const test::TemporaryFolder folder;
    const std::string strip = folder.write("strip.obj", windingStrip()).string();
    const auto run = test::toileRun({"flatten", strip, "--unit", "mm"});
    EXPECT_EQ(run.status, 1) << run.out << run.err;
    EXPECT_NE(run.err.find("the flat outline crosses itself"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("; cut it from ("), std::string::npos) << run.err;
    EXPECT_EQ(test::toileRun({"flatten", strip, "--unit", "mm", "--fair"}).status, 1);

    const auto cut = test::toileRun({"flatten", strip, "--unit", "mm", "--auto-cut"});
    EXPECT_EQ(cut.status, 0) << cut.out << cut.err;
    EXPECT_EQ(cut.err.find("crosses itself"), std::string::npos) << cut.err;
}

TEST(Contract, CutsAreMadeListedAndPrinted) {
    const test::TemporaryFolder folder;
    const std::string seams =
        std::string(TOILE_SOURCE_DIR) + "/resources/samples/tshirt.seams.json";
    const auto run = test::toileRun({"flatten", kShirt, "--unit", "mm", "--seams", seams,
                                     "--ledger", "--report", (folder / "a.json").string()});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char* said :
         {"centre back", "waist dart left", "user", "back 1", "back 2", "largest error 0.00 mm"}) {
        EXPECT_NE(run.out.find(said), std::string::npos) << said << '\n' << run.out;
    }
    const auto report = nlohmann::json::parse(folder.read("a.json"));
    EXPECT_EQ(report["cuts"].size(), 3U);
    EXPECT_EQ(report["pieces"].size(), 6U);
    for (const auto& seam : report["seams"]) {
        if (seam["kind"] != "free") {
            EXPECT_LE(std::abs(seam["error_mm"].get<double>()), 1e-6) << seam["name"];
        }
    }
}

TEST(Contract, ATubeIsOpenedOnlyWhenAsked) {
    const test::TemporaryFolder folder;
    std::string tube;
    for (int k = 0; k < 16; ++k) {
        tube += "v " + std::to_string(k % 4 == 1 || k % 4 == 2 ? 300 : 0) + " " +
                std::to_string(k / 4 * 300) + " " + std::to_string(k % 4 > 1 ? 300 : 0) + "\n";
    }
    for (int k = 0; k < 12; ++k) {
        const int right = k % 4 == 3 ? k - 3 : k + 1;
        for (const int corner : {k, right, right + 4, k + 4}) {
            tube += (corner == k ? "f " : " ") + std::to_string(corner + 1);
        }
        tube += "\n";
    }
    const std::string file = folder.write("tube.obj", tube).string();
    const auto plain = test::toileRun({"flatten", file});
    EXPECT_EQ(plain.status, 1);
    EXPECT_NE(plain.err.find("several boundary loops"), std::string::npos) << plain.err;
    const auto cut = test::toileRun({"flatten", file, "--auto-cut", "--cut-style", "topology"});
    EXPECT_EQ(cut.status, 0) << cut.err;
    EXPECT_NE(cut.out.find("automatic cut 1"), std::string::npos) << cut.out;
    const auto info =
        test::toileRun({"info", file, "--auto-cut", "--cut-style", "topology", "--json"});
    EXPECT_EQ(nlohmann::json::parse(info.out)["cuts"].size(), 1U);
    // As tailors cut it is a skirt, which has two sides.
    const auto skirt = test::toileRun({"info", file, "--auto-cut", "--json"});
    EXPECT_EQ(nlohmann::json::parse(skirt.out)["cuts"].size(), 2U) << skirt.err;
}

TEST(Contract, ABadSeamsFileIsRefusedAndABadCutIsNot) {
    const test::TemporaryFolder folder;
    const std::string file = folder.write("a.obj", test::kTriangle).string();
    const auto bad = test::toileRun(
        {"info", file, "--seams", folder.write("b.json", "{\"version\": 7}").string()});
    EXPECT_EQ(bad.status, 3);
    EXPECT_EQ(std::count(bad.err.begin(), bad.err.end(), '\n'), 1) << bad.err;
    const auto kept = folder.write("kept.json", R"({"version": 1})");
    const auto over =
        test::toileRun({"flatten", file, "--seams", kept.string(), "-o", kept.string()});
    EXPECT_EQ(over.status, 2) << over.err;
    EXPECT_EQ(folder.read("kept.json"), R"({"version": 1})");
    const auto far = folder.write(
        "c.json",
        R"({"version": 1, "cuts": [{"name": "x", "points": [[9000, 0, 0], [9000, 1, 0]]}]})");
    const auto run = test::toileRun({"flatten", file, "--seams", far.string()});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("x: the cut cannot be made"), std::string::npos) << run.err;
    EXPECT_NE(run.out.find("flap"), std::string::npos);
}

TEST(Contract, TheReportHasEveryPromisedField) {
    const test::TemporaryFolder folder;
    test::toileRun({"flatten", kShirt, "--unit", "mm", "--report", (folder / "a.json").string()});
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
    const auto input = folder.write("mixed.obj", std::string(test::kTriangle) + test::kBall);
    const auto run = test::toileRun(
        {"flatten", input.string(), "--unit", "mm", "-o", (folder / "out.svg").string()});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("ball"), std::string::npos) << run.err;
    EXPECT_NE(folder.read("out.svg").find("piece-flap-cut"), std::string::npos);
}

// A closed finger so deep that no start without flips is to be had, and isometric promises none.
TEST(Contract, ABrokenPromiseIsStatusOneAndNoPlainFlat) {
    const test::TemporaryFolder folder;
    constexpr int kAround = 12, kAlong = 200;
    std::string finger = "o finger\n", faces;
    for (int k = 0; k < kAround * kAlong; ++k) {
        const double turn = 2 * std::numbers::pi * (k % kAround) / kAround;
        finger += "v " + std::to_string(10 * std::cos(turn)) + " " +
                  std::to_string(10 * std::sin(turn)) + " " + std::to_string(5 * (k / kAround)) +
                  "\n";
        const int next = k % kAround + 1 < kAround ? k + 1 : k + 1 - kAround;
        const bool isLast = k / kAround + 1 == kAlong;
        faces +=
            "f " + std::to_string(k + 1) + " " + std::to_string(next + 1) + " " +
            (isLast ? std::to_string(kAround * kAlong + 1)
                    : std::to_string(next + 1 + kAround) + " " + std::to_string(k + 1 + kAround)) +
            "\n";
    }
    finger += "v 0 0 " + std::to_string(5 * kAlong) + "\n" + faces;
    const std::string input = folder.write("finger.obj", finger).string();
    const auto run = test::toileRun(
        {"flatten", input, "--unit", "mm", "--report", (folder / "out.json").string()});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("triangles are flipped"), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("can be used as it is"), std::string::npos) << run.err;
    const auto report = nlohmann::json::parse(folder.read("out.json"));
    EXPECT_EQ(report["pieces"][0]["status"], "flipped");
    EXPECT_EQ(report["pieces"][0]["notes"][0]["code"], "triangles-flipped");
    const auto compared =
        test::toileRun({"compare", input, "--unit", "mm", "--methods", "isometric,curvature"});
    EXPECT_EQ(compared.status, 1);
    EXPECT_NE(compared.err.find("isometric: finger: triangles are"), std::string::npos)
        << compared.err;
    const auto other = test::toileRun({"flatten", input, "--unit", "mm", "--method", "curvature"});
    EXPECT_EQ(other.status, 1);
    EXPECT_NE(other.err.find("triangles are flipped"), std::string::npos) << other.err;
}

TEST(Contract, WrongUsageIsStatusTwoAndWritesNothing) {
    const test::TemporaryFolder folder;
    const auto run = test::toileRun({"flatten", kShirt, "-o", (folder / "out.tiff").string()});
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_TRUE(run.out.empty());
}

TEST(Contract, UnreadableInputIsStatusThreeInOneSentence) {
    const test::TemporaryFolder folder;
    for (const auto& input : {folder / "missing.obj", folder.write("empty.obj", ""),
                              folder.write("thing.xyz", "x"), folder / ""}) {
        const auto run = test::toileRun({"flatten", input.string()});
        EXPECT_EQ(run.status, 3) << input;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    }
}

TEST(Contract, NoCommandWaitsForAPipe) {
    const test::TemporaryFolder folder;
    const auto pipe = [&folder](const char* name) {
        const std::string path = (folder / name).string();
        EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
        return path;
    };
    const std::string mesh = pipe("pipe.obj"), dxf = pipe("pipe.dxf"), project = pipe("pipe.toile"),
                      seams = pipe("pipe.json"), list = pipe("pipe.txt"), gltf = pipe("pipe.gltf");
    const std::string panel = folder.write("panel.obj", test::kPanel).string();
    const std::vector<std::vector<std::string>> commands{
        {"info", mesh},
        {"info", dxf},
        {"info", project},
        {"info", gltf},
        {"info", panel, "--unit", "mm", "--seams", seams},
        {"flatten", mesh, "-o", (folder / "a.svg").string()},
        {"check", mesh},
        {"compare", mesh},
        {"compare", panel, "--unit", "mm", "--pattern", dxf},
        {"walk", mesh},
        {"marker", mesh},
        {"marker", panel, "--unit", "mm", "--hide", dxf},
        {"prove", mesh},
        {"prove", panel, "--unit", "mm", "--body", mesh},
        {"prove", panel, "--unit", "mm", "--pattern", dxf},
        {"batch", list, "-o", (folder / "out").string()}};
    for (const std::vector<std::string>& command : commands) {
        const auto run = test::toileRun(command);
        EXPECT_EQ(run.status, 3) << command[0] << ' ' << command[1] << run.err;
        EXPECT_NE(run.err.find("it is a pipe or a device"), std::string::npos)
            << command[0] << ' ' << command[1] << run.err;
    }
}

TEST(Contract, NeverWritesOverAnInput) {
    const test::TemporaryFolder folder;
    const auto input = folder.write("flap.obj", test::kTriangle);
    const auto run =
        test::toileRun({"flatten", input.string(), "-o", (folder / "./flap.obj").string()});
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(folder.read("flap.obj"), test::kTriangle);
}

class ContractOfThreads : public testing::TestWithParam<const char*> {};

TEST_P(ContractOfThreads, TheirNumberLeavesNoTrace) {
    const auto input = test::dataFile(GetParam());
    TOILE_NEEDS_SHARED(input);
    const test::TemporaryFolder folder;
    for (const char* threads : {"1", "2"}) {
        const auto run =
            test::run("env", {std::string("OPENBLAS_NUM_THREADS=") + threads,
                              std::string("OMP_NUM_THREADS=") + threads, TOILE_PROGRAM, "flatten",
                              input.string(), "--unit", "mm", "--threads", threads, "-o",
                              (folder / (std::string(threads) + ".obj")).string()});
        ASSERT_LE(run.status, 1) << run.err;  // no cloth takes some of them
    }
    EXPECT_FALSE(folder.read("1.obj").empty());
    EXPECT_EQ(folder.read("1.obj"), folder.read("2.obj"));
}

#ifdef __linux__
TEST(Contract, EndsWhereMemoryDoesNotSuffice) {
    if (isSanitized()) {
        GTEST_SKIP() << "sanitizers reserve more memory than any limit";
    }
    const test::TemporaryFolder folder;
    const std::string output = (folder / "tshirt.svg").string();
    for (const int megabytes : {160, 200, 250, 300, 400}) {
        SCOPED_TRACE(megabytes);
        // Long beyond what it takes: only an end that never comes is cut off (124).
        const auto run = test::run(
            "bash", {"-c", "ulimit -v $0; exec timeout 60 \"$@\"", std::to_string(1024 * megabytes),
                     TOILE_PROGRAM, "flatten", kShirt, "--unit", "mm", "-o", output});
        EXPECT_NE(run.status, 124);
        if (run.err.find("not enough memory") != std::string::npos) {
            EXPECT_EQ(run.status, 3) << run.err;
        }
    }
}
#endif

INSTANTIATE_TEST_SUITE_P(Samples, ContractOfThreads, testing::Values("samples/tshirt.obj"));
INSTANTIATE_TEST_SUITE_P(Shared, ContractOfThreads, testing::Values("disks/maxface.obj"));

TEST(Contract, StrictRefusesWhatIsRepairedOtherwise) {
    const test::TemporaryFolder folder;
    const auto input = folder.write("yoke.obj",
                                    "v 0 0 0\nv 900 0 0\nv 0 900 0\nv 900 900 0\n"
                                    "f 1 2 3\nf 2 3 4\n");
    const auto repaired = test::toileRun({"flatten", input.string(), "--unit", "mm"});
    EXPECT_EQ(repaired.status, 0);
    EXPECT_NE(repaired.err.find("flipped"), std::string::npos) << repaired.err;
    const auto refused = test::toileRun({"flatten", input.string(), "--unit", "mm", "--strict"});
    EXPECT_EQ(refused.status, 1) << refused.err;  // the piece stays as it is and is named
    EXPECT_FALSE(refused.err.empty());
}

TEST(Contract, SeveralInputsArePrefixed) {
    const test::TemporaryFolder folder;
    const auto run =
        test::toileRun({"flatten", folder.write("left.obj", test::kTriangle).string(),
                        folder.write("right.obj", test::kTriangle).string(), "--unit", "mm"});
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.out.find("left/flap"), std::string::npos);
    EXPECT_NE(run.out.find("right/flap"), std::string::npos);
}

TEST(Contract, InfoTellsWhatAFileHolds) {
    const auto run = test::toileRun({"info", kShirt});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("unit mm"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("disk"), std::string::npos);
}

/// Every broken file ends with an orderly status and no NaN in what is written.
void expectNoCrash(const std::filesystem::path& nasty, int least) {
    const test::TemporaryFolder folder;
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(nasty)) {
        if (entry.is_directory()) {
            continue;
        }
        SCOPED_TRACE(entry.path().filename());
        std::vector<std::string> arguments{"flatten", entry.path().string()};
        if (entry.path().extension() != ".toile") {  // a project says its unit itself
            arguments.insert(arguments.end(), {"--unit", "mm"});
        }
        arguments.insert(arguments.end(),
                         {"-o", (folder / "out.obj").string(), "-o", (folder / "out.svg").string(),
                          "--report", (folder / "out.json").string()});
        const auto run = test::toileRun(arguments);
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
    EXPECT_GE(files, least);
}

TEST(Contract, NastyInputNeverCrashes) {
    const auto nasty = test::sharedFile("nasty");
    TOILE_NEEDS_SHARED(nasty);
    expectNoCrash(nasty, 25);
}

TEST(Contract, WhatFuzzingFoundNeverCrashes) {
    expectNoCrash(test::sourceFile("tests/fuzz/seeds"), 50);
}

}  // namespace
}  // namespace toile
