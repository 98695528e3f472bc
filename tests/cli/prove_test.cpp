// SPDX-License-Identifier: GPL-3.0-or-later
// `toile prove` and `toile compare --prove`, with the built program.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/garment/fabric_stiffness.h"
#include "tests/cli/docs_table.h"
#include "tests/cli/run_program.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

constexpr int kColumns = 12, kRows = 6;

/// A barrel of two halves that are sewn at their sides: flat cloth cannot lie on it.
std::string barrel() {
    std::ostringstream text;
    for (int row = 0; row <= kRows; ++row) {
        const double radius = 80 + 25 * std::sin(kPi * row / kRows);
        for (int k = 0; k < kColumns; ++k) {
            const double turn = 2 * kPi * k / kColumns;
            text << "v " << radius * std::cos(turn) << ' ' << 30 * row << ' '
                 << radius * std::sin(turn) << '\n';
        }
    }
    for (const int half : {0, 1}) {
        text << "o " << (half == 0 ? "front" : "back") << '\n';
        for (int row = 0; row < kRows; ++row) {
            for (int k = half * kColumns / 2; k < (half + 1) * kColumns / 2; ++k) {
                const int a = row * kColumns + k + 1, b = row * kColumns + (k + 1) % kColumns + 1;
                text << "f " << a << ' ' << a + kColumns << ' ' << b + kColumns << ' ' << b << '\n';
            }
        }
    }
    return text.str();
}

class ProveCommand : public testing::Test {
protected:
    test::ProgramRun run(const std::string& command, std::vector<std::string> more = {}) const {
        std::vector<std::string> words{command, barrel_, "--unit", "mm"};
        words.insert(words.end(), more.begin(), more.end());
        return test::toileRun(words);
    }

    const test::TemporaryFolder folder_;
    const std::string barrel_ = folder_.write("barrel.obj", barrel()).string();
};

TEST_F(ProveCommand, SaysHowFarFromTheDesignThePatternSits) {
    const auto proof = run("prove");
    EXPECT_EQ(proof.status, 0) << proof.out << proof.err;
    EXPECT_TRUE(proof.out.starts_with("The sewn pattern is ")) << proof.out;
    EXPECT_NE(proof.out.find(" mm from the design on average, "), std::string::npos) << proof.out;
    for (const char* said : {"\npiece ", "gap mm mean", "pulls %", "free %",
                             "\nsewn from: ", " % of the force at seams is left"}) {
        EXPECT_NE(proof.out.find(said), std::string::npos) << said << '\n' << proof.out;
    }
}

TEST_F(ProveCommand, ReportsTheSameAsJson) {
    const auto proof = run("prove", {"--json", "--report", (folder_ / "proof.json").string()});
    EXPECT_EQ(proof.status, 0) << proof.err;
    const auto printed = nlohmann::json::parse(proof.out);
    EXPECT_EQ(printed, nlohmann::json::parse(folder_.read("proof.json")));
    EXPECT_GE(printed["gap_mm"]["p95"], printed["gap_mm"]["mean"]);
    EXPECT_GE(printed["gap_mm"]["max"], printed["gap_mm"]["p95"]);
    EXPECT_LT(printed["gap_mm"]["mean"], 10);
    EXPECT_FALSE(printed["pieces"].empty());
    for (const auto& piece : printed["pieces"]) {
        EXPECT_TRUE(piece["sewn"].get<bool>());
        EXPECT_EQ(piece["fabric"], "unstated");
    }
}

TEST_F(ProveCommand, SewsThePatternOfAFileAndNamesItsFaults) {
    for (const char* file : {"barrel.svg", "barrel.dxf"}) {
        const std::string pattern = (folder_ / file).string();
        ASSERT_EQ(run("flatten", {"-o", pattern}).status, 1);  // the barrel strains
        const auto good = run("prove", {"--pattern", pattern, "--json"});
        EXPECT_EQ(good.status, 0) << good.out << good.err;
        const auto own = nlohmann::json::parse(run("prove", {"--json"}).out);
        const auto json = nlohmann::json::parse(good.out);
        EXPECT_NEAR(json["gap_mm"]["mean"], own["gap_mm"]["mean"], 0.1) << file;
    }
    const auto large =
        run("prove", {"--pattern", (folder_ / "barrel.dxf").string(), "--pattern-unit", "1.05mm"});
    EXPECT_EQ(large.status, 1) << large.out << large.err;
    EXPECT_NE(large.out.find("\nfault: "), std::string::npos) << large.out;
}

