// SPDX-License-Identifier: GPL-3.0-or-later
// The draped dress of 14 panels apart: neighbours share no vertex and are sampled differently, the
// skirt is laid in pleats, and the true stitches are known.
#include <cstdio>
#include <fstream>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/seam/find_seams.h"
#include "core/toile/pipeline.h"
#include "tests/core/seam/seam_score.h"
#include "tests/core/seam/seam_shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// The stitched lines of the seams file; stitches to the inside of a panel are no outline and are
/// left out, repeated seams count once.
std::vector<test::SewnLine> readStitches(const std::filesystem::path& path, const Pieces& pieces,
                                         const test::BoundaryPlaces& places) {
    std::ifstream stream(path);
    const auto json = nlohmann::json::parse(stream);
    const auto pieceOf = [&](int vertex) {
        for (std::size_t p = 0; p < pieces.size(); ++p) {
            if (places.arcOf(static_cast<int>(p), vertex) >= 0) {
                return static_cast<int>(p);
            }
        }
        return -1;
    };
    std::vector<test::SewnLine> lines;
    std::set<std::vector<int>> seen;
    for (const auto& seam : json["seams"]) {
        int beforeA = -1, beforeB = -1;
        double lastA = 0, lastB = 0;
        std::vector<int> ids;
        std::vector<test::SewnLine> part;
        for (const auto& stitch : seam["stitches"]) {
            const int a = stitch[0], b = stitch[1], c = stitch[2];
            const double t = stitch[3];
            ids.push_back(a);
            ids.push_back(b);
            const int pa = pieceOf(a), pb = pieceOf(b);
            if (pa < 0 || pb < 0 || places.arcOf(pb, c) < 0) {
                beforeA = -1;
                continue;
            }
            const double sa = places.arcOf(pa, a);
            const double sb =
                places.arcOf(pb, b) + t * places.way(pb, places.arcOf(pb, b), places.arcOf(pb, c));
            if (beforeA == pa && beforeB == pb) {
                part.push_back({pa, lastA, lastA + places.way(pa, lastA, sa), pb, lastB,
                                lastB + places.way(pb, lastB, sb)});
            }
            beforeA = pa, beforeB = pb, lastA = sa, lastB = sb;
        }
        if (seen.insert(ids).second) {
            lines.insert(lines.end(), part.begin(), part.end());
        }
    }
    return lines;
}

class Dress14 : public testing::Test {
protected:
    void SetUp() override {
        const auto mesh = test::sharedFile("garments/dress14_pieces.obj");
        stitches_ = test::sharedFile("garments/dress14_pieces.seams.json");
        TOILE_NEEDS_SHARED(mesh);
        TOILE_NEEDS_SHARED(stitches_);
        Progress progress;
        const auto garment = loadGarment({mesh}, {.unit = LengthUnit::Metre}, progress);
        ASSERT_TRUE(garment);
        pieces_ = garment->pieces;
    }

    test::SeamScore measured(const Pieces& pieces, const char* what) const {
        const test::BoundaryPlaces places(pieces);
        const auto known = readStitches(stitches_, pieces, places);
        const SeamGraph graph = findSeams(pieces);
        test::expectValid(graph, pieces);
        const test::SeamScore s = test::score(graph, known, places, 3);
        std::printf(
            "dress14, %s: recall %.1f %% of %.0f mm of known lines, %.1f %% of the sewn outlines; "
            "precision %.1f %% of %.0f mm, %.1f %% by way of layers; wrong pairs: %zu, "
            "by way of layers: %zu\n",
            what, 100 * s.recall(), s.known, 100 * s.placeRecall(), 100 * s.precision(), s.claimed,
            100 * s.layeredPrecision(), s.wrong.size(), s.byLayer.size());
        return s;
    }

    Pieces pieces_;
    std::filesystem::path stitches_;
};

TEST_F(Dress14, SeamsOfDifferentSamplingAreFound) {
    const test::SeamScore s = measured(pieces_, "as draped");
    EXPECT_GE(s.recall(), 0.96);
    EXPECT_GE(s.placeRecall(), 0.98);
    EXPECT_GE(s.precision(), 0.98);
    EXPECT_GE(s.layeredPrecision(), 0.995);
    EXPECT_EQ(s.wrong, std::vector<std::string>());
}

TEST_F(Dress14, ARoughDrapeMakesNoWrongPairs) {
    for (const double noise : {0.1, 0.5}) {
        std::mt19937 random(11);
        Pieces shaken;
        for (const auto& piece : pieces_) {
            auto copy = std::make_shared<Piece>(*piece);
            for (Eigen::Index k = 0; k < copy->mesh.V.size(); ++k) {
                const double off = static_cast<double>(random() % 2001) / 1000 - 1;
                copy->mesh.V.data()[k] += noise * off;  // mm
            }
            shaken.push_back(std::move(copy));
        }
        const test::SeamScore s = measured(shaken, "shaken");
        EXPECT_GE(s.recall(), 0.93);
        EXPECT_GE(s.layeredPrecision(), 0.99);
        EXPECT_EQ(s.wrong, std::vector<std::string>());
    }
}

}  // namespace
}  // namespace toile
