// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/seam_settings.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

constexpr LineId kFront{1}, kBack{2};

Seam seamBetween(double from, double to) {
    Seam seam;
    seam.name = "front / back";
    seam.place = {{kFront, from, to}, {kBack, 1 - to, 1 - from}};
    return seam;
}

SeamGraph graphOf(std::vector<Seam> seams) {
    SeamGraph graph;
    graph.seams = std::move(seams);
    return graph;
}

std::optional<double> easeOfFirst(SeamGraph graph, const std::vector<SeamSettings>& settings) {
    applySettings(graph, settings);
    return graph.seams.front().ease;
}

TEST(SeamSettings, BothPartsOfASeamHaveItsEase) {
    const auto settings = withEase({}, seamBetween(0.2, 0.8), 0.05);
    EXPECT_EQ(easeOfFirst(graphOf({seamBetween(0.2, 0.5)}), settings), 0.05);
    EXPECT_EQ(easeOfFirst(graphOf({seamBetween(0.5, 0.8)}), settings), 0.05);
    EXPECT_EQ(easeOfFirst(graphOf({seamBetween(0.8, 0.9)}), settings), std::nullopt);
}

TEST(SeamSettings, WhatWasSaidOfAPartIsNotSaidOfTheWhole) {
    auto settings = withEase({}, seamBetween(0, 1), 0.05);
    settings = withEase(settings, seamBetween(0, 0.6), 0.1);
    EXPECT_EQ(easeOfFirst(graphOf({seamBetween(0, 0.6)}), settings), 0.1);
    EXPECT_EQ(easeOfFirst(graphOf({seamBetween(0.6, 1)}), settings), 0.05);
    EXPECT_EQ(easeOfFirst(graphOf({seamBetween(0, 1)}), settings), 0.05);
    settings = withEase(settings, seamBetween(0, 0.6), std::nullopt);
    EXPECT_EQ(easeOfFirst(graphOf({seamBetween(0, 0.6)}), settings), std::nullopt);
    EXPECT_EQ(easeOfFirst(graphOf({seamBetween(0, 1)}), settings), 0.05);
}

TEST(SeamSettings, OfASeamThatIsTurnedTheEaseIsSeenFromTheOtherSide) {
    const auto settings = withEase({}, seamBetween(0, 1), 0.25);
    Seam turned = seamBetween(0, 1);
    std::swap(turned.place.left, turned.place.right);
    EXPECT_NEAR(*easeOfFirst(graphOf({turned}), settings), 1 / 1.25 - 1, 1e-15);
    EXPECT_LE(*easeOfFirst(graphOf({turned}), withEase({}, seamBetween(0, 1), -0.99)), 10);
}

TEST(SeamSettings, AStretchOnAClosedLineMayPassItsBeginning) {
    const auto settings = withEase({}, seamBetween(0.9, 1.1), 0.05);
    EXPECT_EQ(easeOfFirst(graphOf({seamBetween(0.95, 1.1)}), settings), 0.05);
    Seam counted = seamBetween(0, 0.1);
    counted.place.right = {kBack, -0.1, 0};
    EXPECT_EQ(easeOfFirst(graphOf({counted}), settings), 0.05);
}

TEST(SeamSettings, ASeamOfWhichNothingIsKnownIsNotRemembered) {
    Seam unknown;
    EXPECT_TRUE(withEase({}, unknown, 0.1).empty());
    unknown.place.right = {kBack, 0, 1};  // known by its other side alone
    const auto settings = withEase({}, unknown, 0.25);
    ASSERT_EQ(settings.size(), 1U);
    EXPECT_EQ(settings[0].place.left.line, kBack);
    EXPECT_NEAR(*easeOfFirst(graphOf({unknown}), settings), 0.25, 1e-15);
}

TEST(SeamSettings, NamesThatFitSeveralOrNoneAreNamed) {
    Problems problems;
    const SeamGraph graph = graphOf({seamBetween(0, 0.5), seamBetween(0.5, 1)});
    EXPECT_TRUE(withEaseByName({}, graph, {{"front / back", 0.1}, {"hem", 0.2}}, problems).empty());
    ASSERT_EQ(problems.size(), 2U);
    EXPECT_EQ(problems[0].code, ErrorCode::NoSuchSeam);
}

TEST(SeamSettings, AnEaseByNameLeavesTheNameThatWasTyped) {
    Problems problems;
    SeamGraph graph = graphOf({seamBetween(0, 1)});
    const std::vector<SeamSettings> renamed{{graph.seams[0].place, std::nullopt, "hip"}};
    applySettings(graph, withEaseByName(renamed, graph, {{"front / back", 0.1}}, problems));
    EXPECT_EQ(graph.seams[0].name, "hip");
    EXPECT_EQ(graph.seams[0].ease, 0.1);
}

}  // namespace
}  // namespace toile
