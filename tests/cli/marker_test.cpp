// SPDX-License-Identifier: GPL-3.0-or-later
// `toile marker`, with the built program.
#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/project/project_file.h"
#include "tests/cli/run_program.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

const char* const kNested = R"({"name": "halves", "strip_height": 30, "items": [
    {"id": 0, "demand": 4, "allowed_orientations": [0, 180],
     "shape": {"type": "simple_polygon", "data": [[0, 0], [40, 0], [0, 30]]}}]})";

TEST(MarkerCommand, NestsAnInstanceAndReportsIt) {
    const test::TemporaryFolder folder;
    const auto file = folder.write("halves.json", kNested);
    const auto nest = [&](const std::string& threads) {
        const auto report = folder / ("report" + threads + ".json");
        const auto picture = folder / ("nest" + threads + ".svg");
        const auto run =
            test::toileRun({"marker", file.string(), "--rounds", "3", "--threads", threads,
                            "--report", report.string(), "-o", picture.string()});
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_NE(run.out.find("3 rounds"), std::string::npos) << run.out;
        return *readFile(report) + *readFile(picture);
    };
    const std::string written = nest("1");
    EXPECT_EQ(nest("2"), written);
    const auto json = nlohmann::json::parse(*readFile(folder / "report1.json"));
    EXPECT_GT(json["use"].get<double>(), 0.9);
    EXPECT_EQ(json["rounds"], 3);
    EXPECT_EQ(json["placements"].size(), 4U);
    EXPECT_NE(written.find("<svg"), std::string::npos);
}

TEST(MarkerCommand, SaysWhatIsWrong) {
    const test::TemporaryFolder folder;
    const auto file = folder.write("halves.json", kNested);
    const auto wide = test::toileRun({"marker", file.string(), "--border", "1", "--rounds", "1"});
    EXPECT_EQ(wide.status, 3);
    EXPECT_NE(wide.err.find("does not fit"), std::string::npos) << wide.err;
    EXPECT_EQ(test::toileRun({"marker", (folder / "none.obj").string()}).status, 3);
    EXPECT_EQ(test::toileRun({"marker", (folder / "none.json").string()}).status, 3);
}

/// Of one of our samples, with allowances; a few rounds, so that it is the same everywhere.
test::ProgramRun layShirt(std::vector<std::string> more) {
    std::vector<std::string> words{"marker",
                                   test::sourceFile("resources/samples/tshirt.obj").string(),
                                   "--pattern", "--rounds", "2"};
    words.insert(words.end(), more.begin(), more.end());
    return test::toileRun(words);
}

nlohmann::json reportOf(const std::filesystem::path& file) {
    return nlohmann::json::parse(*readFile(file));
}

TEST(MarkerCommand, LaysAGarmentAndReadsItsFilesBack) {
    const test::TemporaryFolder folder;
    std::vector<std::string> words{"--report", (folder / "m.json").string(), "--minutes-per-metre",
                                   "2"};
    for (const char* name : {"m.svg", "m.dxf", "m.plt", "m.pdf"}) {
        words.insert(words.end(), {"-o", (folder / name).string()});
    }
    const auto run = layShirt(words);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("Garment's fabric: 1400 mm wide"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("min to sew"), std::string::npos) << run.out;
    std::size_t readBack = 0;
    for (std::size_t at = 0; (at = run.out.find("read back: 5 pieces", at)) != std::string::npos;) {
        ++readBack;
        ++at;
    }
    EXPECT_EQ(readBack, 2U) << run.out;
    const auto json = reportOf(folder / "m.json");
    EXPECT_GT(json["use"].get<double>(), 0.5);
    EXPECT_LE(json["rounds"].get<int>(), 2);
    const auto& marker = json["markers"][0];
    EXPECT_EQ(marker["copies"].size(), 5U);
    EXPECT_EQ(marker["width"], 1400);
    EXPECT_NEAR(marker["minutes"].get<double>(), 2 * marker["seam_metres"].get<double>(), 1e-9);
    EXPECT_NE(readFile(folder / "m.svg")->find("cloth-1"), std::string::npos);
}

TEST(MarkerCommand, FollowsTheRulesOfTheCloth) {
    const test::TemporaryFolder folder;
    const auto lay = [&](const std::vector<std::string>& words) {
        std::vector<std::string> all{"--report", (folder / "m.json").string()};
        all.insert(all.end(), words.begin(), words.end());
        const auto run = layShirt(all);
        EXPECT_EQ(run.status, 0) << run.err;
        return reportOf(folder / "m.json");
    };
    const auto flat = lay({"--garments", "2", "--one-way", "--gap", "2", "--border", "10"});
    EXPECT_EQ(flat["markers"][0]["copies"].size(), 10U);
    EXPECT_EQ(flat["markers"][0]["garments"], 2);
    EXPECT_EQ(lay({"--nap", "--garments", "2", "--gap", "2", "--border", "10"}), flat);
    const auto folded = lay({"--folded", "--mirror", "auto"});
    EXPECT_EQ(folded["markers"][0]["width"], 700);
    EXPECT_EQ(folded["markers"][0]["pieces"], 5);
    EXPECT_LT(folded["markers"][0]["copies"].size(), 5U);
    const auto sheets = lay({"--sheet", "900x700"});
    EXPECT_GE(sheets["markers"][0]["sheets"].get<int>(), 2);
    EXPECT_EQ(lay({"--free-grain", "--turn", "10", "--width", "1500", "--threads", "1"}),
              lay({"--free-grain", "--turn", "10", "--width", "1500", "--threads", "2"}));
    EXPECT_EQ(lay({"--fabric", "jersey"})["markers"][0]["width"], 1600);
}

