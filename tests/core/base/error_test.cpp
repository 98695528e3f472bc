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
    EXPECT_EQ(sentence({ErrorCode::SeveralLoops, "sleeve", "2 loops"}),
              "sleeve: the piece has several boundary loops (2 loops); cut it from loop to loop, "
              "or let Toile do it (--auto-cut).");
    EXPECT_EQ(sentence({ErrorCode::Cancelled, "", ""}), "cancelled.");
}

TEST(Error, ASentenceIsReadableAndShortWhateverTheNames) {
    const std::string text =
        sentence({ErrorCode::CutImpossible, "a\x1B[31m\n" + std::string(2000000, 'x'),
                  std::string(9999, '"')});
    EXPECT_LT(text.size(), 2000U);
    EXPECT_EQ(std::ranges::count_if(text, [](char c) { return c >= 0 && c < ' '; }), 0);
}

TEST(Error, OnlyCodesAboutPiecesNameThem) {
    for (const auto code : {ErrorCode::CutImpossible, ErrorCode::JoinImpossible,
                            ErrorCode::NoSuchSeam, ErrorCode::UnitGuessed, ErrorCode::UnknownKey}) {
        EXPECT_FALSE(namesPiece(code)) << name(code);
    }
    for (const auto code : {ErrorCode::SeveralLoops, ErrorCode::HolesKept, ErrorCode::EndedEarly}) {
        EXPECT_TRUE(namesPiece(code)) << name(code);
    }
}

}  // namespace
}  // namespace toile
