// SPDX-License-Identifier: GPL-3.0-or-later
// `toile check`, with the built program.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/project/project_file.h"
#include "tests/cli/run_program.h"
#include "tests/core/support/project_pieces.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

const std::string kSample = std::string(TOILE_SOURCE_DIR) + "/resources/samples/tshirt.obj";

constexpr const char* kLargeBall =
    "v 0 0 500\nv 100 0 500\nv 0 100 500\nv 0 0 600\n"
    "o ball\nf -4 -3 -2\nf -4 -1 -3\nf -3 -1 -2\nf -4 -2 -1\n";

TEST(Check, FlatClothHasDoubtsAndNoFaults) {
    const test::TemporaryFolder folder;
    const std::string flap = folder.write("flap.obj", test::kPanel).string();
    const auto run = test::toileRun({"check", flap, "--unit", "mm"});
    EXPECT_EQ(run.status, 0) << run.out << run.err;
    EXPECT_EQ(run.out.substr(0, run.out.find('\n')), "No faults, 1 doubt");
    EXPECT_NE(run.out.find("doubt: flap: no grain is set"), std::string::npos);
    EXPECT_EQ(run.err, "");
}

TEST(Check, TakesAPatternByHalf) {
    const auto half = test::toileRun({"check", kSample, "--unit", "mm", "--pattern", "--half"}),
               whole = test::toileRun({"check", kSample, "--unit", "mm", "--pattern"});
    EXPECT_EQ(half.status, 0) << half.err;
    EXPECT_EQ(half.out, whole.out);  // both are cut from the same cloth
}

TEST(Check, AProjectBringsItsGrainAndItsFabric) {
    const test::TemporaryFolder folder;
    Project project;
    project.files = {{folder.write("flap.obj", test::kPanel)}};
    project.loading.unit = LengthUnit::Millimetre;
    test::said(project, "flap").grain = 0.5;
    ASSERT_TRUE(writeProject(folder / "flap.toile", project));
    const auto ready = test::toileRun({"check", (folder / "flap.toile").string()});
    EXPECT_EQ(ready.status, 0) << ready.err;
    EXPECT_TRUE(ready.out.starts_with("Ready to cut\ncloth: ")) << ready.out;  // no finding
}

TEST(Check, TheFabricDecidesWhatStrainIsInDoubt) {
    const auto doubts = [](const char* fabric) -> int {
        const auto run =
            test::toileRun({"check", kSample, "--unit", "mm", "--fabric", fabric, "--json"});
        EXPECT_EQ(run.status, 0) << run.out;  // a rule of thumb makes no faults
        return nlohmann::json::parse(run.out)["doubts"].get<int>();
    };
    EXPECT_GT(doubts("denim"), doubts("neoprene"));
    EXPECT_GE(doubts("jersey"), doubts("unstated"));
    const auto unstated = test::toileRun({"check", kSample, "--unit", "mm"});
    EXPECT_EQ(unstated.status, 0);
    EXPECT_EQ(unstated.out.find("strain"), std::string::npos) << unstated.out;
    EXPECT_EQ(test::toileRun({"check", kSample, "--fabric", "granite"}).status, 2);
}

TEST(Check, SewsThePatternBackWhereAsked) {
    const std::string cap = test::sourceFile("resources/samples/cap.obj").string();
    const auto gapsFound = [&cap](const std::vector<std::string>& more) -> int {
        // Ten times as large as it is: a map that keeps angles misses it by centimetres.
        std::vector<std::string> words{"check", cap, "--unit", "cm", "--method", "lscm", "--json"};
        words.insert(words.end(), more.begin(), more.end());
        const auto run = test::toileRun(words);
        EXPECT_LE(run.status, 1) << run.err;
        int gaps = 0;
        const auto json = nlohmann::json::parse(run.out);
        for (const auto& finding : json["findings"]) {
            gaps += finding["kind"] == "sewn-gap" && finding["severity"] == "doubt" ? 1 : 0;
        }
        return gaps;
    };
    EXPECT_EQ(gapsFound({}), 0);
    EXPECT_EQ(gapsFound({"--prove"}), 1);
}

TEST(Check, FaultsAreStatusOne) {
    const test::TemporaryFolder folder;
    const std::string ball = folder.write("ball.obj", kLargeBall).string();
    const auto run = test::toileRun({"check", ball, "--unit", "mm"});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.out.find("fault: ball: the piece is closed"), std::string::npos) << run.out;
    EXPECT_EQ(test::toileRun({"check", kSample, "--unit", "mm", "--method", "natural"}).status, 1);
}

