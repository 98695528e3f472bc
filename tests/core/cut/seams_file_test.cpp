// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/seams_file.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(SeamsFile, ReadsCutsAndEase) {
    const auto file = parseSeamsFile(R"({
        "version": 1, "unit": "cm",
        "cuts": [
            {"name": "inseam", "kind": "path", "points": [[0, 1, 2], [3, 4.5, -6e1]]},
            {"kind": "loop", "along": "edges", "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]},
            {"name": "waist", "kind": "dart", "points": []}
        ],
        "joins": [
            {"name": "front / back", "points": [[1, 2, 3], [4, 5, 6]]},
            {"points": [[0, 0, 0], [1, 0, 0]]}
        ],
        "ease": {"front / skirt": 30}
    })",
                                     "a.json");
    ASSERT_TRUE(file) << sentence(file.error());
    EXPECT_EQ(file->unit, LengthUnit::Centimetre);
    ASSERT_EQ(file->cuts.size(), 3U);
    EXPECT_EQ(file->cuts[0].name, "inseam");
    EXPECT_EQ(file->cuts[0].points[1], Eigen::Vector3d(3, 4.5, -60));
    EXPECT_FALSE(file->cuts[0].alongEdges);
    EXPECT_EQ(file->cuts[1].name, "cut 2");
    EXPECT_EQ(file->cuts[1].kind, UserCut::Kind::Loop);
    EXPECT_TRUE(file->cuts[1].alongEdges);
    EXPECT_EQ(file->cuts[2].kind, UserCut::Kind::Dart);
    ASSERT_EQ(file->joins.size(), 2U);
    EXPECT_EQ(file->joins[0].name, "front / back");
    EXPECT_EQ(file->joins[0].points[1], Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(file->joins[1].name, "join 2");
    EXPECT_DOUBLE_EQ(file->ease.at("front / skirt"), 0.3);
}

TEST(SeamsFile, ReadsWhatItWrites) {
    SeamsFile file;
    file.unit = LengthUnit::Inch;
    file.cuts = {{"Ärmel \"1\"", UserCut::Kind::Dart, {{0.1, -2, 1e-9}, {1.0 / 3, 0, 7}}, true}};
    file.joins = {{"front / back", {{1.0 / 7, 0, -3}, {4, 5e-12, 6}}}};
    file.ease["a / b"] = -0.125;
    const auto again = parseSeamsFile(writeSeamsFile(file), "a.json");
    ASSERT_TRUE(again) << sentence(again.error());
    EXPECT_EQ(again->unit, file.unit);
    ASSERT_EQ(again->cuts.size(), 1U);
    EXPECT_EQ(again->cuts[0].name, file.cuts[0].name);
    EXPECT_EQ(again->cuts[0].points, file.cuts[0].points);
    EXPECT_EQ(again->joins, file.joins);
    EXPECT_EQ(again->ease, file.ease);
    EXPECT_FALSE(SeamsFile({{}, {}, file.joins, {}}).empty());
    EXPECT_TRUE(parseSeamsFile(writeSeamsFile({}), "b.json")->empty());
}

TEST(SeamsFile, KnowsNeitherIdsNorWhichCutMirrorsWhich) {
    SeamsFile file;
    file.cuts = {{"dart 1", UserCut::Kind::Dart, {{0, 1, 2}, {3, 4, 5}}, false}};
    const std::string text = writeSeamsFile(file);
    file.cuts[0].id = {7};
    file.cuts[0].mirrors = {9};
    EXPECT_EQ(writeSeamsFile(file), text);
}

TEST(SeamsFile, SaysWhatIsWrongInOneSentence) {
    for (const char* wrong : {"",
                              "nonsense",
                              "[]",
                              "{}",
                              R"({"version": 2})",
                              R"({"version": 1, "cuts": {}})",
                              R"({"version": 1, "unit": "ell"})",
                              R"({"version": 1, "cuts": [1]})",
                              R"({"version": 1, "cuts": [{"name": "a"}]})",
                              R"({"version": 1, "cuts": [{"name": "", "points": []}]})",
                              R"({"version": 1, "cuts": [{"points": [[0, 0]]}]})",
                              R"({"version": 1, "cuts": [{"points": [[0, 0, "1"]]}]})",
                              R"({"version": 1, "cuts": [{"points": [], "kind": "zigzag"}]})",
                              R"({"version": 1, "cuts": [{"points": [], "kind": 7}]})",
                              R"({"version": 1, "cuts": [{"points": [], "along": "x"}]})",
                              R"({"version": 1, "joins": 3})",
                              R"({"version": 1, "joins": [[]]})",
                              R"({"version": 1, "joins": [{"name": "a"}]})",
                              R"({"version": 1, "joins": [{"name": 1, "points": []}]})",
                              R"({"version": 1, "joins": [{"points": [[0, 0]]}]})",
                              R"({"version": 1, "ease": {"a": "much"}})",
                              R"({"version": 1, "ease": {"a": -100}})",
                              R"({"version": 1, "ease": {"a": 1e999}})"}) {
        const auto file = parseSeamsFile(wrong, "a.json");
        ASSERT_FALSE(file) << wrong;
        EXPECT_EQ(file.error().code, ErrorCode::MalformedFile);
        EXPECT_EQ(file.error().subject.name, "a.json");
        EXPECT_FALSE(file.error().detail.empty()) << wrong;
    }
    EXPECT_EQ(readSeamsFile("/no/such/file.json").error().code, ErrorCode::FileUnreadable);
}

TEST(SeamsFile, WhatIsNotKnownIsNotedAndNotFatal) {
    Problems notes;
    const auto file = parseSeamsFile(
        R"({"version": 1, "cut": [], "joins": [{"points": [], "kind": "path"}],
            "cuts": [{"name": "a", "points": [], "\u001b[31m": 1}]})",
        "a.json", &notes);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->cuts.size(), 1U);
    EXPECT_EQ(file->joins.size(), 1U);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, ErrorCode::UnknownKey);
    EXPECT_EQ(notes[0].subject.name, "a.json");
    EXPECT_EQ(notes[0].detail, R"("cuts[0]. [31m", "joins[0].kind", "cut")");
}

}  // namespace
}  // namespace toile
