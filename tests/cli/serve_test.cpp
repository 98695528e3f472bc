// SPDX-License-Identifier: GPL-3.0-or-later
// `toile serve`: requests by themselves, several at once, and the built program.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <future>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/cli/serve_command.h"
#include "app/cli/serve_session.h"
#include "core/base/file.h"
#include "tests/cli/run_program.h"
#include "tests/fuzz/check_serve.h"

namespace toile {
namespace {

using ServedJson = nlohmann::json;

const std::string kSources = TOILE_SOURCE_DIR;
const std::string kServedShirt = kSources + "/resources/samples/tshirt.obj";
constexpr const char* kCentreBack =
    R"({"version":1,"cuts":[{"name":"centre back","points":[[0,800,-144.9],[0,1459.8,-55.8]]}]})";

/// A garment and who asks for it.
struct Served {
    app::ServeSession session;

    ServedJson said(const ServedJson& request) {
        Progress progress;
        return ServedJson::parse(session.answer(app::readServeRequest(request.dump()), progress));
    }

    ServedJson done(const ServedJson& request) {
        ServedJson asked = request;
        asked["id"] = 1;
        const ServedJson answer = said(asked);
        EXPECT_TRUE(answer.contains("result")) << answer.dump().substr(0, 2000);
        return answer.value("result", ServedJson());
    }

    ServedJson refused(const ServedJson& request) {
        ServedJson asked = request;
        asked["id"] = 1;
        return said(asked).value("error", ServedJson{{"code", "none"}});
    }
};

ServedJson loadOf(const std::vector<std::string>& args) {
    return {{"do", "load"}, {"args", args}};
}

std::vector<ServedJson> linesOf(const std::string& text) {
    std::vector<ServedJson> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        lines.push_back(ServedJson::parse(line));
    }
    return lines;
}

/// The answers without what is said on the way to them.
std::vector<ServedJson> answersOf(const std::string& text) {
    auto lines = linesOf(text);
    std::erase_if(lines, [](const ServedJson& line) { return line.contains("progress"); });
    return lines;
}

/// Where `part` says something that `whole` does not; of lists their beginnings are compared.
std::string differenceOf(const ServedJson& part, const ServedJson& whole) {
    if (part.is_object()) {
        for (const auto& item : part.items()) {
            if (!whole.is_object() || !whole.contains(item.key())) {
                return item.key() + " is missing";
            }
            if (const auto inner = differenceOf(item.value(), whole[item.key()]); !inner.empty()) {
                return item.key() + ": " + inner;
            }
        }
        return "";
    }
    if (part.is_array()) {
        for (std::size_t i = 0; i < part.size(); ++i) {
            const ServedJson missing;
            const ServedJson& there = i < whole.size() ? whole[i] : missing;
            if (const auto inner = differenceOf(part[i], there); !inner.empty()) {
                return "[" + std::to_string(i) + "] " + inner;
            }
        }
        return "";
    }
    const bool isEqual = part.is_number() && whole.is_number()
                             ? std::abs(part.get<double>() - whole.get<double>()) < 1e-6
                             : part == whole;
    return isEqual ? "" : whole.dump() + " in place of " + part.dump();
}

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
    EXPECT_EQ("toile: " + wrong["message"].get<std::string>() + "; see toile --help.\n", typed.err);
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
        ASSERT_TRUE(request.fault) << line;
        EXPECT_EQ(request.fault->code, "wrong-request") << line;
        EXPECT_NE(request.fault->message, "") << line;
    }
    EXPECT_TRUE(app::readServeRequest(std::string(1000000, '[')).fault);
    EXPECT_TRUE(
        app::readServeRequest(R"({"id":")" + std::string(101, 'x') + R"(","do":"close"})").fault);
    EXPECT_EQ(app::readServeRequest(R"({"id":5,"do":"dance"})").id, "5");
}

TEST(ServeFuzzSeeds, BreakNoPromise) {
    int seeds = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(kSources + "/tests/fuzz/seeds/serve")) {
        const auto bytes = readFile(entry.path());
        EXPECT_EQ(fuzz::whatBreaksInServe(bytes ? *bytes : ""), "") << entry.path().filename();
        ++seeds;
    }
    EXPECT_GE(seeds, 10);
}

