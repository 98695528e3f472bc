// SPDX-License-Identifier: GPL-3.0-or-later
// `toile serve`: several requests at once, and the built program.
#include <cmath>
#include <fstream>
#include <future>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "app/cli/command_line.h"
#include "tests/cli/run_program.h"
#include "tests/cli/serve_support.h"

namespace toile {
namespace {

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

TEST(ServeLines, EachGetsOneAnswerInOrder) {
    std::string asked;
    for (int i = 0; i < 200; ++i) {
        asked += ServedJson{{"id", i}, {"do", i % 2 ? "close" : "flatten"}}.dump() + "\n";
    }
    asked += "no JSON\n" + std::string(app::kMaxServeLine + 1, 'x') + "\n\n";
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
    std::ifstream page(kServeSources + "/docs/serve.md");
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
                                           kServeSources, TOILE_PROGRAM, input.string()});
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
