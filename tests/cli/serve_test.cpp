// SPDX-License-Identifier: GPL-3.0-or-later
// `toile serve`: requests by themselves.
#include <array>
#include <filesystem>
#include <tuple>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/assemble/cut_pieces.h"
#include "core/base/file.h"
#include "tests/cli/run_program.h"
#include "tests/cli/serve_support.h"
#include "tests/fuzz/check_serve.h"

namespace toile {
namespace {

constexpr const char* kCentreBack =
    R"({"version":1,"cuts":[{"name":"centre back","points":[[0,800,-144.9],[0,1459.8,-55.8]]}]})";

TEST(ServeRequests, LoadTellsWhatInfoTells) {
    Served served;
    auto told = served.done(loadOf({kServedShirt, "--unit", "mm"}));
    EXPECT_EQ(told["notes"], ServedJson::array());
    told.erase("notes");
    auto info =
        ServedJson::parse(test::toileRun({"info", kServedShirt, "--unit", "mm", "--json"}).out);
    info["files"][0]["seconds_read"] = told["files"][0]["seconds_read"] = 0;
    EXPECT_EQ(told, info);
}

TEST(ServeRequests, FlatPointsAndReportAreThoseOfTheCommand) {
    Served served;
    const test::TemporaryFolder folder;
    const std::vector<std::string> options{"--unit", "mm", "--method", "curvature"};
    std::vector<std::string> typed{kServedShirt};
    typed.insert(typed.end(), options.begin(), options.end());
    served.done(loadOf(typed));
    served.done({{"do", "flatten"}});
    auto report = served.done({{"do", "query"}, {"what", {"report", "sheet", "triangles"}}});
    const std::string out = (folder / "of_serve.obj").string();
    const auto wrote = served.done({{"do", "export"}, {"args", {"-o", out}}});
    EXPECT_EQ(wrote["files"][0]["path"], out);
    typed.insert(typed.begin(), "flatten");
    typed.insert(typed.end(), {"-o", (folder / "of_command.obj").string(), "--report",
                               (folder / "r.json").string()});
    EXPECT_EQ(test::toileRun(typed).status, 0);
    EXPECT_EQ(folder.read("of_serve.obj"), folder.read("of_command.obj"));
    auto ofCommand = ServedJson::parse(folder.read("r.json"));
    EXPECT_EQ(report["report"]["seams"], ofCommand["seams"]);
    std::size_t points = 0;
    for (const auto& piece : report["arrays"]) {
        points += piece["sheet"].size();
    }
    const std::string obj = folder.read("of_command.obj");
    std::size_t uvs = 0;
    for (std::size_t at = obj.find("\nvt "); at != std::string::npos;
         at = obj.find("\nvt ", at + 1)) {
        ++uvs;
    }
    EXPECT_EQ(points, uvs);
}

TEST(ServeRequests, AnEditOfCutsKeepsTheOptionsAndSolvesOnlyWhatChanged) {
    Served served;
    served.done(loadOf({kServedShirt, "--unit", "mm", "--method", "curvature"}));
    served.done({{"do", "flatten"}});
    const auto told = served.done({{"do", "edit"}, {"seams", ServedJson::parse(kCentreBack)}});
    EXPECT_EQ(told["cuts"].size(), 1U);
    const std::size_t cutPieces = told["pieces"].size();
    const auto flat = served.done({{"do", "flatten"}});
    EXPECT_EQ(flat["pieces"].size(), cutPieces);
    const auto report = served.done({{"do", "query"}, {"what", {"pieces"}}});
    for (const auto& piece : report["pieces"]) {
        EXPECT_EQ(piece["method"], "curvature");
    }
    // Undone by saying what was said before.
    const auto undone =
        served.done({{"do", "edit"}, {"seams", {{"version", 1}, {"cuts", ServedJson::array()}}}});
    EXPECT_EQ(undone["cuts"].size(), 0U);
    EXPECT_EQ(undone["pieces"].size(), 5U);
}

TEST(ServeRequests, SettledResultsAreThoseOfAFreshSession) {
    const ServedJson query{{"do", "query"}, {"what", {"flat"}}};
    Served edited, fresh;
    edited.done(loadOf({kServedShirt, "--unit", "mm"}));
    edited.done({{"do", "flatten"}});
    edited.done({{"do", "edit"}, {"seams", ServedJson::parse(kCentreBack)}});
    const auto settled = edited.done({{"do", "flatten"}, {"settle", true}});
    for (const auto& piece : settled["pieces"]) {
        EXPECT_EQ(piece["settled"], true);
    }
    auto load = loadOf({kServedShirt, "--unit", "mm"});
    load["seams"] = ServedJson::parse(kCentreBack);
    fresh.done(load);
    fresh.done({{"do", "flatten"}});
    EXPECT_EQ(edited.done(query), fresh.done(query));
}

TEST(ServeRequests, WhatIsNotFlatIsNeitherWrittenNorSewn) {
    Served served;
    const test::TemporaryFolder folder;
    served.done(loadOf({folder.write("ball.obj", test::kBall).string(), "--unit", "mm"}));
    const auto file = folder.path() / "ball.svg";
    EXPECT_EQ(served.refused({{"do", "export"}, {"args", {"-o", file.string()}}})["code"],
              "not-flat");
    EXPECT_FALSE(std::filesystem::exists(file));
    const auto report = folder.path() / "ball.json";  // which says why
    served.done({{"do", "export"}, {"args", {"-o", report.string()}}});
    EXPECT_TRUE(std::filesystem::exists(report));
    EXPECT_EQ(served.refused({{"do", "prove"}})["code"], "not-flat");
}

TEST(ServeRequests, NobodyWaitsForWhoReadsAPipe) {
    Served served;
    const test::TemporaryFolder folder;
    served.done(loadOf({folder.write("flap.obj", test::kPanel).string(), "--unit", "mm"}));
    const auto pipe = folder.path() / "flap.svg";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(served.refused({{"do", "export"}, {"args", {"-o", pipe.string()}}})["code"],
              "file-unwritable");
}

TEST(ServeRequests, FaultsOfProjectsHaveTheirCodeAndSubject) {
    Served served;
    const test::TemporaryFolder folder;
    const auto refused = [&](const std::string& project) {
        return served.refused(loadOf({folder.write("shirt.toile", project).string()}));
    };
    const auto newer =
        refused(R"({"format": "toile-project", "version": 2147483647, "files": []})");
    EXPECT_EQ(newer["code"], "newer-project");
    EXPECT_EQ(newer["subject"], "shirt.toile");
    const auto gone =
        refused(R"({"format": "toile-project", "version": 1, "files": [{"path": "gone.obj"}]})");
    EXPECT_EQ(gone["code"], "file-unreadable");
    EXPECT_NE(gone["subject"].get<std::string>().find("gone.obj"), std::string::npos);
}

TEST(ServeRequests, RefusalsNameCodeAndSentenceAndLeaveTheGarment) {
    Served served;
    const test::TemporaryFolder folder;
    EXPECT_EQ(served.refused({{"do", "flatten"}})["code"], "no-garment");
    EXPECT_EQ(served.refused(loadOf({"nowhere.obj"}))["code"], "file-unreadable");
    EXPECT_EQ(served.refused(loadOf({}))["code"], "wrong-usage");
    const std::string flap = folder.write("flap.obj", test::kPanel).string();
    served.done(loadOf({flap, "--unit", "mm"}));
    const auto wrong = served.refused({{"do", "edit"}, {"args", {"--method", "lcsm"}}});
    EXPECT_EQ(wrong["code"], "wrong-usage");
    const auto typed = test::toileRun({"flatten", flap, "--method", "lcsm"});
    EXPECT_EQ("toile: " + wrong["message"].get<std::string>() + "; see toile flatten --help.\n",
              typed.err);
    EXPECT_EQ(served.refused({{"do", "edit"}, {"args", {"other.obj"}}})["code"], "wrong-usage");
    EXPECT_EQ(served.refused({{"do", "edit"}, {"args", {"-o", "a.svg"}}})["code"], "wrong-usage");
    EXPECT_EQ(served.refused({{"do", "edit"}, {"seams", {{"version", 9}}}})["code"],
              "malformed-file");
    EXPECT_EQ(served.refused({{"do", "query"}, {"what", {"flat"}}})["code"], "not-flat");
    EXPECT_EQ(served.refused({{"do", "query"}, {"what", {"weather"}}})["code"], "unknown-word");
    const auto noPiece =
        served.refused({{"do", "query"}, {"what", {"vertices"}}, {"pieces", {"hood"}}});
    EXPECT_EQ(noPiece["code"], "no-such-piece");
    EXPECT_EQ(noPiece["subject"], "hood");
    EXPECT_EQ(served.refused({{"do", "export"}, {"args", ServedJson::array()}})["code"],
              "wrong-usage");
    EXPECT_EQ(served.refused({{"do", "export"}, {"args", {"-o", "a.svg", "--weld"}}})["code"],
              "wrong-usage");
    EXPECT_EQ(served.refused({{"do", "export"}, {"args", {"-o", "a.svg", "--ledger"}}})["code"],
              "wrong-usage");
    EXPECT_EQ(served.refused({{"do", "edit"}, {"args", {"--fail-on", "doubt"}}})["code"],
              "wrong-usage");
    EXPECT_EQ(served.refused({{"do", "prove"}, {"args", {"--report", "a.json"}}})["code"],
              "wrong-usage");
    EXPECT_EQ(
        served.done({{"do", "query"}, {"what", {"vertices"}}})["arrays"]["flap"]["vertices"].size(),
        4U);
    served.done({{"do", "close"}});
    EXPECT_EQ(served.refused({{"do", "flatten"}})["code"], "no-garment");
}

TEST(ServeRequests, ProveTellsTheReportOfAProof) {
    Served served;
    const test::TemporaryFolder folder;
    served.done(loadOf({folder.write("flap.obj", test::kPanel).string(), "--unit", "mm"}));
    const auto proof = served.done({{"do", "prove"}});
    EXPECT_LT(proof["gap_mm"]["mean"].get<double>(), 0.1);
    const auto noBody = served.refused({{"do", "prove"}, {"args", {"--body", "nowhere.obj"}}});
    EXPECT_EQ(noBody["code"], "file-unreadable");
    EXPECT_EQ(noBody["subject"], "nowhere.obj");
    const auto noPanels = served.refused({{"do", "prove"}, {"args", {"--reference", "uv"}}});
    EXPECT_EQ(noPanels["code"], "not-proved");
    const std::string body = folder.write("far.obj", "v 9e6 0 0\nv 9e6 9 0\nv 9e6 0 9\nf 1 2 3\n");
    const auto farBody = served.refused({{"do", "prove"}, {"args", {"--body", body}}});
    EXPECT_EQ(farBody["code"], "not-proved");
    EXPECT_EQ(farBody["subject"], body);
}

TEST(ServeRequests, ProveTellsWhatThePatternsReaderLeftOut) {
    Served served;
    const test::TemporaryFolder folder;
    served.done(loadOf({folder.write("flap.obj", test::kPanel).string(), "--unit", "mm"}));
    const std::string path = (folder / "flap.dxf").string();
    served.done({{"do", "export"}, {"args", {"-o", path}}});
    const ServedJson prove = {{"do", "prove"}, {"args", {"--pattern", path}}};
    EXPECT_EQ(served.done(prove)["notes"], ServedJson::array());
    std::string dxf = folder.read("flap.dxf");
    dxf.insert(dxf.rfind('0', dxf.rfind("ENDSEC")), "0\nIMAGE\n340\n1A\n");
    folder.write("flap.dxf", dxf);
    const auto notes = served.done(prove)["notes"];
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].get<std::string>().find("1 IMAGE"), std::string::npos) << notes;
}