TEST(Check, JsonNamesKindSeverityAndPlace) {
    const auto run =
        test::toileRun({"check", kSample, "--unit", "mm", "--method", "natural", "--json"});
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json["verdict"], "faults");
    EXPECT_EQ(run.status, 1);
    bool anySeam = false;
    for (const auto& finding : json["findings"]) {
        anySeam = anySeam || (finding["kind"] == "seam-lengths" && finding["seam"].is_string());
        EXPECT_TRUE(finding["message"].is_string());
    }
    EXPECT_TRUE(anySeam);
}

/// A pyramid without a base, as high as eight times its foot: flat, it cannot keep its lengths.
constexpr const char* kSpike =
    "v 0 0 0\nv 100 0 0\nv 100 100 0\nv 0 100 0\nv 50 50 400\no spike\n"
    "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

TEST(Check, StrainThatNoClothTakesIsAFaultAndNamesItsRemedy) {
    const test::TemporaryFolder folder;
    const std::string spike = folder.write("spike.obj", kSpike).string();
    for (const char* command : {"check", "flatten"}) {
        const auto run = test::toileRun({command, spike, "--unit", "mm"});
        const std::string text = run.out + run.err;
        EXPECT_EQ(run.status, 1) << text;
        EXPECT_NE(text.find("fault: spike: strain exceeds 25 %"), std::string::npos) << text;
        EXPECT_NE(text.find("(--auto-cut --max-strain 5)"), std::string::npos) << text;
        EXPECT_NE(text.find("nearly closed: its outline of 400 mm"), std::string::npos) << text;
        EXPECT_EQ(text.find("can be used as it is"), std::string::npos) << text;
    }
    EXPECT_EQ(test::toileRun({"flatten", spike, "--fail-on", "rain"}).status, 2);
}

/// A tube of 24 sides along z, in mm; its faces look inwards if asked for.
std::string tubeAlongZ(bool isInsideOut = false) {
    constexpr int kSides = 24, kRings = 5;
    std::string text, faces;
    for (int r = 0; r < kRings; ++r) {
        for (int k = 0; k < kSides; ++k) {
            const double phi = 2 * 3.14159265358979 * k / kSides, radius = 380 - 40 * r;
            text += "v " + std::to_string(radius * std::cos(phi)) + ' ' +
                    std::to_string(radius * std::sin(phi)) + ' ' + std::to_string(150 * r) + '\n';
            const int a = r * kSides + k + 1, b = r * kSides + (k + 1) % kSides + 1;
            const std::string corner[] = {std::to_string(a), std::to_string(b),
                                          std::to_string(b + kSides), std::to_string(a + kSides)};
            if (r + 1 < kRings) {
                faces += "f " + corner[0] + ' ' + corner[isInsideOut ? 3 : 1] + ' ' + corner[2] +
                         ' ' + corner[isInsideOut ? 1 : 3] + '\n';
            }
        }
    }
    return text + faces;
}

TEST(Check, ARoundSkirtAlongZIsCutInHalves) {
    const test::TemporaryFolder folder;
    const std::string skirt = folder.write("skirt.obj", tubeAlongZ()).string();
    const auto told = test::toileRun({"info", skirt, "--unit", "mm"});
    EXPECT_NE(told.out.find("up z (the openings lie one above the other along z"),
              std::string::npos)
        << told.out;
    EXPECT_NE(told.out.find("right side: outwards (100 %"), std::string::npos) << told.out;
    const std::string report = (folder / "out.json").string();
    const auto run = test::toileRun(
        {"flatten", skirt, "--unit", "mm", "--auto-cut", "-o", report, "--fail-on", "doubt"});
    EXPECT_EQ(run.status, 0) << run.err;
    const auto pieces = nlohmann::json::parse(folder.read("out.json"))["pieces"];
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_NEAR(pieces[0]["area_3d"].get<double>(), pieces[1]["area_3d"].get<double>(),
                1e-3 * pieces[1]["area_3d"].get<double>());
}

TEST(Check, AnInsideOutGarmentIsInDoubtUntilItIsTurned) {
    const test::TemporaryFolder folder;
    const std::string tube = folder.write("tube.obj", tubeAlongZ(true)).string();
    for (const char* command : {"info", "check", "flatten"}) {
        std::vector<std::string> words{command, tube, "--unit", "mm", "--auto-cut"};
        const auto run = test::toileRun(words);
        const std::string text = run.out + run.err;
        EXPECT_EQ(run.status, 0) << text;
        EXPECT_NE(text.find("doubt: tube.obj: faces of the garment point inwards (100 %"),
                  std::string::npos)
            << text;
        EXPECT_NE(text.find("(--turn-over)"), std::string::npos) << text;
        words.emplace_back("--turn-over");
        const auto turned = test::toileRun(words);
        EXPECT_EQ((turned.out + turned.err).find("inwards"), std::string::npos)
            << turned.out << turned.err;
    }
    const auto strict =
        test::toileRun({"flatten", tube, "--unit", "mm", "--auto-cut", "--fail-on", "doubt"});
    EXPECT_EQ(strict.status, 1) << strict.err;
}

