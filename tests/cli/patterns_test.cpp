// SPDX-License-Identifier: GPL-3.0-or-later
// Fair and trued lines by the command line: the tables of docs/patterns.md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/docs_table.h"
#include "tests/cli/run_program.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using Json = nlohmann::json;

Json reportOf(const std::filesystem::path& garment, const std::vector<std::string>& options) {
    const test::TemporaryFolder folder;
    std::vector<std::string> arguments{"flatten", garment.string(), "--report",
                                       (folder / "a.json").string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto run = test::run(TOILE_PROGRAM, arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return Json::parse(folder.read("a.json"));
}

std::string degrees(double radians) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", radians * 180 / std::numbers::pi);
    return std::string(text) == "-0.0" ? "0.0" : text;
}

TEST(PatternsPage, TheKinksOfTheBodiceAreThoseOfTheProgram) {
    const Json report = reportOf(test::dataFile("samples/bodice.obj"), {"--true"});
    std::string table = "| Seam | Its | Kink ° | Trued ° |\n|---|---|--:|--:|\n";
    for (const Json& end : report["seam_ends"]) {
        table += "| " + end["seam"].get<std::string>() + " | " + end["end"].get<std::string>() +
                 " | " + degrees(end["kink_exact"]) + " | " + degrees(end["kink"]) + " |\n";
    }
    test::expectFiguresInDocs("patterns.md", "kinks", table);
}

TEST(PatternsPage, TheWalkOfTheShirtIsThatOfTheProgram) {
    const auto run =
        test::run(TOILE_PROGRAM,
                  {"walk", test::dataFile("samples/tshirt.obj").string(), "--pattern", "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    std::string table =
        "| Seam | Left mm | Right mm | Notches | Largest error mm |\n"
        "|---|--:|--:|--:|--:|\n";
    const Json walked = Json::parse(run.out);
    for (const Json& seam : walked["seams"]) {
        double left = 0, right = 0, error = 0;
        int notches = 0;
        for (const Json& station : seam["stations"]) {
            left += station["length_2d_left"].get<double>();
            right += station["length_2d_right"].get<double>();
            error = std::max(error, std::abs(station["error_mm"].get<double>()));
            notches += station["notch"].is_null() ? 0 : 1;
        }
        char row[256];
        std::snprintf(row, sizeof row, "| %s | %.2f | %.2f | %d | %s |\n",
                      seam["name"].get<std::string>().c_str(), left, right, notches,
                      error <= 1e-6 ? "0.000001 or less" : "more");
        table += row;
    }
    test::expectFiguresInDocs("seams.md", "walk", table);
}

TEST(FairOption, StandsAloneOrWithItsNumbers) {
    const std::string bodice = test::dataFile("samples/bodice.obj").string();
    const auto farthest = [&](const std::vector<std::string>& options) -> double {
        double most = 0;
        const Json report = reportOf(bodice, options);
        for (const Json& piece : report["pieces"]) {
            most = std::max(most, piece["line"]["farthest"].get<double>());
        }
        return most;
    };
    const double usual = farthest({"--fair"});
    EXPECT_LE(usual, 1);
    EXPECT_EQ(usual, farthest({"--fair=1,40"}));
    EXPECT_EQ(usual, farthest({"--fair", "1,40"}));
    EXPECT_LE(farthest({"--fair=0.2"}), 0.2);
    // What follows is a file unless it is a number.
    const auto run = test::run(TOILE_PROGRAM, {"flatten", "--fair", bodice});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char* wrong : {"--fair=0", "--fair=1,2000", "--fair=x", "--fair=1,2,3"}) {
        EXPECT_EQ(test::run(TOILE_PROGRAM, {"flatten", bodice, wrong}).status, 2) << wrong;
    }
}

TEST(FairOption, LeavesReportsAsTheyAreWhereItIsNotGiven) {
    const Json report = reportOf(test::dataFile("samples/bodice.obj"), {});
    EXPECT_FALSE(report.contains("seam_ends"));
    EXPECT_FALSE(report["pieces"][0].contains("line"));
}

TEST(GrainOption, DrawsAGrainLineOnEveryPiece) {
    const std::string shirt = test::dataFile("samples/tshirt.obj").string();
    for (const std::string rule : {"vertical", "reference", "least-strain"}) {
        const Json report = reportOf(shirt, {"--grain", rule});
        for (const Json& piece : report["pieces"]) {
            EXPECT_TRUE(piece.contains("grain")) << rule << ' ' << piece["name"];
        }
    }
    EXPECT_FALSE(reportOf(shirt, {})["pieces"][0].contains("grain"));
    EXPECT_EQ(test::run(TOILE_PROGRAM, {"flatten", shirt, "--grain", "best"}).status, 2);
    const test::TemporaryFolder folder;
    const auto svg = (folder / "a.svg").string();
    EXPECT_EQ(test::run(TOILE_PROGRAM, {"flatten", shirt, "--grain", "vertical", "-o", svg}).status,
              0);
    EXPECT_NE(folder.read("a.svg").find("--grain\""), std::string::npos);
}

TEST(GrainOption, GivesMirroredPiecesOneAnswer) {
    const Json report =
        reportOf(test::dataFile("samples/tshirt.obj"), {"--grain", "vertical", "--mirror", "auto"});
    std::map<std::string, double> grains;
    for (const Json& piece : report["pieces"]) {
        grains[piece["name"]] = piece["grain"];
    }
    for (const Json& pair : report["symmetry"]["pairs"]) {
        if (pair["pieces"].size() == 2) {  // they lie as each other's mirror images in x
            const double sum = grains[pair["pieces"][0]] + grains[pair["pieces"][1]];
            EXPECT_NEAR(std::cos(sum), -1, 0.01);
        }
    }
}

TEST(HalfOption, DrawsOnceWhatMirrors) {
    const std::string tshirt = test::dataFile("samples/tshirt.obj").string();
    const test::TemporaryFolder folder;
    const auto svgOf = [&](const std::vector<std::string>& options) -> std::string {
        std::vector<std::string> arguments{"flatten", tshirt, "-o", (folder / "a.svg").string()};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const auto run = test::run(TOILE_PROGRAM, arguments);
        EXPECT_EQ(run.status, 0) << run.err;
        return folder.read("a.svg");
    };
    const std::string half = svgOf({"--mirror", "auto", "--half"});
    for (const char* said : {"cut 1 on fold", "place on fold", "cut 1 pair", "-front--fold"}) {
        EXPECT_NE(half.find(said), std::string::npos) << said;
    }
    EXPECT_EQ(half, svgOf({"--half"}));
    const std::string exact = svgOf({"--mirror", "none", "--half"});
    EXPECT_EQ(exact.find("fold"), std::string::npos);
    EXPECT_EQ(exact, svgOf({}));

    int folds = 0, pairs = 0, left = 0;
    const Json report = reportOf(tshirt, {"--half"});
    for (const Json& piece : report["pieces"]) {
        EXPECT_TRUE(piece["by_half"]);
        const std::string cutAs = piece["cut_as"];
        folds += cutAs == "fold" ? 1 : 0;
        pairs += cutAs == "pair" ? 1 : 0;
        left += piece.contains("cut_with") ? 1 : 0;
    }
    EXPECT_EQ(folds, 3);
    EXPECT_EQ(pairs, 2);
    EXPECT_EQ(left, 1);
    EXPECT_FALSE(reportOf(tshirt, {})["pieces"][0].contains("by_half"));
}

TEST(PatternOption, IsAllOfItWithTheDefaults) {
    const std::string tshirt = test::dataFile("samples/tshirt.obj").string();
    const Json all = reportOf(tshirt, {"--pattern"});
    const Json typed =
        reportOf(tshirt, {"--fair", "--true", "--mirror", "auto", "--allowance", "10", "--hem",
                          "30", "--notches", "auto", "--grain", "vertical"});
    const auto withoutTimes = [](Json report) {
        for (Json& piece : report["pieces"]) {
            piece.erase("seconds");
        }
        report.erase("files");
        return report;
    };
    EXPECT_EQ(withoutTimes(all), withoutTimes(typed));
    int notches = 0;
    for (const Json& piece : all["pieces"]) {
        EXPECT_TRUE(piece.contains("line") && piece.contains("grain")) << piece["name"];
        EXPECT_GT(piece["cutting_line_length"], piece["perimeter_2d"]) << piece["name"];
        notches += static_cast<int>(piece["notches"].size());
    }
    EXPECT_GT(notches, 10);
}

TEST(PatternOption, GivesWayToWhatElseIsTyped) {
    const std::string tshirt = test::dataFile("samples/tshirt.obj").string();
    const Json report = reportOf(tshirt, {"--pattern", "--hem", "0", "--notches", "none",
                                          "--mirror", "none", "--grain", "least-strain"});
    EXPECT_FALSE(report.contains("symmetry"));
    for (const Json& piece : report["pieces"]) {
        EXPECT_FALSE(piece.contains("notches"));
        for (const Json& segment : piece["segments"]) {
            if (segment.contains("limited_by")) {
                EXPECT_LT(segment["allowance"], segment["usual_allowance"]);
            } else {
                EXPECT_EQ(segment["allowance"], segment.value("edge", "") == "hem" ? 0 : 10);
            }
        }
    }
}

TEST(AllowanceOption, OfAKindIsDrawnAsItIs) {
    const std::string tshirt = test::dataFile("samples/tshirt.obj").string();
    int limited = 0, typed = 0;
    for (const char* width : {"10", "12"}) {
        const bool isTyped = std::string(width) == "12";
        const Json report =
            isTyped ? reportOf(tshirt, {"--pattern", "--edge-allowance", "collar-edge=12"})
                    : reportOf(tshirt, {"--pattern"});
        for (const Json& piece : report["pieces"]) {
            for (const Json& segment : piece["segments"]) {
                if (segment.value("edge", "") == "collar-edge") {
                    limited += segment.contains("limited_by") ? 1 : 0;
                    typed += segment["allowance"] == 12 ? 1 : 0;
                }
            }
        }
    }
    EXPECT_EQ(limited, 1);  // by the width of the neckband
    EXPECT_EQ(typed, 1);
}

TEST(AllowanceOption, AloneAddsNothingElse) {
    const std::string tshirt = test::dataFile("samples/tshirt.obj").string();
    const Json bare = reportOf(tshirt, {}), report = reportOf(tshirt, {"--hem", "25"});
    for (std::size_t p = 0; p < report["pieces"].size(); ++p) {
        const Json& piece = report["pieces"][p];
        EXPECT_EQ(piece["area_2d"], bare["pieces"][p]["area_2d"]);
        EXPECT_FALSE(piece.contains("notches") || piece.contains("line"));
        for (const Json& segment : piece["segments"]) {
            const bool isHem = segment.value("edge", "") == "hem";
            EXPECT_TRUE(segment["allowance"] == (isHem ? 25 : 10) ||
                        segment.contains("limited_by"));
        }
    }
    EXPECT_FALSE(bare["pieces"][0].contains("segments"));
    for (const char* wrong : {"-1", "501", "wide"}) {
        EXPECT_EQ(test::run(TOILE_PROGRAM, {"flatten", tshirt, "--allowance", wrong}).status, 2);
    }
    EXPECT_EQ(test::run(TOILE_PROGRAM, {"flatten", tshirt, "--notches", "some"}).status, 2);
}

TEST(LabelOptions, StandOnEveryLabelAndInTheReport) {
    const std::string tshirt = test::dataFile("samples/tshirt.obj").string();
    const Json report = reportOf(tshirt, {"--size", "38", "--date", "31 January 2026"});
    EXPECT_EQ(report["size"], "38");
    EXPECT_EQ(report["date"], "31 January 2026");
    EXPECT_FALSE(reportOf(tshirt, {}).contains("size"));
    const test::TemporaryFolder folder;
    const auto drawn = [&](std::vector<std::string> options) {
        const std::string svg = (folder / "pattern.svg").string();
        options.insert(options.begin(), {"flatten", tshirt, "-o", svg});
        EXPECT_EQ(test::run(TOILE_PROGRAM, options).status, 0);
        return folder.read("pattern.svg");
    };
    const auto countOf = [](const std::string& text, const std::string& words) {
        int count = 0;
        for (std::size_t at = text.find(words); at != std::string::npos;
             at = text.find(words, at + 1)) {
            ++count;
        }
        return count;
    };
    const auto pieces = static_cast<int>(report["pieces"].size());
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{}, std::vector<std::string>{"--allowance", "10"}}) {
        std::vector<std::string> options{"--size", "38", "--date", "31 January 2026"};
        options.insert(options.end(), more.begin(), more.end());
        const std::string svg = drawn(options);
        EXPECT_EQ(countOf(svg, "size 38"), pieces);
        EXPECT_EQ(countOf(svg, "31 January 2026"), pieces);
        EXPECT_EQ(svg, drawn(options));
    }
    EXPECT_EQ(countOf(drawn({}), "size"), countOf(drawn({"--size", ""}), "size"));
}