TEST(ServeRequests, ProveGoesByWhatAProjectSays) {
    Served served;
    const test::TemporaryFolder folder;
    folder.write("flap.obj", test::kPanel);
    const auto project = folder.write(
        "flap.toile", R"({"format": "toile-project", "version": 3, "files": [{"path": "flap.obj"}],
                          "reading": {"unit": "mm"}, "proof": {"pressure": 25}})");
    served.done(loadOf({project.string()}));
    EXPECT_EQ(served.done({{"do", "prove"}})["held"]["pressure_pa"], 25);
    EXPECT_EQ(served.done({{"do", "prove"}, {"args", {"--pressure", "3"}}})["held"]["pressure_pa"],
              3);
}

TEST(ServeRequests, NobodyWaitsForAPipe) {
    const test::TemporaryFolder folder;
    const std::string panel = folder.write("flap.obj", test::kPanel).string();
    std::vector<std::string> pipes;
    for (const char* name : {"pipe.obj", "pipe.toile", "pipe.json", "pipe.dxf"}) {
        pipes.push_back((folder / name).string());
        ASSERT_EQ(mkfifo(pipes.back().c_str(), 0600), 0);
    }
    Served served;
    served.done(loadOf({panel, "--unit", "mm"}));
    for (const ServedJson& asked :
         {loadOf({pipes[0]}), loadOf({panel, pipes[0]}), loadOf({pipes[1]}),
          loadOf({panel, "--seams", pipes[2]}),
          ServedJson{{"do", "edit"}, {"args", {"--seams", pipes[2]}}},
          ServedJson{{"do", "prove"}, {"args", {"--body", pipes[0]}}},
          ServedJson{{"do", "prove"}, {"args", {"--pattern", pipes[3]}}}}) {
        const auto why = served.refused(asked);
        EXPECT_EQ(why["code"], "file-unreadable") << asked.dump();
        EXPECT_NE(why["subject"].get<std::string>().find("pipe."), std::string::npos);
    }
}

