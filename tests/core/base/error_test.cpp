// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(Error, EveryCodeHasItsOwnNameAndWords) {
    std::set<std::string_view> names;
    for (int k = 0; k < kErrorCodeCount; ++k) {
        const auto code = static_cast<ErrorCode>(k);
        EXPECT_TRUE(names.insert(name(code)).second) << name(code);
        EXPECT_NE(name(code), "unknown");
        EXPECT_EQ(name(code).find_first_not_of("abcdefghijklmnopqrstuvwxyz-"),
                  std::string_view::npos);
        EXPECT_FALSE(describe(code).empty());
        EXPECT_NE(describe(code).back(), '.');
        if (!isNote(code) && code != ErrorCode::Cancelled) {
            EXPECT_FALSE(advice(code).empty()) << name(code);
        }
    }
}

TEST(Error, ASentenceNamesPlacePieceAndNextStep) {
    EXPECT_EQ(sentence({ErrorCode::SeveralLoops, Subject::piece("sleeve"), "2 loops"}),
              "sleeve: the piece has several boundary loops (2 loops). Cut it from loop to loop, "
              "or let Toile do it (--auto-cut).");
    EXPECT_EQ(sentence({ErrorCode::Cancelled}), "cancelled.");
}

TEST(Error, AdviceForTheWindowNamesNoOption) {
    for (int k = 0; k < kErrorCodeCount; ++k) {
        const auto code = static_cast<ErrorCode>(k);
        EXPECT_EQ(advice(code).find("--"), std::string_view::npos) << name(code);
        EXPECT_EQ(advice(code).find("toile "), std::string_view::npos) << name(code);
    }
}

TEST(Error, ASentenceIsReadableAndShortWhateverTheNames) {
    const std::string text =
        sentence({ErrorCode::CutImpossible, Subject::cut("a\x1B[31m\n" + std::string(2000000, 'x')),
                  std::string(9999, '"')});
    EXPECT_LT(text.size(), 2000U);
    EXPECT_EQ(std::ranges::count_if(text, [](char c) { return c >= 0 && c < ' '; }), 0);
}

TEST(Error, OnlyASubjectThatIsAPieceHasAPiecesId) {
    EXPECT_EQ(Subject::piece("front", {7}).pieceId(), PieceId{7});
    for (const Subject& subject :
         {Subject(), Subject::piece("front"), Subject::file("front", {7}),
          Subject::seam("front", {7}), Subject::cut("front", {7}), Subject::join("front")}) {
        EXPECT_FALSE(subject.pieceId());
        EXPECT_NE(subject, Subject::piece("front", {7}));
    }
}

TEST(Error, WhatIsSaidOfManyNamesSomeOfThem) {
    std::vector<Subject> subjects(10, Subject::seam("hem", {7}));
    const Problems each = aboutEach(ErrorCode::NoSuchSeam, subjects, "gone");
    ASSERT_EQ(each.size(), 10U);
    EXPECT_EQ(each[9].subject, subjects[9]);
    subjects.push_back(Subject::seam("cuff"));
    const Problems one = aboutEach(ErrorCode::NoSuchSeam, subjects, "gone");
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0].subject, Subject::seam(R"("hem", "hem", "hem" and 8 more)"));
    EXPECT_EQ(one[0].detail, "gone");
    EXPECT_TRUE(aboutEach(ErrorCode::NoSuchSeam, {}).empty());
}

}  // namespace
}  // namespace toile
