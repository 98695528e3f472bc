// SPDX-License-Identifier: GPL-3.0-or-later
// All messages of errors and findings in one file, for review. Write it again with
// TOILE_UPDATE_MESSAGES=1 in the environment after messages have changed on purpose.
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/diagnose/finding.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

struct Message {
    std::string kind, code, text, remedy, option;
};

std::vector<Message> allMessages() {
    std::vector<Message> messages;
    for (int k = 0; k < kErrorCodeCount; ++k) {
        const auto code = static_cast<ErrorCode>(k);
        messages.push_back({isNote(code) ? "note" : "error", std::string(name(code)),
                            std::string(describe(code)), std::string(advice(code)),
                            std::string(commandLineOption(code))});
    }
    for (int k = 0; k < kFindingKindCount; ++k) {
        const FindingWords& words = findingWords(static_cast<FindingKind>(k));
        const std::string text = words.describe;
        messages.push_back({"finding", words.name, words.title + (text.empty() ? "" : ": " + text),
                            words.advice, words.option});
    }
    return messages;
}

TEST(Messages, AreThoseOfTheListForReview) {
    std::string list = "code | text | remedy | option\n";
    for (const auto& [kind, code, text, remedy, option] : allMessages()) {
        list += kind + " " + code;
        for (const std::string& column : {text, remedy, option}) {
            list += " | " + (column.empty() ? "-" : column);
        }
        list += "\n";
    }
    const auto path = test::sourceFile("tests/core/diagnose/messages.txt");
    if (std::getenv("TOILE_UPDATE_MESSAGES") != nullptr) {
        ASSERT_TRUE(writeFile(path, list));
    }
    const auto stored = readFile(path);
    ASSERT_TRUE(stored);
    EXPECT_EQ(*stored, list) << "write it again: TOILE_UPDATE_MESSAGES=1";
}

TEST(Messages, HaveSentencesOfAtMostTwentyWords) {
    constexpr int kMaxWords = 20;
    for (const Message& message : allMessages()) {
        for (const std::string& part : {message.text, message.remedy}) {
            std::istringstream words(part);
            std::string word;
            for (int count = 0; words >> word;) {
                count += word.find_first_of("abcdefghijklmnopqrstuvwxyz%") != std::string::npos;
                EXPECT_LE(count, kMaxWords) << message.code << ": " << part;
                if (word.ends_with('.') || word.ends_with(':') || word.ends_with(';')) {
                    count = 0;
                }
            }
        }
    }
}

TEST(Messages, RemediesAreSentencesWithoutAFullStop) {
    for (const Message& message : allMessages()) {
        if (!message.remedy.empty() && message.remedy != "%0") {
            EXPECT_TRUE(message.remedy.front() >= 'A' && message.remedy.front() <= 'Z')
                << message.code;
            EXPECT_NE(message.remedy.back(), '.') << message.code;
        }
    }
}

}  // namespace
}  // namespace toile