TEST(ServeRequests, WhatIsWorthAnotherTrySaysSo) {
    Served served;
    EXPECT_EQ(served.refused(loadOf({"nowhere.obj"}))["again"], true);
    EXPECT_EQ(served.refused(loadOf({"a.obj", "--no-such-option"}))["again"], false);
    EXPECT_EQ(served.refused({{"do", "flatten"}})["again"], false);
}

/// How many places are told beside this sentence; each stands in it, in this order.
std::size_t checkPlaces(const ServedJson& said, const std::array<double, 3>& first) {
    const auto message = said.at("message").get<std::string>();
    const auto places = said.value("places", ServedJson::array());
    std::size_t from = 0;
    for (const ServedJson& place : places) {
        const auto words = place.at("words").get<std::string>();
        from = message.find(words, from);
        EXPECT_NE(from, std::string::npos) << words << " in " << message;
        EXPECT_EQ(place.at("at").size(), 3U);
    }
    for (std::size_t k = 0; k < 3 && !places.empty(); ++k) {
        EXPECT_NEAR(places[0]["at"][k].get<double>(), first[k], 1e-9) << message;
    }
    return places.size();
}

TEST(ServeRequests, PlacesOfSentencesStandBesideThemAsNumbers) {
    Served served;
    const test::TemporaryFolder folder;
    // One triangle twice, in centimetres with z up.
    const auto twice = folder.write("twice.obj",
                                    "v 0 0 0\nv 10.123 -4 2\nv 10 0 10\nv 0 0 10\nv 20 0 0\n"
                                    "f 1 2 3 4\nf 2 5 3\nf 2 5 3\n");
    const std::vector<std::string> words{twice.string(), "--unit", "cm", "--up", "z"};
    const std::array<double, 3> there{101.23, 20, 40};
    std::vector<std::string> strict = words;
    strict.emplace_back("--strict");
    served.done(loadOf(strict));
    const auto flat = served.done({{"do", "flatten"}});
    EXPECT_EQ(checkPlaces(flat["pieces"][0]["error"], there), 1U);
    const auto loaded = served.done(loadOf(words));
    std::size_t told = 0;
    for (const ServedJson& problem : loaded["files"][0]["problems"]) {
        told += checkPlaces(problem, there);
    }
    EXPECT_EQ(told, 1U) << loaded["files"];
    // What tells no place has none.
    EXPECT_FALSE(served.refused(loadOf({"nowhere.obj"})).contains("places"));
}