TEST(MarkerCommand, FollowsWhatAProjectSays) {
    const test::TemporaryFolder folder;
    Project project;
    project.files = {{test::sourceFile("resources/samples/tshirt.obj")}};
    project.loading.unit = LengthUnit::Millimetre;
    MarkerPlan& plan = project.markers[""];
    plan.settings.gap = 3;
    plan.settings.garments = 2;
    Progress progress;
    const auto garment = loadGarment({project.files[0].path}, project.loading, progress);
    ASSERT_TRUE(garment);
    KeptCopy& kept = plan.kept.emplace_back();
    kept.copy.piece = garment->pieces.front()->id;
    kept.placement.offset = {5000, 700};  // far from where the others end
    ASSERT_TRUE(writeProject(folder / "shirt.toile", project));
    const auto lay = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"marker",   (folder / "shirt.toile").string(),
                                       "--rounds", "1",
                                       "--report", (folder / "m.json").string()};
        words.insert(words.end(), more.begin(), more.end());
        const auto run = test::toileRun(words);
        EXPECT_EQ(run.status, 0) << run.err;
        return reportOf(folder / "m.json")["markers"][0];
    };
    const auto saved = lay({});
    EXPECT_EQ(saved["gap"], 3);
    EXPECT_EQ(saved["copies"].size(), 10U);
    const auto copy = std::ranges::find_if(
        saved["copies"], [](const auto& one) { return one["kept"].template get<bool>(); });
    ASSERT_NE(copy, saved["copies"].end());
    EXPECT_EQ((*copy)["x"], 5000);
    EXPECT_EQ((*copy)["y"], 700);
    const auto typed = lay({"--gap", "0", "--width", "1600"});
    EXPECT_EQ(typed["gap"], 0);
    EXPECT_EQ(typed["width"], 1600);
    EXPECT_EQ(typed["garments"], 2);
}

TEST(MarkerCommand, LaysOnHides) {
    const test::TemporaryFolder folder;
    const auto hide = folder.write(
        "hide.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' width='2000mm' height='1600mm' "
        "viewBox='0 0 2000 1600'><g id='edge'><path d='M0 100L1900 0L2000 1500L100 1600Z'/></g>"
        "<g id='grade 3'><rect x='1500' y='200' width='300' height='900'/></g>"
        "<g id='hole'><circle cx='300' cy='300' r='40'/></g></svg>");
    const auto run = layShirt({"--hide", hide.string(), "--grade", "front=2", "--report",
                               (folder / "m.json").string(), "-o", (folder / "m.svg").string()});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("Garment's fabric: 1 hide, "), std::string::npos) << run.out;
    EXPECT_NE(readFile(folder / "m.svg")->find("cloth-1-zone-2"), std::string::npos);
    EXPECT_EQ(layShirt({"--hide", (folder / "none.svg").string()}).status, 3);
}

TEST(MarkerCommand, NamesWhatItCannotLay) {
    const auto run = layShirt({"--width", "500", "--repeat", "80x60@5,5", "--match", "nothing"});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("front is not placed: it is"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("splice it at 490 mm"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("is called nothing"), std::string::npos);
}

TEST(MarkerCommand, RefusesWhatDoesNotGoTogether) {
    const test::TemporaryFolder folder;
    const auto shapes = folder.write("halves.json", kNested).string();
    const std::string garment = test::sourceFile("resources/samples/tshirt.obj").string();
    const std::pair<std::vector<std::string>, const char*> kRefused[] = {
        {{shapes, "--width", "900"}, "--width: works only with a garment"},
        {{shapes, "--hide", "h.svg"}, "--hide: works only with a garment"},
        {{shapes, garment}, "only input"},
        {{shapes, "-o", "nest.pdf"}, "must be .svg"},
        {{garment, "-o", "m.obj"}, "markers do not support"},
        {{garment, "-o", "m.json"}, "markers do not support"},
        {{garment, "--report", "m.txt"}, "must end in .json"},
        {{garment, "--sheet", "305"}, "--sheet: needs"},
        {{garment, "--sheet", "0x610"}, "--sheet: needs"},
        {{garment, "--width", "900", "--sheet", "305x610"}, "use one of them"},
        {{garment, "--folded", "--sheet", "305x610"}, "--folded needs a roll"},
        {{garment, "--repeat", "80"}, "--repeat: needs"},
        {{garment, "--repeat", "80x60@5"}, "--repeat: needs"},
        {{garment, "--repeat", "80x60@5,1e9"}, "--repeat: needs"},
        {{garment, "--grade", "front=2abc"}, "--grade: needs"},
        {{garment, "--match", "side"}, "add --repeat"},
        {{garment, "--grade", "front"}, "--grade: needs"},
        {{garment, "--grade", "front=2"}, "--grade needs --hide"},
        {{garment, "--one-way", "--free-grain"}, "excludes"},
        {{garment, "--turn", "200"}, "200"},
        {{garment, "--garments", "0"}, "0"},
        {{garment, "--material", "silk", "--rounds", "0"}, "no piece is cut from \"silk\""}};
    for (const auto& [words, said] : kRefused) {
        std::vector<std::string> all{"marker"};
        all.insert(all.end(), words.begin(), words.end());
        const auto run = test::toileRun(all);
        EXPECT_EQ(run.status, 2) << words.back();
        EXPECT_NE(run.err.find(said), std::string::npos) << words.back() << ": " << run.err;
    }
}

}  // namespace
}  // namespace toile