TEST_F(ProveCommand, IsTheSameForAnyNumberOfThreads) {
    const auto proven = [this](const char* threads) {
        auto json = nlohmann::json::parse(run("prove", {"--json", "--threads", threads}).out);
        json.erase("seconds");
        return json.dump();
    };
    EXPECT_EQ(proven("1"), proven("2"));
}

TEST_F(ProveCommand, TheClothDecidesHowItComesToRest) {
    const auto proven = [this](const std::vector<std::string>& words) {
        std::vector<std::string> all{"--json"};
        all.insert(all.end(), words.begin(), words.end());
        return nlohmann::json::parse(run("prove", all).out);
    };
    const auto jersey = proven({"--fabric", "jersey"});
    EXPECT_EQ(jersey["pieces"][0]["fabric"], "jersey");
    const auto typed = proven({"--stretch", "34,17", "--shear", "18", "--bend", "19", "--weight",
                               "187", "--fabric", "jersey"});
    EXPECT_NEAR(typed["gap_mm"]["mean"], jersey["gap_mm"]["mean"], 1e-6);  // 1e-6 is not exact
    EXPECT_NE(proven({"--stretch", "5000"})["strain"], jersey["strain"]);
}

/// A project of the barrel with this of its proof.
class ProveProject : public ProveCommand {
protected:
    nlohmann::json proven(const std::string& proof, std::vector<std::string> words = {}) const {
        folder_.write(
            "barrel.toile",
            R"({"format": "toile-project", "version": 3, "files": [{"path": "barrel.obj"}],
                          "reading": {"unit": "mm"}, "proof": )" +
                proof + "}");
        words.insert(words.begin(), {"prove", (folder_ / "barrel.toile").string(), "--json"});
        const auto proved = test::toileRun(words);
        EXPECT_EQ(proved.status, 0) << proved.out << proved.err;
        return proved.status == 0 ? nlohmann::json::parse(proved.out) : nlohmann::json();
    }
};

TEST_F(ProveProject, IsSewnAsItSays) {
    const auto json = proven(R"({"pressure": 25, "gravity": true, "edge": 17, "selfContact": true,
                                 "thickness": 0.5, "stiffness": {"weight": 90}})");
    const auto& held = json["held"];
    EXPECT_EQ(held["pressure_pa"], 25);
    EXPECT_EQ(held["gravity"], true);
    EXPECT_EQ(held["self_contact_mm"], 0.5);
    EXPECT_EQ(held["stiffness"]["weight"], 90);
    EXPECT_NE(json["edge_mm"], proven("{}")["edge_mm"]);
}

TEST_F(ProveProject, WhatIsTypedGoesBefore) {
    const std::string said = R"({"pressure": 25, "gravity": true, "selfContact": true,
                                 "stiffness": {"warp": 50, "weight": 90}})";
    auto held = proven(
        said, {"--pressure", "10", "--no-gravity", "--no-self-contact", "--stretch", "70"})["held"];
    EXPECT_EQ(held["pressure_pa"], 10);  // which is the usual one, too
    EXPECT_EQ(held["gravity"], false);
    EXPECT_EQ(held["self_contact_mm"], nullptr);
    EXPECT_EQ(held["stiffness"]["warp"], 70);
    EXPECT_EQ(held["stiffness"]["weft"], 70);
    EXPECT_EQ(held["stiffness"]["weight"], 90);
    held = proven(said, {"--fabric", "denim"})["held"];  // it was measured of another
    EXPECT_EQ(held["stiffness"]["warp"], nullptr);
    EXPECT_EQ(held["pressure_pa"], 25);
}

