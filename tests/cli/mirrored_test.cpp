// SPDX-License-Identifier: GPL-3.0-or-later
// What a pattern does with pieces that mirror each other, but not quite.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using Json = nlohmann::json;

/// The sample shirt, its left sleeve longer: its hem is moved outwards, which makes the underarm
/// seam longer by about three quarters of that.
std::string shirtWithLongerSleeve(double outwards) {
    std::ifstream sample(test::sourceFile("resources/samples/tshirt.obj"));
    std::string line, part, shirt;
    double armhole = 0;
    while (std::getline(sample, line)) {
        part = line.starts_with("o ") ? line.substr(2) : part;
        double x = 0, y = 0, z = 0;
        const bool isVertex = std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) == 3;
        if (isVertex && part == "front") {
            armhole = std::max(armhole, x);
        } else if (isVertex && part == "sleeve_left" && x > armhole) {
            constexpr double kStretched = 60;  // mm
            char moved[96];
            std::snprintf(moved, sizeof moved, "v %.4f %.4f %.4f",
                          x + outwards * std::min((x - armhole) / kStretched, 1.0), y, z);
            line = moved;
        }
        shirt += line + '\n';
    }
    return shirt;
}

struct Flattened {
    std::string out;
    Json report;
};

Flattened flattened(const std::string& shirt, const std::vector<std::string>& options) {
    const test::TemporaryFolder folder;
    folder.write("shirt.obj", shirt);
    std::vector<std::string> arguments{"flatten",  (folder / "shirt.obj").string(), "--unit", "mm",
                                       "--report", (folder / "a.json").string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto run = test::toileRun(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return {run.out, Json::parse(folder.read("a.json"))};
}

/// The seam that sews a sleeve to itself.
Json underarm(const Json& report, const std::string& sleeve) {
    for (const Json& seam : report["seams"]) {
        if (seam["kind"] != "free" && seam["pieces"] == Json::array({sleeve, sleeve})) {
            return seam;
        }
    }
    return {};
}

double change(const Json& seam) {
    return seam["changed_by"][0]["mm"];
}

TEST(Mirrored, ALongerSleeveStaysAsInTheFileUnlessAskedFor) {
    const std::string shirt = shirtWithLongerSleeve(11.7);
    const auto [out, report] = flattened(shirt, {"--pattern"});
    const Json left = underarm(report, "sleeve_left"), right = underarm(report, "sleeve_right");
    const double longer = left["length_3d"].get<double>() - right["length_3d"].get<double>();
    EXPECT_NEAR(longer, 9, 0.1);
    for (const Json& seam : {left, right}) {
        EXPECT_NEAR(seam["length_2d_left"].get<double>(), seam["length_3d"].get<double>(), 1e-6);
        EXPECT_FALSE(seam.contains("changed_by"));
    }
    EXPECT_NE(
        out.find("not mirrored: sleeve_left and sleeve_right; seam sleeve_left / itself is 9."),
        std::string::npos)
        << out;
    EXPECT_NE(out.find("--mirror equal"), std::string::npos);
    EXPECT_EQ(report["symmetry"]["unequal"].size(), 1U);
    EXPECT_NEAR(report["symmetry"]["unequal"][0]["difference"].get<double>(), longer, 1e-6);
    for (const Json& piece : report["pieces"]) {
        EXPECT_LT(piece["max_boundary_length_error"].get<double>(), 1e-9);
        EXPECT_FALSE(piece.contains("changed_by"));
    }

    const auto [equalOut, equal] = flattened(shirt, {"--pattern", "--mirror", "equal"});
    const Json longSleeve = underarm(equal, "sleeve_left");
    const Json shortSleeve = underarm(equal, "sleeve_right");
    EXPECT_NEAR(longSleeve["length_2d_left"].get<double>(),
                shortSleeve["length_2d_left"].get<double>(), 1e-6);
    EXPECT_NEAR(change(longSleeve), -longer / 2, 1e-6);
    EXPECT_NEAR(change(shortSleeve), longer / 2, 1e-6);
    EXPECT_EQ(longSleeve["changed_by"][0]["cause"], "mirroring");
    char words[64];
    std::snprintf(words, sizeof words, "mirroring %.2f mm", -longer / 2);
    EXPECT_NE(equalOut.find(words), std::string::npos) << equalOut;
    for (const Json& piece : equal["pieces"]) {
        const std::string name = piece["name"];
        const bool isSleeve = name.starts_with("sleeve");
        EXPECT_EQ(piece["max_boundary_length_error"].get<double>() > 1e-3, isSleeve) << name;
    }
}

TEST(Mirrored, WithinTheToleranceSleevesBecomeEqualAndTheTableSaysSo) {
    const auto [out, report] = flattened(shirtWithLongerSleeve(1.3), {"--pattern", "--ledger"});
    const Json left = underarm(report, "sleeve_left"), right = underarm(report, "sleeve_right");
    EXPECT_NEAR(left["length_2d_left"].get<double>(), right["length_2d_left"].get<double>(), 1e-6);
    EXPECT_NEAR(change(right), 0.5, 0.1);
    EXPECT_EQ(out.find("not mirrored"), std::string::npos) << out;
    EXPECT_NE(out.find("mirroring +0."), std::string::npos) << out;
    EXPECT_FALSE(report["symmetry"].contains("unequal"));
}

}  // namespace
}  // namespace toile
