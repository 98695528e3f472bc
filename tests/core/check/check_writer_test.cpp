// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/check/ready_to_cut.h"
#include "tests/core/check/cut_plans.h"

namespace toile {
namespace {

TEST(CheckWriter, EveryFindingIsThereWithPieceFiguresAndPlace) {
    CutPlan plan = test::readyPlan();
    plan.settings[1].grain.reset();
    plan.fabric.id = "custom";  // limits that a person has typed
    auto stretched = test::copyOfResult(plan, 0);
    stretched->flat->Q.col(1) /= 1.2;
    plan.results[0] = stretched;
    const auto json = nlohmann::json::parse(writeReadiness(*plan.garment, readyToCut(plan)));
    EXPECT_EQ(json["verdict"], "faults");
    EXPECT_EQ(json["doubts"], 1);
    EXPECT_EQ(json["findings"].size(),
              json["faults"].get<std::size_t>() + json["doubts"].get<std::size_t>());
    const auto& first = json["findings"][0];
    EXPECT_EQ(first["kind"], "strain-warp");
    EXPECT_EQ(first["severity"], "fault");
    EXPECT_EQ(first["pieces"], nlohmann::json::array({"front"}));
    EXPECT_NEAR(first["figures"][0]["value"].get<double>(), 0.2, 1e-9);
    EXPECT_EQ(first["figures"][0]["unit"], "fraction");
    EXPECT_EQ(first["place"]["position"].size(), 3U);
    EXPECT_EQ(first["place"]["flat"].size(), 2U);
    EXPECT_TRUE(first["message"].get<std::string>().starts_with("front: strain along the warp"));
    const auto& last = json["findings"].back();
    EXPECT_EQ(last["kind"], "grain-missing");
    EXPECT_TRUE(last["place"].is_null());
    EXPECT_TRUE(last["seam"].is_null());
}

TEST(CheckWriter, ReadyIsSaidToo) {
    const CutPlan plan = test::readyPlan();
    const auto json = nlohmann::json::parse(writeReadiness(*plan.garment, readyToCut(plan)));
    EXPECT_EQ(json["verdict"], "ready");
    EXPECT_TRUE(json["findings"].empty());
}

}  // namespace
}  // namespace toile
