// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nest/instance_file.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/core/nest/nest_shapes.h"
#include "tests/core/support/shared_data.h"

namespace {

using namespace toile;

const char* const kInstance = R"({"name": "two", "strip_height": 20, "items": [
    {"id": 3, "demand": 2, "dxf": "i_3.dxf", "allowed_orientations": [0.0, 180.0],
     "shape": {"type": "simple_polygon", "data": [[0, 0], [10, 0], [0, 10], [0, 0]]}},
    {"id": 4, "demand": 1, "shape": {"type": "polygon", "data": {
      "outer": [[0, 0], [10, 0], [10, 10], [0, 10]],
      "inner": [[[2, 2], [8, 2], [8, 8]]]}}}]})";

TEST(NestInstanceFile, SaysShapesCopiesAndAngles) {
    const auto instance = parseNestInstance(kInstance, "two.json");
    ASSERT_TRUE(instance.ok()) << sentence(instance.error());
    EXPECT_EQ(instance->name, "two");
    EXPECT_EQ(instance->width, 20);
    ASSERT_EQ(instance->items.size(), 2U);
    const NestItem& half = instance->items[0];
    EXPECT_EQ(half.name, "3");
    EXPECT_EQ(half.demand, 2);
    EXPECT_EQ(half.rings[0].rows(), 3);
    EXPECT_EQ(half.angles, (std::vector{0.0, kPi}));
    EXPECT_EQ(half.tolerance, 0);
    EXPECT_EQ(instance->items[1].rings.size(), 2U);
    EXPECT_GE(instance->items[1].tolerance, kPi);
}

TEST(NestInstanceFile, WhatIsWrongHasItsPlace) {
    const auto fault = [](const std::string& from, const std::string& to) {
        std::string text = kInstance;
        text.replace(text.find(from), from.size(), to);
        const auto instance = parseNestInstance(text, "two.json");
        EXPECT_FALSE(instance.ok()) << to;
        EXPECT_EQ(instance.error().code, ErrorCode::MalformedFile);
        EXPECT_EQ(instance.error().subject.name, "two.json");
        return std::string(instance.error().detail);
    };
    EXPECT_NE(fault("[10, 0]", "[10]").find("items[0].shape.data[1]"), std::string::npos);
    EXPECT_NE(fault("\"demand\": 2, ", "").find("items[0].demand"), std::string::npos);
    EXPECT_NE(fault("simple_polygon", "circle").find("items[0].shape.type"), std::string::npos);
    EXPECT_NE(fault("[0.0, 180.0]", "[]").find("allowed_orientations"), std::string::npos);
    EXPECT_NE(fault("20", "-1").find("strip_height"), std::string::npos);
    EXPECT_NE(fault("[[2, 2], [8, 2], [8, 8]]", "[7]").find("inner[0]"), std::string::npos);
    fault("\"items\": [", "\"items\": {");
}

TEST(NestInstanceFile, TheSameNestHasTheSameBytes) {
    const auto written = [] {
        auto nester = Nester::make(*parseNestInstance(kInstance, "two.json"), {});
        const Progress progress;
        nester->step(progress);
        return nestReport(nester->instance(), {}, nester->best()) +
               nestPicture(nester->instance(), nester->best());
    };
    const std::string first = written();
    EXPECT_NE(first.find("\"rounds\": 1"), std::string::npos) << first;
    EXPECT_EQ(written(), first);
}

class PublishedInstances : public testing::TestWithParam<std::pair<const char*, double>> {};

/// Far below what a few seconds reach, far above what laying one by one does.
TEST_P(PublishedInstances, AreNestedWell) {
    const auto& [name, least] = GetParam();
    const auto file = test::sharedFile("nesting/" + std::string(name) + ".json");
    TOILE_NEEDS_SHARED(file);
    const auto instance = readNestInstance(file);
    ASSERT_TRUE(instance.ok()) << sentence(instance.error());
    auto nester = Nester::make(*instance, {});
    ASSERT_TRUE(nester.ok()) << sentence(nester.error());
    const Progress progress;
    while (nester->best().rounds < 8) {
        nester->step(progress);
    }
    EXPECT_GE(100 * nester->best().use, least);
    test::expectKeepsRules(*instance, {}, nester->best());
}

INSTANTIATE_TEST_SUITE_P(Nesting, PublishedInstances,
                         testing::Values(std::pair("shirts", 82.0), std::pair("trousers", 83.0),
                                         std::pair("swim", 67.0), std::pair("albano", 81.0),
                                         std::pair("dagli", 80.0), std::pair("jakobs1", 75.0)),
                         [](const auto& tested) { return std::string(tested.param.first); });

}  // namespace