TEST(ServeRequests, EachTakesTheOptionsThatItAsksFor) {
    Served served;
    const test::TemporaryFolder folder;
    const std::string panel = folder.write("flap.obj", test::kPanel).string();
    served.done(loadOf({panel, "--unit", "mm"}));
    const std::string svg = (folder / "a.svg").string();
    for (const auto& [what, words, option] :
         std::vector<std::tuple<std::string, std::vector<std::string>, std::string>>{
             {"load", {panel, "--paper", "a4"}, "--paper"},
             {"load", {panel, "--threads", "2"}, "--threads"},
             {"load", {panel, "--help"}, "--help"},
             {"edit", {"--report", "a.json"}, "--report"},
             {"edit", {"--ledger"}, "--ledger"},
             {"export", {"-o", svg, "--weld"}, "--weld"},
             {"export", {"-o", svg, "--pattern"}, "--pattern"},
             {"export", {"-o", svg, panel}, panel},
             {"prove", {"--fair", "1"}, "--fair"},
             {"prove", {"-o", "a.png"}, "--output"},
             {"prove", {"--view", "both"}, "--view"},
             {"prove", {"--prove-improve"}, "--prove-improve"}}) {
        const auto why = served.refused({{"do", what}, {"args", words}});
        EXPECT_EQ(why["code"], "wrong-usage") << what;
        const auto message = why["message"].get<std::string>();
        EXPECT_NE(message.find(option), std::string::npos) << message;
        EXPECT_NE(message.find("leave it out"), std::string::npos) << message;
        EXPECT_EQ(message.find("--help;"), std::string::npos) << message;
    }
    served.done({{"do", "export"}, {"args", {"-o", svg, "--paper", "a4"}}});
}

