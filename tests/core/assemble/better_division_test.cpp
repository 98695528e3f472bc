// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "core/assemble/divide.h"

namespace toile {
namespace {

constexpr int kAround = 8, kRings = 3;

/// A tube of two rows of quads. @param islands  of its UV map, that go round in strips; 0: no map.
/// @param tubes  so many, each an object of its own
PolygonSoup tube(int islands, int tubes = 1) {
    std::string obj;
    for (int t = 0; t < tubes; ++t) {
        obj += "o tube" + std::to_string(t) + "\n";
        const int first = t * kAround * kRings, firstUv = t * (kAround + islands) * kRings;
        for (int ring = 0; ring < kRings; ++ring) {
            for (int k = 0; k < kAround; ++k) {
                const double angle = 2 * 3.14159265358979 * k / kAround;
                obj += "v " + std::to_string(std::cos(angle) + 5 * t) + " " + std::to_string(ring) +
                       " " + std::to_string(std::sin(angle)) + "\n";
            }
        }
        const int width = islands > 0 ? kAround / islands : 0;
        for (int ring = 0; ring < kRings && islands > 0; ++ring) {
            for (int u = 0; u < kAround + islands; ++u) {
                obj += "vt " + std::to_string(u) + " " + std::to_string(ring) + "\n";
            }
        }
        for (int ring = 0; ring + 1 < kRings; ++ring) {
            for (int k = 0; k < kAround; ++k) {
                const auto corner = [&](int dk, int dr) {
                    const int v = first + (ring + dr) * kAround + (k + dk) % kAround + 1;
                    std::string text = " " + std::to_string(v);
                    if (islands > 0) {
                        const int u = k + dk + k / width;
                        text += "/" +
                                std::to_string(firstUv + (ring + dr) * (kAround + islands) + u + 1);
                    }
                    return text;
                };
                obj += "f" + corner(0, 0) + corner(1, 0) + corner(1, 1) + corner(0, 1) + "\n";
            }
        }
    }
    Progress progress;
    auto soup = readObj(std::make_shared<const std::string>(obj), "tube.obj", progress);
    EXPECT_TRUE(soup);
    return std::move(*soup);
}

TEST(BetterDivision, UvIslandsOpenATube) {
    const DivisionCount present{SplitMode::Components, 1, 0};
    EXPECT_EQ(betterDivision(tube(2), present), (DivisionCount{SplitMode::Uv, 2, 2}));
    EXPECT_EQ(betterDivision(tube(1), present), (DivisionCount{SplitMode::Uv, 1, 1}));
}

TEST(BetterDivision, IsNoneWhereNothingElseLiesFlat) {
    EXPECT_FALSE(betterDivision(tube(0), {SplitMode::Components, 1, 0}));
    EXPECT_FALSE(betterDivision(tube(0, 2), {SplitMode::Objects, 2, 0}));
    EXPECT_FALSE(betterDivision(tube(2), {SplitMode::Uv, 2, 2}));
    // As many are flat already, by a cut or a hole that topology alone does not know.
    EXPECT_FALSE(betterDivision(tube(2), {SplitMode::Components, 3, 2}));
}

TEST(BetterDivision, EndsWithACancel) {
    Progress progress;
    progress.cancel();
    EXPECT_FALSE(betterDivision(tube(2), {SplitMode::Components, 1, 0}, progress));
}

}  // namespace
}  // namespace toile
