// SPDX-License-Identifier: GPL-3.0-or-later
// What a project keeps of laying the pieces on cloth.
#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "core/base/json_fields.h"
#include "core/base/units.h"
#include "core/project/project_file.h"

namespace toile {
namespace {

const std::filesystem::path kMarkerFolder = "/garments";

Project markedProject() {
    Project project;
    project.files.push_back({"/garments/a.obj", std::nullopt, {}});
    MarkerPlan& plan = project.markers["Leather"];
    Hide hide{"cow", geometry::Polygon(3, 2), {}};
    hide.outline << 0, 0, 900, 0.1, 450, 700.0 / 3;
    HideZone zone{geometry::Polygon(3, 2), 2};
    zone.outline << 100, 50, 200, 50, 150, 90;
    hide.zones = {zone, {zone.outline, 0}};
    plan.settings.hides.push_back(std::make_shared<const Hide>(hide));
    plan.kept.push_back({{{7}, 1}, 0, {{12.5, 80}, 0.25, true}});
    return project;
}

std::string faultOf(const std::function<void(JsonDocument&)>& damage) {
    auto document = *parseJson(projectText(markedProject(), kMarkerFolder), "p.toile",
                               ErrorCode::MalformedProject);
    damage(document);
    const auto read = parseProject(document.dump(), "p.toile", kMarkerFolder);
    return read ? "" : read.error().detail;
}

TEST(MarkerOfAProject, HidesComeBackAsTheyWere) {
    const Project project = markedProject();
    const std::string text = projectText(project, kMarkerFolder);
    const auto read = parseProject(text, "p.toile", kMarkerFolder);
    ASSERT_TRUE(read) << sentence(read.error());
    EXPECT_TRUE(read->notes.empty());
    const MarkerPlan& plan = read->project.markers.at("Leather");
    ASSERT_EQ(plan.settings.hides.size(), 1U);
    const Hide &hide = *plan.settings.hides.front(),
               &was = *project.markers.at("Leather").settings.hides.front();
    EXPECT_EQ(hide.name, "cow");
    EXPECT_EQ(hide.outline, was.outline);
    ASSERT_EQ(hide.zones.size(), 2U);
    EXPECT_EQ(hide.zones[0].outline, was.zones[0].outline);
    EXPECT_EQ(hide.zones[0].grade, 2);
    EXPECT_EQ(hide.zones[1].grade, 0);
    EXPECT_EQ(plan.kept, project.markers.at("Leather").kept);
    EXPECT_EQ(projectText(read->project, kMarkerFolder), text);
}

TEST(MarkerOfAProject, AnyTurnIsADirection) {
    Project project = markedProject();
    Placement& placement = project.markers["Leather"].kept.front().placement;
    placement.turn = 0.25 + 6 * kPi;
    const auto read = parseProject(projectText(project, kMarkerFolder), "p.toile", kMarkerFolder);
    ASSERT_TRUE(read) << sentence(read.error());
    EXPECT_NEAR(read->project.markers.at("Leather").kept.front().placement.turn, 0.25, 1e-9);
}

TEST(MarkerOfAProject, NothingIsWrittenWhereNothingIsSaid) {
    Project project = markedProject();
    project.markers.clear();
    EXPECT_EQ(projectText(project, kMarkerFolder).find("markers"), std::string::npos);
}

TEST(MarkerOfAProject, AFaultNamesItsPlace) {
    EXPECT_EQ(faultOf([](JsonDocument&) {}), "");
    EXPECT_EQ(faultOf([](JsonDocument& d) { d["markers"][0]["garments"] = 0; }),
              R"("markers[0].garments" must be a whole number from 1 to 200)");
    EXPECT_EQ(faultOf([](JsonDocument& d) {
                  d["markers"][0]["sheet"] = {0, 5};
              }),
              R"("markers[0].sheet" must be more than 0)");
    EXPECT_EQ(faultOf([](JsonDocument& d) {
                  d["markers"][0]["sheet"] = {5, 2e5};
              }),
              R"("markers[0].sheet" must be at most 1e+05)");
    EXPECT_EQ(faultOf([](JsonDocument& d) {
                  d["markers"][0]["hides"][0]["outline"][1] = {1, 1e200};
              }),
              R"("markers[0].hides[0].outline[1]" must be numbers from -1e+07 to 1e+07)");
    EXPECT_EQ(faultOf([](JsonDocument& d) {
                  d["markers"][0]["kept"][0]["offset"] = {1, 2e7};
              }),
              R"("markers[0].kept[0].offset" must be numbers from -1e+07 to 1e+07)");
    EXPECT_EQ(faultOf([](JsonDocument& d) {
                  const JsonDocument first = d["markers"][0];
                  d["markers"].push_back(first);
              }),
              R"("markers" must have each material once)");
    EXPECT_EQ(faultOf([](JsonDocument& d) { d["markers"][0]["turns"] = "up"; }),
              R"("markers[0].turns" must be "halfTurns", "oneWay" or "free")");
    EXPECT_EQ(faultOf([](JsonDocument& d) { d["markers"][0]["hides"][0]["outline"][1] = {1}; }),
              R"("markers[0].hides[0].outline[1]" must be a list of 2 numbers)");
    EXPECT_EQ(faultOf([](JsonDocument& d) { d["markers"][0]["hides"][0]["outline"].erase(2); }),
              R"("markers[0].hides[0].outline" must have three points at least)");
    EXPECT_EQ(faultOf([](JsonDocument& d) { d["markers"][0]["matched"] = {1}; }),
              R"("markers[0].matched[0]" must be a string)");
    EXPECT_EQ(faultOf([](JsonDocument& d) {
                  d["markers"][0]["grades"] = {{{"piece", "front"}, {"grade", 0}}};
              }),
              R"("markers[0].grades[0].grade" must be a whole number from 1 to 1000)");
    EXPECT_EQ(faultOf([](JsonDocument& d) { d["markers"][0]["kept"][0].erase("piece"); }),
              R"("markers[0].kept[0].piece" is missing)");
}

}  // namespace
}  // namespace toile
