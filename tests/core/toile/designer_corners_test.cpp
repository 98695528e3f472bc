// SPDX-License-Identifier: GPL-3.0-or-later
// Corners and fair lines against the panels that the designer drew.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "core/pattern/fair_outline.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/line_figures.h"
#include "tests/core/support/sewn_sample.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"
#include "tests/core/support/wrinkles.h"

namespace toile {
namespace {

constexpr double kCentimetre = 10;  // mm

struct FairGarment {
    Garment garment;
    PieceResults results;
    std::vector<OutlineSegments> segments;
};

FairGarment drawnFair(const std::filesystem::path& file, const Fairing& fairing = {}) {
    FairGarment made;
    Progress progress;
    auto garment = loadGarment({file}, {}, progress);
    EXPECT_TRUE(garment) << file;
    if (garment) {
        made.garment = std::move(*garment);
        LineSettings lines;
        lines.fairing = fairing;
        made.results = flattenGarment(made.garment, {}, progress, 0, lines);
        made.segments = findSegments(made.garment, exactResults(made.results), lines);
    }
    return made;
}

test::CornerScore cornerScoreOf(const FairGarment& drawn) {
    test::CornerScore score;
    for (std::size_t p = 0; p < drawn.garment.pieces.size(); ++p) {
        if (drawn.garment.pieces[p]->reference && drawn.results[p]->flat) {
            score.add(*drawn.garment.pieces[p], drawn.segments[p]);
        }
    }
    return score;
}

/// Of the fair lines, over that of the designer's panels.
double unevenness(const FairGarment& drawn) {
    test::Variation designer, fair;
    for (std::size_t p = 0; p < drawn.garment.pieces.size(); ++p) {
        const Piece& piece = *drawn.garment.pieces[p];
        const auto cuts = test::referenceCuts(drawn.garment, p, drawn.segments[p]);
        designer.add((*piece.reference)(piece.boundary, Eigen::all), cuts);
        fair.add(drawn.results[p]->flat->Q(piece.boundary, Eigen::all), cuts);
    }
    return fair.sum / designer.sum;
}

/// How many lines stray further than 1 mm, and how many notes say so.
struct Straying {
    int lines = 0, notes = 0;
    double farthest = 0;  ///< mm
};

Straying strayingOf(const FairGarment& drawn) {
    Straying straying;
    for (const auto& result : drawn.results) {
        if (!result->flat || !result->flat->line) {
            continue;
        }
        EXPECT_LE(result->quality->maxTargetLengthError, 1e-9) << result->piece->name;
        const double farthest = result->flat->line->farthest;
        straying.lines += farthest > 1 ? 1 : 0;
        straying.farthest = std::max(straying.farthest, farthest);
        straying.notes += static_cast<int>(
            std::ranges::count(result->flat->notes, ErrorCode::LineStrays, &Error::code));
    }
    return straying;
}

void record(const std::string& what, const test::CornerScore& score) {
    testing::Test::RecordProperty(what + " recall", std::to_string(score.recall()));
    testing::Test::RecordProperty(what + " precision", std::to_string(score.precision()));
}

TEST(DesignersCorners, AreFoundOnGarmentsWithTruth) {
    TOILE_NEEDS_SHARED(test::sharedFile("garments"));
    test::CornerScore all;
    for (const char* name :
         {"tee_sim", "dress", "polo", "longsleeve", "tshirt", "skirt_clo", "wetsuit_patches",
          "dress14_pieces", "tee_sim_pieces", "polo_pieces", "arcsim/tshirt", "arcsim/pants3"}) {
        const auto file = test::sharedFile(std::string("garments/") + name + ".obj");
        if (std::filesystem::exists(file)) {
            const FairGarment drawn = drawnFair(file);
            const test::CornerScore score = cornerScoreOf(drawn);
            record(name, score);
            all.add(score);
            EXPECT_EQ(strayingOf(drawn).notes, 0) << name;
        }
    }
    record("all", all);
    EXPECT_GE(all.recall(), 0.96);
    EXPECT_GE(all.precision(), 0.95);
}

/// Bumps of 28 to 47 mm at half their height, and of 48 to 80 mm.
TEST(DesignersCorners, AreFoundUnderWrinkles) {
    TOILE_NEEDS_SHARED(test::sharedFile("garments"));
    for (const double widening : {1.0, 1.7}) {
        test::CornerScore all;
        for (const char* name : {"polo", "tee_sim", "dress"}) {
            const test::TemporaryFolder folder;
            const auto file = test::sharedFile(std::string("garments/") + name + ".obj");
            const FairGarment drawn =
                drawnFair(test::writeWrinkled(file, kCentimetre, folder.path(), widening));
            all.add(cornerScoreOf(drawn));
            const double fair = unevenness(drawn);
            RecordProperty(std::string(name) + " fair over designer", std::to_string(fair));
            EXPECT_LE(fair, 1.3) << name << ' ' << widening;
            EXPECT_EQ(strayingOf(drawn).notes, strayingOf(drawn).lines) << name;
        }
        if (widening == 1) {
            record("all", all);
            EXPECT_GE(all.recall(), 0.96);
            EXPECT_GE(all.precision(), 0.95);
        }
    }
}

TEST(LinesOfWrinkledGarments, StrayFurtherUnlessAToleranceIsTyped) {
    const test::TemporaryFolder folder, wrinkled;
    const std::string sewn = test::writeSewnSample("trousers", folder.path()).string() + ".obj";
    const auto rough = test::writeWrinkled(sewn, kCentimetre, wrinkled.path(), 0.7);
    const Straying plain = strayingOf(drawnFair(sewn));
    EXPECT_LE(plain.farthest, 1);
    EXPECT_EQ(plain.notes, 0);
    const FairGarment loose = drawnFair(rough), strict = drawnFair(rough, {0.9});
    const Straying far = strayingOf(loose), near = strayingOf(strict);
    EXPECT_GT(far.lines, 0);
    EXPECT_EQ(far.notes, far.lines);
    EXPECT_LE(far.farthest, kWrinkledTolerance);
    EXPECT_LE(near.farthest, 1);
    EXPECT_EQ(near.notes, 0);
    EXPECT_LT(unevenness(loose), 0.5 * unevenness(strict));
}

/// The panels of samples are flattenings, whose curves turn by some 30 degrees at the vertices of
/// coarse meshes: these are no corners, and the recall that is asked for is lower.
TEST(CornersOfSamples, AreFoundWithAndWithoutWrinkles) {
    test::CornerScore plain, under;
    for (const char* name : {"bodice", "trousers", "tshirt"}) {
        const test::TemporaryFolder folder, wrinkled;
        const std::string sewn = test::writeSewnSample(name, folder.path()).string() + ".obj";
        plain.add(cornerScoreOf(drawnFair(sewn)));
        under.add(
            cornerScoreOf(drawnFair(test::writeWrinkled(sewn, kCentimetre, wrinkled.path()))));
    }
    for (const test::CornerScore& score : {plain, under}) {
        EXPECT_GE(score.recall(), 0.93);
        EXPECT_GE(score.precision(), 0.95);
    }
}

}  // namespace
}  // namespace toile
