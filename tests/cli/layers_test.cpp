// SPDX-License-Identifier: GPL-3.0-or-later
// A lining in its shell on the command line, with the built program.
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"

namespace toile {
namespace {

/// Sheets bent to a quarter of a tube, 300 high, of these radii, millimetres.
std::string bentSheets(const std::vector<double>& radii) {
    constexpr int kAcross = 12;
    std::ostringstream text;
    int first = 1, number = 0;
    for (const double radius : radii) {
        for (int k = 0; k <= kAcross; ++k) {
            const double phi = 1.6 * k / kAcross;
            for (const double y : {0.0, 100.0, 200.0, 300.0}) {
                text << "v " << radius * std::sin(phi) << ' ' << y << ' ' << radius * std::cos(phi)
                     << '\n';
            }
        }
        text << "o sheet" << ++number << '\n';
        for (int k = 0; k < kAcross; ++k) {
            for (int row = 0; row < 3; ++row) {
                const int a = first + 4 * k + row;
                text << "f " << a << ' ' << a + 4 << ' ' << a + 5 << ' ' << a + 1 << '\n';
            }
        }
        first += 4 * (kAcross + 1);
    }
    return text.str();
}

class LayersOnTheCommandLine : public testing::Test {
protected:
    test::TemporaryFolder folder_;
    std::string coat_ = folder_.write("coat.obj", bentSheets({250, 246})).string();

    static test::ProgramRun run(const char* command, const std::string& file,
                                std::vector<std::string> more) {
        more.insert(more.begin(), {command, file, "--unit", "mm"});
        return test::toileRun(more);
    }
};

TEST_F(LayersOnTheCommandLine, AreListed) {
    const auto two = run("info", coat_, {});
    EXPECT_NE(two.out.find("taken for layers of cloth"), std::string::npos) << two.out;
    EXPECT_NE(two.out.find("layer 1, the outermost: 1 piece; layer 2: 1 piece\n"),
              std::string::npos)
        << two.out;
    const auto sheet = run("info", coat_, {"--as", "sheet"});
    EXPECT_EQ(sheet.out.find("layer"), std::string::npos) << sheet.out;
}

TEST_F(LayersOnTheCommandLine, AreCutFromAMaterialEach) {
    const auto check = run("check", coat_, {"--json"});
    const auto cloth = nlohmann::json::parse(check.out)["cloth"];
    ASSERT_EQ(cloth.size(), 2U) << check.out;
    EXPECT_EQ(cloth[1]["material"], "Lining");
    const auto report = folder_ / "report.json";
    EXPECT_EQ(run("flatten", coat_, {"-o", report.string()}).status, 0);
    const auto json = nlohmann::json::parse(folder_.read("report.json"));
    EXPECT_FALSE(json["pieces"][0].contains("material"));
    EXPECT_EQ(json["pieces"][1]["material"], "Lining");
    EXPECT_EQ(json["materials"][0]["name"], "Lining");
    const auto three = folder_.write("three.obj", bentSheets({242, 250, 246})).string();
    EXPECT_EQ(run("flatten", three, {"-o", report.string()}).status, 0);
    const auto pieces = nlohmann::json::parse(folder_.read("report.json"))["pieces"];
    EXPECT_EQ(pieces[0]["material"], "Layer 3");
    EXPECT_FALSE(pieces[1].contains("material"));
    EXPECT_EQ(pieces[2]["material"], "Layer 2");
}

TEST_F(LayersOnTheCommandLine, OneIsTakenAlone) {
    const auto lining = run("info", coat_, {"--layer", "2"});
    EXPECT_EQ(lining.status, 0);
    EXPECT_NE(lining.out.find("sheet2"), std::string::npos) << lining.out;
    EXPECT_EQ(lining.out.find("sheet1"), std::string::npos) << lining.out;
    EXPECT_NE(lining.err.find("layer 2 from outside is used"), std::string::npos) << lining.err;
    const auto fifth = run("info", coat_, {"--as", "layers", "--layer", "5"});
    EXPECT_EQ(fifth.status, 0);
    EXPECT_NE(fifth.err.find("the 2 layers"), std::string::npos) << fifth.err;
    EXPECT_EQ(run("info", coat_, {"--as", "sheet", "--layer", "2"}).status, 2);
}

}  // namespace
}  // namespace toile