TEST_F(ProveProject, IsWornOnItsBody) {
    folder_.write("body.obj", barrel());
    const std::string said = R"({"body": {"path": "body.obj"}, "bodyUnit": "0.9 mm"})";
    EXPECT_EQ(proven(said)["held"]["body"], "body.obj");
    EXPECT_EQ(proven(said, {"--body", "none"})["held"]["on"], "design");
    const std::string typed = (folder_ / "typed.obj").string();
    folder_.write("typed.obj", barrel());
    EXPECT_EQ(proven(said, {"--body", typed})["held"]["body"], "typed.obj");
    const std::string project = (folder_ / "barrel.toile").string();
    const auto overwriting =
        test::toileRun({"flatten", project, "-o", (folder_ / "body.obj").string()});
    EXPECT_EQ(overwriting.status, 2) << overwriting.err;
    std::filesystem::remove(folder_ / "body.obj");
    const auto gone = test::toileRun({"prove", project});
    EXPECT_EQ(gone.status, 3) << gone.err;
    EXPECT_NE(gone.err.find("body.obj"), std::string::npos) << gone.err;
    EXPECT_EQ(test::toileRun({"flatten", project, "-o", (folder_ / "a.dxf").string()}).status, 1);
}

TEST_F(ProveProject, SewsThePatternThatItNames) {
    ASSERT_EQ(run("flatten", {"-o", (folder_ / "barrel.dxf").string()}).status, 1);
    const std::string said = R"({"sewn": "reference"}, "reference": {"path": "barrel.dxf"})";
    const auto reference = proven(said)["source"];
    EXPECT_NE(reference, proven(R"({"sewn": "own"})")["source"]);
    EXPECT_EQ(proven(said, {"--reference", "none"})["source"], proven("{}")["source"]);
    EXPECT_EQ(proven(R"({"sewn": "reference"})")["source"],
              proven("{}")["source"]);  // none is open
    const auto designers =
        test::toileRun({"prove", (folder_ / "barrel.toile").string(), "--reference", "uv"});
    EXPECT_EQ(designers.status, 3);
    EXPECT_NE(designers.err.find("--reference none"), std::string::npos) << designers.err;
}

TEST_F(ProveProject, TheCheckIsHeldByTheSame) {
    proven(R"({"body": {"path": "missing.obj"}})", {"--body", "none"});
    const std::string project = (folder_ / "barrel.toile").string();
    for (const char* command : {"check", "compare"}) {
        const auto held = test::toileRun({command, project, "--prove"});
        EXPECT_NE(held.err.find("missing.obj"), std::string::npos) << held.err;
        EXPECT_NE(held.status, 0);
    }
}

TEST_F(ProveCommand, TheFabricsAreThoseOfThePage) {
    std::string table =
        "| Fabric | Warp N/m | Weft N/m | Coupling N/m | Shear N/m | Bending µN·m | g/m² |\n"
        "|---|--:|--:|--:|--:|--:|--:|\n";
    for (const Fabric& fabric : fabricPresets()) {
        const ClothStiffness cloth = clothStiffness(fabric);
        table += "| `" + fabric.id + "`";
        for (const double value : {cloth.warp, cloth.weft, cloth.coupling, cloth.shear,
                                   1e6 * cloth.bending, cloth.weight}) {
            table += " | " + fixed(value, 0);
        }
        table += " |\n";
    }
    test::expectTableInDocs("prove.md", "fabrics", table);
}