TEST(MirrorOption, SaysWhatMirrorsWhatAndWhatThatCosts) {
    const std::string bodice = test::dataFile("samples/bodice.obj").string();
    EXPECT_FALSE(reportOf(bodice, {}).contains("symmetry"));
    const Json said = reportOf(bodice, {"--mirror", "auto"}).at("symmetry");
    double least = 0, most = 0, exactMost = 0;
    for (const Json& pair : said.at("pairs")) {
        EXPECT_TRUE(pair.at("equal"));
        EXPECT_LE(pair.at("strain_mean_abs"), std::max(-pair.at("strain_min").get<double>(),
                                                       pair.at("strain_max").get<double>()));
        least = std::min(least, pair.at("strain_min").get<double>());
        most = std::max(most, pair.at("strain_max").get<double>());
        exactMost = std::max(exactMost, pair.at("exact").at("strain_max").get<double>());
    }
    EXPECT_EQ(said.at("pairs").size(), 4U);
    EXPECT_EQ(said.at("strain_min"), least);
    EXPECT_EQ(said.at("strain_max"), most);
    EXPECT_EQ(said.at("exact").at("strain_max"), exactMost);
    // It was made with a mirror plane: there is nothing to be paid for.
    EXPECT_NEAR(said.at("strain_mean_abs"), said.at("exact").at("strain_mean_abs").get<double>(),
                1e-6);
}

}  // namespace
}  // namespace toile