TEST(ServeLines, EachGetsOneAnswerInOrder) {
    std::string asked;
    for (int i = 0; i < 200; ++i) {
        asked += ServedJson{{"id", i}, {"do", i % 2 ? "close" : "flatten"}}.dump() + "\n";
    }
    asked += "no JSON\n" + std::string(app::kMostServeLine + 1, 'x') + "\n\n";
    asked += R"({"id":"last","do":"close"})";  // without an end
    std::istringstream in(asked);
    std::ostringstream out;
    EXPECT_EQ(app::runServe(in, out), 0);
    const auto answers = answersOf(out.str());
    ASSERT_EQ(answers.size(), 204U);
    for (int i = 0; i < 200; ++i) {
        EXPECT_EQ(answers[static_cast<std::size_t>(i)]["id"], i);
    }
    EXPECT_TRUE(answers[201]["id"].is_null());
    EXPECT_NE(answers[201]["error"]["message"].get<std::string>().find("16 MiB"),
              std::string::npos);
    EXPECT_EQ(answers[203]["id"], "last");
}

TEST(ServeLines, NothingIsReadAfterQuit) {
    std::istringstream in("{\"id\":1,\"do\":\"quit\"}\n{\"id\":2,\"do\":\"close\"}\n");
    std::ostringstream out;
    app::runServe(in, out);
    EXPECT_EQ(answersOf(out.str()).size(), 1U);
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

/// Lines of which the last come only when something has been said.
class PromptedLines : public std::streambuf {
public:
    PromptedLines(std::string first, std::string last)
        : first_(std::move(first)), last_(std::move(last)) {
        setg(first_.data(), first_.data(), first_.data() + first_.size());
    }
    void prompt() { isPrompted_.set_value(); }

protected:
    int_type underflow() override {
        if (eback() == last_.data()) {
            return traits_type::eof();
        }
        isPrompted_.get_future().wait();
        setg(last_.data(), last_.data(), last_.data() + last_.size());
        return traits_type::to_int_type(*gptr());
    }

private:
    std::string first_, last_;
    std::promise<void> isPrompted_;
};

/// Keeps what is said, and prompts at the first of it.
class PromptingText : public std::stringbuf {
public:
    explicit PromptingText(PromptedLines& lines) : lines_(lines) {}

protected:
    int sync() override {
        if (!hasPrompted_) {
            hasPrompted_ = true;
            lines_.prompt();
        }
        return std::stringbuf::sync();
    }

private:
    PromptedLines& lines_;
    bool hasPrompted_ = false;
};

TEST(ServeLines, WhatRunsIsCancelled) {
    // A proof of so fine a mesh takes long; it is stopped when the garment has been read.
    const test::TemporaryFolder folder;
    const std::string panel = folder.write("panel.obj", test::kPanel).string();
    const std::string load =
        ServedJson({{"id", 1}, {"do", "load"}, {"args", {panel, "--unit", "cm"}}}).dump();
    PromptedLines lines(
        load + "\n{\"id\":2,\"do\":\"prove\",\"args\":[\"--edge\",\"20\"]}\n",
        "{\"id\":3,\"do\":\"cancel\",\"of\":2}\n{\"id\":4,\"do\":\"cancel\",\"of\":99}\n"
        "{\"id\":5,\"do\":\"query\",\"what\":[\"pieces\"]}\n");
    PromptingText said(lines);
    std::istream in(&lines);
    std::ostream out(&said);
    app::runServe(in, out);
    std::map<std::string, ServedJson> answers;
    for (const ServedJson& answer : answersOf(said.str())) {
        answers[answer["id"].dump()] = answer;
    }
    ASSERT_EQ(answers.size(), 5U);
    EXPECT_TRUE(answers["1"].contains("result"));
    EXPECT_EQ(answers["2"]["error"]["code"], "cancelled");
    EXPECT_EQ(answers["3"]["result"]["cancelled"], true);
    EXPECT_EQ(answers["4"]["result"]["cancelled"], false);
    EXPECT_TRUE(answers["5"].contains("result"));
}

TEST(ServeLines, CancelIsHeardHoweverMuchWaits) {
    const test::TemporaryFolder folder;
    const std::string panel = folder.write("panel.obj", test::kPanel).string();
    const std::string load =
        ServedJson({{"id", "load"}, {"do", "load"}, {"args", {panel, "--unit", "cm"}}}).dump();
    std::string flood;
    constexpr int kFlood = 2000;
    for (int i = 0; i < kFlood; ++i) {
        flood += ServedJson{{"id", i}, {"do", "close"}}.dump() + "\n";
    }
    PromptedLines lines(
        load + "\n{\"id\":\"long\",\"do\":\"prove\",\"args\":[\"--edge\",\"20\"]}\n",
        flood + "{\"id\":\"stop\",\"do\":\"cancel\",\"of\":\"long\"}\n");
    PromptingText said(lines);
    std::istream in(&lines);
    std::ostream out(&said);
    app::runServe(in, out);
    std::map<std::string, ServedJson> answers;
    int refused = 0;
    for (const ServedJson& answer : answersOf(said.str())) {
        EXPECT_TRUE(answers.emplace(answer["id"].dump(), answer).second);
        refused += answer.contains("error") && answer["error"]["code"] == "too-many-requests";
    }
    EXPECT_EQ(answers.size(), 3U + kFlood);
    EXPECT_EQ(answers["\"long\""]["error"]["code"], "cancelled");
    EXPECT_EQ(answers["\"stop\""]["result"]["cancelled"], true);
    EXPECT_GT(refused, 0);
    EXPECT_TRUE(answers["0"].contains("result"));
    EXPECT_EQ(answers["1999"]["error"]["code"], "too-many-requests");
}

TEST(ServeProgram, TheSessionOfTheDocsRunsAsWritten) {
    const test::TemporaryFolder folder;
    std::ifstream page(kSources + "/docs/serve.md");
    std::string asked;
    std::vector<ServedJson> expected;
    bool isSession = false;
    for (std::string line; std::getline(page, line);) {
        isSession = isSession ? !line.starts_with("## ") : line == "<!-- session -->";
        if (isSession && line.starts_with("> ")) {
            asked += line.substr(2) + "\n";
        } else if (isSession && line.starts_with("< ")) {
            expected.push_back(ServedJson::parse(line.substr(2)));
        }
    }
    ASSERT_GE(expected.size(), 5U);
    const auto input = folder.write("asked", asked);
    const auto run = test::run("/bin/sh", {"-c", "cd \"$1\" && exec \"$2\" serve <\"$3\"", "sh",
                                           kSources, TOILE_PROGRAM, input.string()});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "");
    const auto answers = answersOf(run.out);
    ASSERT_EQ(answers.size(), expected.size());
    for (std::size_t i = 0; i < answers.size(); ++i) {
        EXPECT_EQ(differenceOf(expected[i], answers[i]), "") << expected[i].dump();
    }
}