TEST_F(ProveCommand, RefusesWhatCannotBeRead) {
    const auto refusal = [this](const std::vector<std::string>& words, int status) {
        const auto proof = run("prove", words);
        EXPECT_EQ(proof.status, status) << proof.out << proof.err;
        EXPECT_EQ(std::ranges::count(proof.err, '\n'), 1) << proof.err;
        EXPECT_EQ(proof.out, "");
        return proof.err;
    };
    refusal({"--pattern", (folder_ / "missing.svg").string()}, 3);
    refusal({"--pattern", folder_.write("broken.dxf", "not a drawing").string()}, 3);
    refusal({"--body", (folder_ / "missing.obj").string()}, 3);
    const std::string far =
        folder_.write("far.obj", "v 9e6 0 0\nv 9.1e6 0 0\nv 9e6 1 0\nf 1 2 3\n").string();
    EXPECT_NE(refusal({"--body", far}, 3).find("--body-unit"), std::string::npos);
    const std::string other = (folder_ / "other.svg").string();
    const std::string flap = folder_.write("flap.obj", test::kPanel).string();
    ASSERT_EQ(test::toileRun({"flatten", flap, "--unit", "cm", "-o", other}).status, 0);
    EXPECT_NE(refusal({"--pattern", other}, 3).find("other.svg: "), std::string::npos);
    EXPECT_NE(refusal({"--reference", "uv"}, 3).find("--reference"), std::string::npos);
    refusal({"--pattern", "a.svg", "--reference", "uv"}, 2);
    refusal({"--pattern-unit", "cm"}, 2);
    refusal({"--body-unit", "cm"}, 2);
    refusal({"--fabric", "granite"}, 2);
    refusal({"--stretch", "0"}, 2);
    refusal({"--report", "proof.txt"}, 2);
    refusal(
        {"--report", folder_.write("a.json", "").string(), "--body", (folder_ / "a.json").string()},
        2);
}

TEST_F(ProveCommand, WhereNoPieceLiesFlatItIsThePiecesThatFailed) {
    const std::string closed = folder_
                                   .write("closed.obj",
                                          "v 0 0 0\nv 90 0 0\nv 0 90 0\nv 0 0 90\n"
                                          "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
                                   .string();
    const std::string made = (folder_ / "made.svg").string();
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{"--json"},
          std::vector<std::string>{"--prove-improve", "-o", made}}) {
        std::vector<std::string> words{"prove", closed, "--unit", "mm"};
        words.insert(words.end(), more.begin(), more.end());
        const auto proof = test::toileRun(words);
        EXPECT_EQ(proof.status, 1) << proof.err;
        EXPECT_EQ(proof.out, "");
        EXPECT_NE(proof.err.find("Cut it open"), std::string::npos) << proof.err;
        EXPECT_NE(proof.err.find("no piece could be flattened"), std::string::npos) << proof.err;
    }
}

#ifdef TOILE_GUI
TEST_F(ProveCommand, DrawsWhereTheGapIs) {
    const std::string picture = (folder_ / "gap.png").string();
    const auto drawn = run("prove", {"-o", picture, "--size", "400x200"});
    if (drawn.err.find("OpenGL") != std::string::npos) {
        GTEST_SKIP() << drawn.err;
    }
    EXPECT_EQ(drawn.status, 0) << drawn.err;
    const std::string gap = folder_.read("gap.png");
    EXPECT_TRUE(gap.starts_with("\x89PNG"));
    EXPECT_EQ(run("prove", {"-o", picture, "--size", "400x200", "--sewn", "0"}).status, 0);
    EXPECT_NE(folder_.read("gap.png"), gap);
    EXPECT_EQ(run("prove", {"-o", "gap.svg"}).status, 2);
}
#endif

/// Ctrl-C as soon as the first word of the work is said.
class InterruptAtFirstWord : public std::stringbuf {
protected:
    std::streamsize xsputn(const char* text, std::streamsize count) override {
        if (!isRaised_) {
            isRaised_ = true;
            std::raise(SIGINT);
        }
        return std::stringbuf::xsputn(text, count);
    }

private:
    bool isRaised_ = false;
};

TEST_F(ProveCommand, AnInterruptEndsItAndIsSaid) {
    const std::string pattern = (folder_ / "better.dxf").string();
    const char* const words[] = {"toile",           "prove", barrel_.c_str(),
                                 "--unit",          "mm",    "--json",
                                 "--prove-improve", "-o",    pattern.c_str()};
    const auto arguments = app::parseArguments(std::size(words), words);
    ASSERT_TRUE(arguments) << arguments.refusal().message;
    const auto before = std::signal(SIGINT, SIG_IGN);  // it must not end the tests
    InterruptAtFirstWord said;
    std::ostream err(&said);
    std::ostringstream out;
    app::Messages messages(err);
    EXPECT_EQ(app::runProve(*arguments, out, messages), 3);
    EXPECT_EQ(std::signal(SIGINT, before), SIG_IGN);  // given back
    EXPECT_NE(said.str().find("cancelled"), std::string::npos) << said.str();
    EXPECT_EQ(out.str(), "");
    EXPECT_FALSE(std::filesystem::exists(pattern));
}