TEST(Check, AFlatPieceIsInNoDoubtThatFlattenFailsOn) {
    const test::TemporaryFolder folder;
    const std::string flap = folder.write("flap.obj", test::kPanel).string();
    const auto run = test::toileRun({"flatten", flap, "--unit", "mm", "--fail-on", "doubt"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
}

TEST(Check, TheReportListsDoubts) {
    const test::TemporaryFolder folder;
    const std::string spike = folder.write("spike.obj", kSpike).string();
    const std::string report = (folder / "out.json").string();
    EXPECT_EQ(test::toileRun({"flatten", spike, "--unit", "mm", "-o", report}).status, 1);
    const auto json = nlohmann::json::parse(folder.read("out.json"));
    ASSERT_EQ(json["doubts"].size(), 2U);  // its only opening faces along z
    EXPECT_EQ(json["doubts"][0]["code"], "up-axis-in-doubt");
    EXPECT_EQ(json["doubts"][0]["piece"], nullptr);
    EXPECT_EQ(json["doubts"][0]["fault"], false);
    EXPECT_EQ(json["doubts"][1]["code"], "strain-beyond-cloth");
    EXPECT_EQ(json["doubts"][1]["piece"], "spike");
    EXPECT_EQ(json["doubts"][1]["fault"], true);
}

TEST(Check, ThickShellsAndScansAreInDoubtHoweverTheyAreCut) {
    for (const char* name : {"thick/tee_sim_thick.obj", "scans/dress_scan.obj"}) {
        const auto file = test::sharedFile(name);
        TOILE_NEEDS_SHARED(file);
        const auto run = test::toileRun({"flatten", file.string(), "--auto-cut", "--cut-style",
                                         "topology", "--fail-on", "doubt"});
        EXPECT_EQ(run.status, 1) << name;
        EXPECT_TRUE(run.err.find("toile: doubt: ") != std::string::npos ||
                    run.err.find("toile: fault: ") != std::string::npos)
            << run.err;
    }
}

TEST(Check, SaysHowMuchClothThePatternTakes) {
    const auto run =
        test::toileRun({"check", kSample, "--unit", "mm", "--pattern", "--fabric", "denim"});
    EXPECT_NE(run.out.find(" mm of cloth 1500 mm wide"), std::string::npos) << run.out;
    const auto json = nlohmann::json::parse(
        test::toileRun({"check", kSample, "--unit", "mm", "--fabric", "denim", "--json"}).out);
    ASSERT_EQ(json["cloth"].size(), 1U);
    EXPECT_EQ(json["cloth"][0]["width_mm"], 1500);
    EXPECT_TRUE(json["cloth"][0]["fits"].get<bool>());
    EXPECT_GT(json["cloth"][0]["length_mm"], 100);
}

TEST(Check, AStatedGrainIsASetGrain) {
    for (const char* option : {"--pattern", "--grain=vertical", "--grain=least-strain"}) {
        const auto run = test::toileRun({"check", kSample, "--unit", "mm", option});
        EXPECT_EQ(run.out.find("no grain is set"), std::string::npos) << option << run.out;
    }
    const auto run = test::toileRun({"check", kSample, "--unit", "mm", "--pattern"});
    EXPECT_TRUE(run.out.starts_with("Ready to cut\n")) << run.out;
}

TEST(Check, APieceThatNoClothHoldsIsInDoubt) {
    const test::TemporaryFolder folder;
    const std::string flap = folder.write("flap.obj", test::kPanel).string();
    const auto run = test::toileRun({"check", flap, "--unit", "cm", "--pattern"});
    EXPECT_NE(run.out.find(" room for only 1400.0 mm"), std::string::npos) << run.out;
}

TEST(Check, GuessedUnitsAreNamed) {
    const test::TemporaryFolder folder;
    const std::string flap =
        folder.write("flap.obj", "v 0 0 0\nv 15 0 0\nv 0 20 0\no flap\nf 1 2 3\n").string();
    const auto run = test::toileRun({"check", flap});
    EXPECT_NE(run.out.find("doubt: flap.obj: the file states no unit"), std::string::npos)
        << run.out;
    EXPECT_EQ(test::toileRun({"check", flap, "--unit", "cm"}).out.find("states no unit"),
              std::string::npos);
}

TEST(Check, WhatCannotBeReadIsStatusThreeInOneSentence) {
    const auto run = test::toileRun({"check", "nowhere.obj"});
    EXPECT_EQ(run.status, 3);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.out, "");
}

}  // namespace
}  // namespace toile