TEST(ServeProgram, ProgressOfAnIdGrowsAndEndsBeforeItsAnswer) {
    const test::TemporaryFolder folder;
    const ServedJson load{{"id", 1}, {"do", "load"}, {"args", {kServedShirt, "--unit", "mm"}}};
    const auto input = folder.write(
        "asked",
        load.dump() +
            "\n{\"id\":2,\"do\":\"flatten\"}\n"
            "{\"id\":3,\"do\":\"edit\",\"args\":[\"--unit\",\"mm\",\"--method\",\"lscm\"]}\n"
            "{\"id\":4,\"do\":\"flatten\"}\n");
    const auto run = test::run(
        "/bin/sh", {"-c", "exec \"$1\" serve <\"$2\"", "sh", TOILE_PROGRAM, input.string()});
    EXPECT_EQ(run.status, 0);
    std::map<int, double> before;
    std::set<int> answered;
    for (const ServedJson& line : linesOf(run.out)) {
        const int id = line["id"];
        EXPECT_FALSE(answered.contains(id));
        if (line.contains("progress")) {
            EXPECT_GT(line["progress"].get<double>(), before[id]);
            EXPECT_LE(line["progress"].get<double>(), 1);
            before[id] = line["progress"];
        } else {
            EXPECT_TRUE(line.contains("result")) << line.dump();
            answered.insert(id);
        }
    }
    EXPECT_EQ(answered, (std::set<int>{1, 2, 3, 4}));
}

}  // namespace
}  // namespace toile