TEST_F(ProveCommand, SaysWhatHeldTheCloth) {
    const auto plain = run("prove");
    EXPECT_NE(plain.out.find("; on the design, 10 Pa; "), std::string::npos) << plain.out;
    const auto other =
        run("prove", {"--body", barrel_, "--body-unit", "mm", "--gravity", "--scale", "1.05",
                      "--pressure", "12.5", "--stretch", "900", "--self-contact",
                      "--cloth-thickness", "0.8", "--report", (folder_ / "proof.json").string()});
    EXPECT_NE(
        other.out.find("; on barrel.obj, 12.5 Pa, gravity, 0.8 mm between layers, scaled by 1.05, "
                       "own stiffness values; "),
        std::string::npos)
        << other.out << other.err;
    const auto held = nlohmann::json::parse(folder_.read("proof.json"))["held"];
    EXPECT_EQ(held["on"], "body");
    EXPECT_EQ(held["body"], "barrel.obj");
    EXPECT_EQ(held["pressure_pa"], 12.5);
    EXPECT_EQ(held["gravity"], true);
    EXPECT_EQ(held["self_contact_mm"], 0.8);
    EXPECT_EQ(held["scale"], 1.05);
    EXPECT_EQ(held["stiffness"]["weft"], 900);
    EXPECT_TRUE(held["stiffness"]["shear"].is_null());
}

TEST_F(ProveCommand, WhatWouldDoNothingIsRefused) {
    const auto refused = [this](const std::vector<std::string>& words) {
        const auto proof = run("prove", words);
        EXPECT_EQ(proof.status, 2) << proof.out;
        return proof.err;
    };
    const std::string dxf = (folder_ / "p.dxf").string();
    EXPECT_NE(refused({"--prove-improve"}).find("-o FILE"), std::string::npos);
    EXPECT_NE(refused({"-o", dxf}).find("--prove-improve"), std::string::npos);
    for (const std::vector<std::string>& words : {std::vector<std::string>{"--overlay", "gap"},
                                                  {"--size", "90x90"},
                                                  {"--sewn", "0"},
                                                  {"--dark"}}) {
        EXPECT_NE(refused(words).find(words.front() + " is of a picture"), std::string::npos);
    }
    const auto twice = refused({"--prove-improve", "-o", "p.json", "--report", "./p.json"});
    EXPECT_NE(twice.find("two names"), std::string::npos) << twice;
}

TEST_F(ProveCommand, CompareAddsAColumnWhereItIsAsked) {
    const auto compared = [this](std::vector<std::string> more) {
        more.insert(more.end(), {"--methods", "isometric,lscm"});
        return run("compare", more);
    };
    const auto table = compared({"--prove"});
    EXPECT_EQ(table.status, 0) << table.err;
    EXPECT_NE(table.out.find("sewn gap mm"), std::string::npos) << table.out;
    EXPECT_EQ(compared({}).out.find("sewn gap"), std::string::npos);
    const auto proven = nlohmann::json::parse(compared({"--prove", "--json"}).out);
    const auto plain = nlohmann::json::parse(compared({"--json"}).out);
    for (std::size_t m = 0; m < 2; ++m) {
        EXPECT_GT(proven["methods"][m]["sewn_gap_mm"], 0);
        EXPECT_GT(proven["methods"][m]["pieces"][0]["sewn_gap_mm"], 0);
        EXPECT_TRUE(plain["methods"][m]["sewn_gap_mm"].is_null());
    }
    EXPECT_EQ(compared({"--prove", "--pattern", "a.svg"}).status, 2);
}

}  // namespace
}  // namespace toile