TEST(ServeRequests, WhatFailsLeavesTheGarmentAsFlatAsItWas) {
    Served served;
    const test::TemporaryFolder folder;
    served.done(loadOf({folder.write("flap.obj", test::kPanel).string(), "--unit", "mm"}));
    const ServedJson sheet{{"do", "query"}, {"what", {"sheet"}}};
    const std::string nowhere = (folder / "no" / "a.svg").string();
    EXPECT_EQ(served.refused({{"do", "export"}, {"args", {"-o", nowhere}}})["code"],
              "file-unwritable");
    EXPECT_EQ(served.refused(sheet)["code"], "not-flat");
    served.refused({{"do", "prove"}, {"args", {"--body", "nowhere.obj"}}});
    EXPECT_EQ(served.refused(sheet)["code"], "not-flat");
    served.done({{"do", "export"}, {"args", {"-o", (folder / "a.svg").string()}}});
    served.done(sheet);
}

TEST(ServeRequests, AFileThatBeginsWithADashIsEditedProvedAndExported) {
    const test::TemporaryFolder folder;
    folder.write("-flap.obj", test::kPanel);
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder / "");
    Served served;
    served.done(loadOf({"--unit", "mm", "--", "-flap.obj"}));
    for (int twice = 0; twice < 2; ++twice) {
        served.done({{"do", "edit"}, {"args", {"--unit", "cm"}}});
        served.done({{"do", "export"}, {"args", {"-o", "a.svg"}}});
    }
    served.done({{"do", "prove"}});
    EXPECT_EQ(served.refused({{"do", "edit"}, {"args", {"other.obj"}}})["code"], "wrong-usage");
    std::filesystem::current_path(before);
}

TEST(ServeRequests, WhatIsNoRequestIsAFaultAndNoEnd) {
    for (const std::string line :
         {"", "{", "[]", "7", "\"load\"", "{}", R"({"id":1})", R"({"id":1.5,"do":"flatten"})",
          R"({"id":null,"do":"flatten"})", R"({"id":1,"do":"dance"})", R"({"id":1,"do":7})",
          R"({"id":1,"do":"flatten","colour":"red"})", R"({"id":1,"do":"load","args":"a.obj"})",
          R"({"id":1,"do":"load","args":[1]})", R"({"id":1,"do":"load","args":["a\u0000b"]})",
          R"({"id":1,"do":"query"})", R"({"id":1,"do":"cancel"})", "\xff\xfe", "{\"id\":1e999}"}) {
        const auto request = app::readServeRequest(line);
        ASSERT_TRUE(request.refusal) << line;
        EXPECT_EQ(request.refusal->code, "wrong-request") << line;
        EXPECT_NE(request.refusal->message, "") << line;
    }
    EXPECT_TRUE(app::readServeRequest(std::string(1000000, '[')).refusal);
    EXPECT_TRUE(
        app::readServeRequest(R"({"id":")" + std::string(101, 'x') + R"(","do":"close"})").refusal);
    EXPECT_EQ(app::readServeRequest(R"({"id":5,"do":"dance"})").id, "5");
}

TEST(ServeFuzzSeeds, BreakNoPromise) {
    int seeds = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(kServeSources + "/tests/fuzz/seeds/serve")) {
        const auto bytes = readFile(entry.path());
        EXPECT_EQ(fuzz::whatBreaksInServe(bytes ? *bytes : ""), "") << entry.path().filename();
        ++seeds;
    }
    EXPECT_GE(seeds, 10);
}

TEST(ServeRequests, WhatIsCancelledSaysSoAndLeavesTheGarment) {
    Served served;
    const test::TemporaryFolder folder;
    const std::string flap = folder.write("flap.obj", test::kPanel).string();
    served.done(loadOf({flap, "--unit", "mm"}));
    const ServedJson tell{{"do", "query"}, {"what", {"vertices", "report"}}};
    const auto before = served.done(tell);
    for (const ServedJson& asked :
         {loadOf({kServedShirt}), ServedJson{{"do", "edit"}, {"args", {"--unit", "m"}}},
          ServedJson{{"do", "flatten"}}, ServedJson{{"do", "prove"}}}) {
        Progress progress;
        progress.cancel();
        ServedJson request = asked;
        request["id"] = 1;
        const auto answer = ServedJson::parse(
            served.session.answer(app::readServeRequest(request.dump()), progress));
        EXPECT_EQ(answer["error"]["code"], "cancelled") << asked.dump();
    }
    EXPECT_EQ(served.done(tell), before);
}

}  // namespace
}  // namespace toile
