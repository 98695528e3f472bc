// SPDX-License-Identifier: GPL-3.0-or-later
// Along every seam of a sample garment the two pieces carry the same points; what is left over is
// hems and openings.
#include <ostream>
#include <set>

#include <gtest/gtest.h>

#include "sample_mesh.h"

namespace toile::samples {

namespace {

constexpr double kLengthSlack = 0.1;  // mm; the table is rounded to tenths

/// Outline sides that two pieces share, or that one piece has alone (`second` empty).
struct OutlineRun {
    std::string first;
    std::string second;
    int edges = 0;
    double length = 0.0;  // mm
};

struct SewnGarment {
    std::string name;
    std::vector<OutlineRun>
        runs;  ///< names in alphabetical order; right-hand mirror images left out
};

std::ostream& operator<<(std::ostream& out, const SewnGarment& garment) {
    return out << garment.name;
}

std::vector<SewnGarment> sewnGarments() {
    return {
        {"tshirt",
         {{"back", "front", 62, 1138.6},  // side seams and shoulders
          {"back", "sleeve_left", 11, 202.3},
          {"front", "sleeve_left", 12, 221.8},
          {"sleeve_left", "sleeve_left", 8, 147.2},
          {"back", "neckband", 16, 197.5},
          {"front", "neckband", 28, 344.3},
          {"neckband", "neckband", 2, 22.0},
          {"front", "", 32, 574.1},
          {"back", "", 32, 583.4},
          {"sleeve_left", "", 23, 419.7},
          {"neckband", "", 38, 457.0}}},
        {"bodice",
         {{"front", "side_front_left", 37, 512.1},
          {"side_back_left", "side_front_left", 23, 326.1},  // side seam and outer shoulder
          {"back_left", "side_back_left", 36, 498.0},
          {"back_left", "back_right", 34, 471.1},
          {"back_left", "front", 3, 45.2},  // inner shoulder
          {"front", "", 40, 564.3},
          {"side_front_left", "", 23, 331.6},
          {"side_back_left", "", 23, 319.8},
          {"back_left", "", 14, 200.3}}},
        {"trousers",
         {{"front_left", "front_right", 15, 319.5},
          {"back_left", "back_right", 16, 334.1},
          {"back_left", "front_left", 79, 1662.7},  // inseam and side seam
          {"front_left", "waistband", 9, 198.4},
          {"back_left", "waistband", 9, 194.4},
          {"waistband", "waistband", 2, 38.1},
          {"front_left", "", 11, 225.6},
          {"back_left", "", 11, 232.0},
          {"waistband", "", 48, 773.7}}},
        {"cap",
         {{"front_left", "front_right", 23, 183.0},
          {"front_left", "side_left", 22, 173.3},
          {"back_left", "side_left", 22, 173.3},
          {"back_left", "back_right", 23, 183.0},
          {"front_left", "peak", 11, 91.3},
          {"peak", "side_left", 2, 16.8},
          {"side_left", "", 11, 85.4},
          {"back_left", "", 11, 91.3},
          {"peak", "", 44, 347.6}}},
        {"skirt",
         {{"front", "side_front_left", 32, 630.1},
          {"side_back_left", "side_front_left", 32, 632.1},
          {"back", "side_back_left", 32, 630.1},
          {"front", "waistband", 6, 133.6},
          {"side_front_left", "waistband", 6, 114.4},
          {"side_back_left", "waistband", 6, 114.4},
          {"back", "waistband", 6, 133.6},
          {"waistband", "waistband", 2, 36.1},
          {"front", "", 18, 345.5},
          {"side_front_left", "", 16, 322.7},
          {"side_back_left", "", 16, 322.7},
          {"back", "", 18, 345.5},
          {"waistband", "", 44, 712.5}}},
    };
}

using PlacedSide = std::pair<Place, Place>;
using RunKey = std::pair<std::string, std::string>;

struct OutlineSide {
    std::string piece;
    double length = 0.0;
};

/// All outline sides of the garment by their directed end places.
std::multimap<PlacedSide, OutlineSide> placeOutlines(const std::vector<SamplePiece>& pieces) {
    std::multimap<PlacedSide, OutlineSide> placed;
    for (const SamplePiece& piece : pieces) {
        for (const auto& [from, to] : outlineSides(piece)) {
            const Place& a = piece.vertices[static_cast<std::size_t>(from)];
            const Place& b = piece.vertices[static_cast<std::size_t>(to)];
            placed.emplace(PlacedSide{a, b}, OutlineSide{piece.name, distanceBetween(a, b)});
        }
    }
    return placed;
}

RunKey keyOf(std::string a, std::string b) {
    if (!b.empty() && b < a) {
        std::swap(a, b);
    }
    return {std::move(a), std::move(b)};
}

std::map<RunKey, OutlineRun> findRuns(const std::vector<SamplePiece>& pieces) {
    const auto placed = placeOutlines(pieces);
    std::map<RunKey, OutlineRun> runs;
    for (const auto& [side, outline] : placed) {
        // Two pieces that face the same way run along their seam in opposite directions.
        const PlacedSide opposite{side.second, side.first};
        EXPECT_EQ(placed.count(side), 1U)
            << outline.piece << ": three pieces meet, or one is turned";
        const auto partner = placed.find(opposite);
        const bool isSewn = partner != placed.end();
        if (isSewn && opposite < side) {
            continue;  // counted from the other side
        }
        OutlineRun& run = runs[keyOf(outline.piece, isSewn ? partner->second.piece : "")];
        ++run.edges;
        run.length += outline.length;
    }
    return runs;
}

class SewnSamples : public testing::TestWithParam<SewnGarment> {};

INSTANTIATE_TEST_SUITE_P(All, SewnSamples, testing::ValuesIn(sewnGarments()),
                         [](const auto& param) { return param.param.name; });

}  // namespace

TEST_P(SewnSamples, SeamsCoincideAndOnlyHemsAndOpeningsAreLeft) {
    std::map<RunKey, OutlineRun> found = findRuns(loadSample(GetParam().name));
    std::set<RunKey> expected;
    for (const OutlineRun& run : GetParam().runs) {
        for (const RunKey& key :
             {keyOf(run.first, run.second), keyOf(otherSide(run.first), otherSide(run.second))}) {
            SCOPED_TRACE(key.first + " + " + (key.second.empty() ? "nothing" : key.second));
            ASSERT_TRUE(found.contains(key));
            EXPECT_EQ(found[key].edges, run.edges);
            EXPECT_NEAR(found[key].length, run.length, kLengthSlack);
            expected.insert(key);
        }
    }
    for (const auto& [key, run] : found) {
        EXPECT_TRUE(expected.contains(key)) << key.first << " + " << key.second << ": " << run.edges
                                            << " edges, " << run.length << " mm";
    }
}

}  // namespace toile::samples
