// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines that cross themselves: bounded effort, the cut that parts them, and fair lines.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <numeric>
#include <string>

#include <gtest/gtest.h>

#include "core/diagnose/doubt.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/flat_trouble.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// A flounce 80 mm wide whose inner edge is 600 mm long, cut as the options say.
Garment flounceGarment(double degrees, bool autoCut, int columns = 120) {
    const double inner = 600 / (degrees * std::numbers::pi / 180);
    auto piece = std::make_shared<Piece>(
        *test::asPiece(test::flounce(degrees, inner, inner + 80, columns, 5), "flounce"));
    piece->sourceVertex.resize(static_cast<std::size_t>(piece->mesh.V.rows()));
    piece->sourceFace.resize(static_cast<std::size_t>(piece->mesh.F.rows()));
    std::iota(piece->sourceVertex.begin(), piece->sourceVertex.end(), 0);
    std::iota(piece->sourceFace.begin(), piece->sourceFace.end(), 0);
    Garment garment;
    garment.pieces = garment.uncut = {piece};
    LoadOptions options;
    options.autoCut = autoCut;
    Progress progress;
    auto cut = cutGarment(garment, options, progress);
    EXPECT_TRUE(cut);
    return std::move(*cut);
}

PieceResults solvedFlat(const Garment& garment, const LineSettings& lines = {}) {
    Progress progress;
    return flattenGarment(garment, {}, progress, 0, lines);
}

int crossingCountOf(const PieceResults& results) {
    int sum = 0;
    for (const auto& result : results) {
        sum += result->quality ? result->quality->outlineCrossings : 0;
    }
    return sum;
}

TEST(CrossingOutlines, ArePartedByTheCutThatTheirMessageNames) {
    const PieceResults whole = solvedFlat(flounceGarment(690, false));
    EXPECT_TRUE(crossesItself(*whole[0]));
    const auto& notes = whole[0]->flat->notes;
    const auto note = std::ranges::find(notes, ErrorCode::OutlineCrosses, &Error::code);
    ASSERT_NE(note, notes.end());
    EXPECT_NE(note->detail.find("), 80 mm"), std::string::npos) << note->detail;

    const Garment cut = flounceGarment(690, true);
    ASSERT_EQ(cut.pieces.size(), 2U);
    EXPECT_EQ(cut.pieces[0]->name, "flounce 1");
    EXPECT_EQ(cut.pieces[1]->name, "flounce 2");
    ASSERT_EQ(cut.cuts.size(), 1U);
    EXPECT_EQ(cut.cuts[0].author, CutAuthor::Automatic);
    EXPECT_NEAR(cut.cuts[0].length, 80, 1);
    EXPECT_EQ(crossingCountOf(solvedFlat(cut)), 0);

    // The same again is handed on by pointer.
    LoadOptions options;
    options.autoCut = true;
    Progress progress;
    EXPECT_EQ(cutGarment(cut, options, progress)->pieces, cut.pieces);
}

TEST(CrossingOutlines, AreNotPartedWhereThereAreNone) {
    const Garment garment = flounceGarment(340, true);
    ASSERT_EQ(garment.pieces.size(), 1U);
    EXPECT_EQ(garment.pieces, garment.uncut);
    EXPECT_TRUE(garment.cuts.empty());
}

/// Steps (Progress::step) of all flattenings that --auto-cut and the pattern of a flounce take.
double stepsFor(double degrees) {
    double steps = 0;
    const auto count = [&](const Piece& piece, const FlattenOptions& options) {
        const Progress progress;
        EXPECT_TRUE(flatten(piece, options, progress));
        steps += std::log(1 - progress.fraction()) / std::log(0.9);
    };
    const Garment garment = flounceGarment(degrees, true);
    if (garment.pieces.size() > 1) {
        count(*garment.uncut[0], {Method::Curvature});
        count(*garment.uncut[0], {.quality = Quality::Draft});
    }
    for (const auto& piece : garment.pieces) {
        count(*piece, {Method::Curvature});  // does not cross
        count(*piece, {});
    }
    return steps;
}

TEST(CrossingOutlines, TakeFewStepsToFindThatTheyNeedACut) {
    EXPECT_LE(stepsFor(690), 10 * stepsFor(360));
}

TEST(CrossingOutlines, MovedApartAtMuchStrainAreADoubtOrStillCross) {
    const Garment garment = flounceGarment(400, false, 300);
    const PieceResults results = solvedFlat(garment);
    EXPECT_TRUE(crossingCountOf(results) > 0 || !findDoubts(garment, results).empty());
    const Garment cut = flounceGarment(400, true, 300);
    EXPECT_EQ(cut.pieces.size(), 2U);
    const PieceResults parts = solvedFlat(cut);
    EXPECT_EQ(crossingCountOf(parts), 0);
    EXPECT_TRUE(findDoubts(cut, parts).empty());
}

/// Fair lines of every garment for tailors cross nowhere where the exact outlines do not.
TEST(CrossingOutlinesSlow, AreNotMadeByFairLines) {
    TOILE_NEEDS_SHARED(test::sharedFile("tailor"));
    for (const auto& entry : std::filesystem::directory_iterator(test::sharedFile("tailor"))) {
        if (entry.path().extension() != ".obj") {
            continue;
        }
        LoadOptions options;
        options.autoCut = true;
        options.unit = LengthUnit::Decimetre;
        Progress progress;
        const auto garment = loadGarment({entry.path()}, options, progress);
        ASSERT_TRUE(garment) << entry.path();
        LineSettings lines;
        lines.fairing = Fairing{};
        for (const auto& result : solvedFlat(*garment, lines)) {
            if (result->quality && result->exact) {
                EXPECT_LE(result->quality->outlineCrossings,
                          result->exact->quality->outlineCrossings)
                    << entry.path() << ' ' << result->piece->name;
            }
        }
    }
}

}  // namespace
}  // namespace toile
