// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include <gtest/gtest.h>

#include "core/diagnose/finding.h"

namespace toile {
namespace {

TEST(FindingWords, EveryKindHasANameOfItsOwnAndATitle) {
    std::set<std::string_view> names, titles;
    for (int i = 0; i < kFindingKindCount; ++i) {
        const auto kind = static_cast<FindingKind>(i);
        names.insert(name(kind));
        titles.insert(findingWords(kind).title);
        EXPECT_NE(*findingWords(kind).title, '\0');
    }
    EXPECT_EQ(names.size(), static_cast<std::size_t>(kFindingKindCount));
    EXPECT_EQ(titles.size(), static_cast<std::size_t>(kFindingKindCount));
    EXPECT_FALSE(names.contains(""));
}

TEST(FindingWords, SentenceSaysWhereWhatAndWhatToTry) {
    Finding finding;
    finding.kind = FindingKind::SeamLengths;
    finding.subject.name = "front / back";
    finding.figures = {{3.2, Figure::Unit::Length},
                       {412.34, Figure::Unit::Length},
                       {409.14, Figure::Unit::Length}};
    EXPECT_EQ(
        sentence(finding),
        "front / back: the flat sides of the seam differ by 3.20 mm more than the ease (412.3 "
        "mm and 409.1 mm). Choose a method that keeps seam lengths, or set the ease.");
}

TEST(FindingWords, StrainCarriesItsSign) {
    Finding finding;
    finding.kind = FindingKind::StrainBias;
    finding.figures = {{-0.034, Figure::Unit::Strain},
                       {-0.03, Figure::Unit::Strain},
                       {0.125, Figure::Unit::Percent}};
    const std::string text = description(finding);
    const std::size_t reached = text.find(" -3.4 %"), allowed = text.find(" -3.0 %");
    EXPECT_LT(reached, allowed) << text;
    EXPECT_LT(allowed, text.find("12.5 % of the area")) << text;
    finding.figures[0].value = 0.09;
    EXPECT_NE(description(finding).find("reaches +9.0 %"), std::string::npos);
}

TEST(FindingWords, ReasonsAndMissingFiguresLeaveNoPlaceholder) {
    Finding finding;
    for (int i = 0; i < kFindingKindCount; ++i) {
        finding.kind = static_cast<FindingKind>(i);
        finding.reason = "because";
        const std::string text = sentence(finding);
        EXPECT_EQ(text.find("%1"), std::string::npos) << text;
        EXPECT_EQ(text.find("%0"), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace toile
