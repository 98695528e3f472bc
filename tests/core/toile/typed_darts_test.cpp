// SPDX-License-Identifier: GPL-3.0-or-later
// Darts with typed intakes, through the whole pipeline.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/assemble/seams_file.h"
#include "core/formats/writers.h"
#include "core/pattern/dart_places.h"
#include "core/pattern/darts.h"
#include "core/pattern/half_pattern.h"
#include "core/pattern/piece_allowance.h"
#include "core/project/layer_materials.h"
#include "core/project/place_pieces.h"
#include "core/symmetry/symmetry.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/toile/mirror_images.h"

namespace toile {
namespace {

/// The shirt with its darts.
Garment dartedShirt() {
    LoadOptions options;
    const auto seams = readSeamsFile(test::sourceFile("resources/samples/tshirt.seams.json"));
    EXPECT_TRUE(seams);
    options.seams = seams ? *seams : SeamsFile{};
    Progress progress;
    auto garment = loadGarment({test::dataFile("samples/tshirt.obj")}, options, progress);
    EXPECT_TRUE(garment);
    return garment ? std::move(*garment) : Garment{};
}

std::vector<int> dartsIn(const Garment& garment) {
    std::vector<int> darts;
    for (int s = 0; s < static_cast<int>(garment.seams.seams.size()); ++s) {
        if (dartPlace(garment, s)) {
            darts.push_back(s);
        }
    }
    return darts;
}

LineSettings withTypedDarts(const Garment& garment, LineSettings lines, double intake) {
    for (const int dart : dartsIn(garment)) {
        lines.darts.push_back({garment.seams.seams[static_cast<std::size_t>(dart)].place, intake});
    }
    return lines;
}

PieceResults drawnWith(const Garment& garment, const LineSettings& lines) {
    Progress progress;
    return flattenGarment(garment, {}, progress, 0, lines);
}

/// Every way in which lines are drawn.
std::vector<LineSettings> waysToDraw() {
    LineSettings fair, mirrored;
    fair.fairing = Fairing{};
    mirrored.mirror = Mirror::Mean;
    return {{}, fair, mirrored, withPattern({})};
}

void expectTyped(const Garment& garment, const LineSettings& lines, double intake) {
    const PieceResults results = drawnWith(garment, lines);
    test::expectLengths(garment, results);
    const Pattern pattern = makePattern(garment, results, lines);
    std::size_t found = 0;
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
        for (const Error& note : results[p]->flat->notes) {
            EXPECT_NE(note.code, ErrorCode::LineNotDrawn);
        }
        for (const PieceDart& dart : findDarts(pattern.pieces[p])) {
            const auto place = dartPlace(garment, dart.seam - 1);
            ASSERT_TRUE(place);
            EXPECT_TRUE(dart.isTyped);
            EXPECT_NEAR(dart.intake, intake, 1e-6);
            const double first = (dart.mouth.from - dart.tip).norm();
            EXPECT_NEAR(first, (dart.mouth.to - dart.tip).norm(), 1e-9);
            EXPECT_NEAR(first, dart.leg, 1e-9);
            if (lines.mirror == Mirror::None) {  // else those that mirror each other are as long
                EXPECT_NEAR(first, place->firstLeg(), 1e-9);
            }
            EXPECT_NEAR(dart.angle, 2 * std::asin(intake / 2 / dart.leg), 1e-6);
            ++found;
        }
    }
    EXPECT_EQ(found, dartsIn(garment).size());
}

// A dart is laid over another leg when the grain turns. The cutting line has its cap, and the marks
// its fold: both must be those of the grain that the piece is cut with.
TEST(CutDarts, FollowTheGrainThatIsSetAfterThePatternIsMade) {
    const Garment garment = dartedShirt();
    const LineSettings lines = withPattern({});
    const PieceResults results = drawnWith(garment, lines);
    const Pattern upright = makePattern(garment, results, lines);
    std::vector<PieceSettings> settings = usualSettings(garment);
    for (PieceSettings& piece : settings) {
        piece.grain = 0;
    }
    const LaidOutPattern laid = cutAndPlace(upright, settings, {}, fabricPresets().front());
    int relaid = 0;
    for (std::size_t p = 0; p < upright.pieces.size(); ++p) {
        const PatternPiece& piece = laid.wholePattern.pieces[p];
        const std::vector<PieceDart>& before = upright.pieces[p].darts;
        ASSERT_EQ(piece.darts.size(), before.size());
        PatternPiece afresh = piece;
        addCuttingLine(afresh);
        EXPECT_EQ(piece.cuttingLine, afresh.cuttingLine);
        for (std::size_t k = 0; k < before.size(); ++k) {
            EXPECT_EQ(piece.darts[k].lay, afresh.darts[k].lay);
            relaid += piece.darts[k].lay != before[k].lay;
        }
    }
    EXPECT_GT(relaid, 0);
}

TEST(TypedDarts, HaveTheirIntakeHoweverLinesAreDrawn) {
    const Garment garment = dartedShirt();
    ASSERT_EQ(dartsIn(garment).size(), 2U);
    for (const LineSettings& lines : waysToDraw()) {
        for (const double intake : {1.0, 12.0, 35.0}) {
            SCOPED_TRACE(intake);
            expectTyped(garment, withTypedDarts(garment, lines, intake), intake);
        }
    }
}

TEST(TypedDarts, OfMirrorImagesMirrorEachOtherAlsoWhereOneIsSaid) {
    const Garment garment = dartedShirt();
    const auto symmetry = findSymmetry(garment);
    ASSERT_TRUE(symmetry);
    for (LineSettings lines : {waysToDraw()[2], waysToDraw()[3]}) {
        lines = withTypedDarts(garment, lines, 20);
        const PieceResults both = drawnWith(garment, lines);
        test::expectMirrorImages(garment, *symmetry, both);
        const auto first = dartPlace(garment, dartsIn(garment)[0]);
        const auto second = dartPlace(garment, dartsIn(garment)[1]);
        ASSERT_TRUE(first && second);
        if (first->piece == second->piece) {
            lines.darts.pop_back();
            const PieceResults one = drawnWith(garment, lines);
            const auto p = static_cast<std::size_t>(first->piece);
            EXPECT_LT((one[p]->flat->Q - both[p]->flat->Q).cwiseAbs().maxCoeff(), 1e-6);
        }
    }
}

TEST(TypedDarts, OutOfReachLeaveTheirPieceExactWithANote) {
    const Garment garment = dartedShirt();
    const int dart = dartsIn(garment)[0];
    const auto place = dartPlace(garment, dart);
    LineSettings lines;
    lines.darts.push_back({garment.seams.seams[static_cast<std::size_t>(dart)].place,
                           place->firstLeg() + place->secondLeg()});
    const PieceResults drawn = drawnWith(garment, lines), exact = drawnWith(garment, {});
    for (std::size_t p = 0; p < drawn.size(); ++p) {
        EXPECT_EQ(drawn[p]->flat->Q, exact[p]->flat->Q);
        const bool isNoted =
            std::ranges::count(drawn[p]->flat->notes, ErrorCode::LineNotDrawn, &Error::code) == 1;
        EXPECT_EQ(isNoted, static_cast<int>(p) == place->piece);
    }
}

TEST(TypedDarts, AreNamedInTheReport) {
    const Garment garment = dartedShirt();
    const LineSettings lines = withTypedDarts(garment, withPattern({}), 15);
    const PieceResults results = drawnWith(garment, lines);
    const auto report =
        nlohmann::json::parse(writeReport(garment, results, makePattern(garment, results, lines)));
    int found = 0;
    for (const auto& piece : report["pieces"]) {
        for (const auto& dart : piece.value("darts", nlohmann::json::array())) {
            EXPECT_NEAR(dart["intake"].get<double>(), 15, 1e-6);
            EXPECT_TRUE(dart["intake_typed"].get<bool>());
            ++found;
        }
    }
    EXPECT_EQ(found, 2);
}

TEST(TypedDarts, AreLaidAsSaid) {
    const Garment garment = dartedShirt();
    const int dart = dartsIn(garment)[0];
    for (const DartLay lay : {DartLay::First, DartLay::Second}) {
        LineSettings lines = withPattern({});
        lines.darts.push_back(
            {garment.seams.seams[static_cast<std::size_t>(dart)].place, std::nullopt, lay});
        const Pattern pattern = makePattern(garment, drawnWith(garment, lines), lines);
        int found = 0;
        for (const PatternPiece& piece : pattern.pieces) {
            for (const PieceDart& there : findDarts(piece)) {
                if (there.seam == dart + 1) {
                    EXPECT_EQ(there.lay, lay);
                    EXPECT_FALSE(there.isTyped);
                    ++found;
                }
            }
        }
        EXPECT_EQ(found, 1);
    }
}

TEST(DartPlaces, AreSeamsThatMeetAtATip) {
    const Garment garment = dartedShirt();
    for (const int dart : dartsIn(garment)) {
        const auto place = dartPlace(garment, dart);
        const Seam& seam = garment.seams.seams[static_cast<std::size_t>(dart)];
        EXPECT_NEAR(place->firstLeg(), place->secondLeg(), 1e-9);
        EXPECT_NEAR(place->firstLeg(), seam.length3d[0], 1e-9);
        EXPECT_TRUE(isWithin(*place, 1e6, place->tip));
        EXPECT_FALSE(isWithin(*place, 1e6, place->from));
    }
}

}  // namespace
}  // namespace toile
