// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/pattern_faults.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/core/prove/proved_garment.h"
#include "tests/core/support/laid_rows.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile::prove {
namespace {

const test::ProvedGarment& trousers() {
    static const test::ProvedGarment garment(test::sourceFile("resources/samples/trousers.obj"));
    return garment;
}

std::vector<Finding> faultsOf(const PatternFile& file) {
    ProofOrder order;
    order.file = file;
    const auto fresh = freshCloth(trousers().source(), order, {});
    EXPECT_TRUE(fresh);
    return fresh ? fresh->faults : std::vector<Finding>();
}

std::string kindsOf(const std::vector<Finding>& faults) {
    std::string kinds;
    for (const Finding& fault : faults) {
        kinds += std::string(name(fault.kind)) + ": " + fault.reason + "\n";
    }
    return kinds;
}

void turnOver(FilePiece& piece) {
    test::changePoints(piece, [](Eigen::Ref<Eigen::RowVector2d> p) { p.x() = -p.x(); });
    for (Points2* line : {&piece.cut, &piece.sew}) {
        *line = line->colwise().reverse().eval();
    }
}

TEST(PatternFaults, OurOwnFileHasNone) {
    const auto fresh = freshCloth(trousers().source(), {}, {});
    ASSERT_TRUE(fresh);
    EXPECT_EQ(kindsOf(fresh->faults), "");
    EXPECT_EQ(kindsOf(faultsOf(trousers().file())), "");
    for (const ProvenSeam& seam : fresh->seams) {
        EXPECT_LT(std::abs(seam.slip), 0.01);
    }
}

TEST(PatternFaults, LengthsOfAnotherUnitAreNamedBeforeSewing) {
    for (const auto& [times, unit] :
         {std::pair(1000.0, "m"), {10.0, "cm"}, {0.1, "mm"}, {25.4, "in"}}) {
        ProofOrder order;
        order.file = trousers().file();
        for (FilePiece& piece : order.file->pieces) {
            const double by = times;
            test::changePoints(piece, [by](Eigen::Ref<Eigen::RowVector2d> p) { p *= by; });
        }
        order.file->unit = times < 1 ? LengthUnit::Millimetre : *parseLengthUnit(unit);
        const auto fresh = freshCloth(trousers().source(), order, {});
        ASSERT_FALSE(fresh) << times;
        EXPECT_EQ(fresh.error().code, ErrorCode::NoGeometry);
        const std::string expected = times < 1 ? "--pattern-unit cm" : "--pattern-unit mm";
        EXPECT_NE(fresh.error().detail.find(expected), std::string::npos) << fresh.error().detail;
    }
}

TEST(PatternFaults, NamesPiecesThatWereSwapped) {
    PatternFile file = trousers().file();
    FilePiece &left = test::ProvedGarment::pieceOf(file, "front_left"),
              &right = test::ProvedGarment::pieceOf(file, "front_right");
    std::swap(left.name, right.name);
    std::swap(left.id, right.id);
    const auto faults = faultsOf(file);
    for (const auto& [piece, other] :
         {std::pair("front_left", "front_right"), std::pair("front_right", "front_left")}) {
        const int number = trousers().pieceCalled(piece), rather = trousers().pieceCalled(other);
        EXPECT_TRUE(std::ranges::any_of(faults, [&](const Finding& fault) {
            return fault.kind == FindingKind::OtherFits &&
                   fault.pieces == std::vector{number, rather};
        })) << kindsOf(faults);
    }
}

TEST(PatternFaults, NamesAPieceThatIsMirroredAndTurnsItOver) {
    PatternFile file = trousers().file();
    turnOver(test::ProvedGarment::pieceOf(file, "back_left"));
    ProofOrder order;
    order.file = file;
    const auto fresh = freshCloth(trousers().source(), order, {});
    ASSERT_TRUE(fresh);
    ASSERT_EQ(fresh->faults.size(), 1u) << kindsOf(fresh->faults);
    EXPECT_EQ(fresh->faults[0].kind, FindingKind::Mirrored);
    EXPECT_EQ(fresh->faults[0].subject.name, "back_left");
    EXPECT_TRUE(fresh->faults[0].reason.starts_with("back_left ")) << kindsOf(fresh->faults);
    for (const ProvenSeam& seam : fresh->seams) {
        EXPECT_LT(std::abs(seam.slip), 0.01);
    }
}

/// The files of others have no names of ours.
void takeNames(PatternFile& file) {
    for (FilePiece& piece : file.pieces) {
        piece.name = piece.id = "";
    }
}

TEST(PatternFaults, WithoutNamesEachOfAPairIsFoundByItsShape) {
    PatternFile file = trousers().file();
    takeNames(file);
    EXPECT_EQ(kindsOf(faultsOf(file)), "");
}

TEST(PatternFaults, WithoutNamesAMirroredPieceThatIsNoOthersImageIsNamed) {
    sew::CutCloth cut;
    cut.V.resize(3, 3);
    cut.V << 0, 0, 0, 300, 0, 0, 0, 400, 0;
    cut.F.resize(1, 3);
    cut.F << 0, 1, 2;
    cut.pieceOf = {0};
    const test::TemporaryFolder folder;
    LoadOptions options;
    options.unit = LengthUnit::Millimetre;
    options.up = UpAxis::Y;
    const test::ProvedGarment pennant(folder.write("pennant.obj", test::objectsOf(cut)), options);
    ProofOrder order;
    order.file = pennant.file();
    takeNames(*order.file);
    for (const char* kinds : {"", "mirrored"}) {
        const auto fresh = freshCloth(pennant.source(), order, {});
        ASSERT_TRUE(fresh);
        EXPECT_EQ(kindsOf(fresh->faults).substr(0, 8), kinds);
        turnOver(order.file->pieces.front());
    }
}

TEST(PatternFaults, APairThatIsDrawnOnceIsAllThere) {
    PatternFile file = trousers().file();
    for (const char* half : {"front", "back"}) {
        FilePiece& left = test::ProvedGarment::pieceOf(file, std::string(half) + "_left");
        left.mirroredQuantity = 1;
        left.name = left.id = half;
        const FilePiece& right = test::ProvedGarment::pieceOf(file, std::string(half) + "_right");
        file.pieces.erase(file.pieces.begin() + (&right - file.pieces.data()));
    }
    ASSERT_EQ(file.pieces.size(), 3u);
    ProofOrder order;
    order.file = file;
    const auto fresh = freshCloth(trousers().source(), order, {});
    ASSERT_TRUE(fresh);
    EXPECT_EQ(kindsOf(fresh->faults), "");
    for (const auto& places : fresh->placeOf) {
        EXPECT_FALSE(places.empty());
    }
}

TEST(PatternFaults, NamesSeamsThatWereShortened) {
    PatternFile file = trousers().file();
    FilePiece& piece = test::ProvedGarment::pieceOf(file, "front_left");
    const double hem = piece.cut.col(1).minCoeff();
    test::changePoints(piece, [hem](Eigen::Ref<Eigen::RowVector2d> p) {
        p.y() += p.y() < hem + 40 ? 10 : 0;  // 10 mm are folded away
    });
    const auto faults = faultsOf(file);
    ASSERT_FALSE(faults.empty());
    const int number = trousers().pieceCalled("front_left");
    for (const Finding& fault : faults) {
        EXPECT_EQ(fault.kind, FindingKind::SeamSlips) << kindsOf(faults);
        EXPECT_NEAR(fault.badness, 10, 1) << kindsOf(faults);
        EXPECT_TRUE(std::ranges::find(fault.pieces, number) != fault.pieces.end());
    }
}

TEST(PatternFaults, NamesWhatIsMissingAndWhatIsTooMuch) {
    PatternFile file = trousers().file();
    FilePiece& band = test::ProvedGarment::pieceOf(file, "waistband");
    band.name = band.id = "pocket";
    band.cut.resize(4, 2);
    band.cut << 0, 0, 150, 0, 150, 170, 0, 170;
    band.sew.resize(0, 2);
    band.holes.clear();
    const auto faults = faultsOf(file);
    ASSERT_EQ(faults.size(), 2U) << kindsOf(faults);
    EXPECT_EQ(faults[0].kind, FindingKind::NotThere);
    EXPECT_EQ(faults[0].subject.name, "waistband");
    EXPECT_EQ(faults[1].kind, FindingKind::NotNeeded);
    EXPECT_NE(faults[1].reason.find(" pocket "), std::string::npos) << kindsOf(faults);
}

TEST(PatternFaults, OurOwnFacingsAreNotTooMuch) {
    const ExportSource& plain = trousers().source();
    const int waistband = trousers().pieceCalled("waistband");
    LineSettings lines;
    lines.facings.push_back(
        {"facing of the waist", {plain.laid().pattern.pieces[waistband].segments[0].place}, 30});
    const LaidOutPattern laid = inRows(trousers().garment(), plain.results(), lines);
    ASSERT_FALSE(laid.pattern.facings.empty());
    const ExportSource source(trousers().garment(), plain.results(), laid, {}, {}, lines);
    const auto file = readPattern(writeApparelDxf(source), PatternFileKind::Dxf, "pattern.dxf");
    ASSERT_TRUE(file);
    EXPECT_GT(file->pieces.size(), trousers().file().pieces.size());
    ProofOrder order;
    order.file = *file;
    const auto ofOurs = freshCloth(source, order, {}), readBack = freshCloth(source, {}, {});
    ASSERT_TRUE(ofOurs && readBack);
    EXPECT_EQ(kindsOf(ofOurs->faults), "");
    EXPECT_EQ(kindsOf(readBack->faults), "");
    // A garment that has none says so.
    const auto other = faultsOf(*file);
    EXPECT_TRUE(std::ranges::any_of(other, [](const Finding& fault) {
        return fault.kind == FindingKind::NotNeeded &&
               fault.reason.find("FACING_OF_THE_WAIST") != std::string::npos;
    })) << kindsOf(other);
}

TEST(PatternFaults, LeavesOutAPieceWhoseOutlineCrossesItself) {
    PatternFile file = trousers().file();
    FilePiece& band = test::ProvedGarment::pieceOf(file, "waistband");
    band.cut.resize(4, 2);
    band.cut << 0, 0, 700, 80, 700, 0, 0, 90;
    band.sew.resize(0, 2);
    ProofOrder order;
    order.file = file;
    const auto fresh = freshCloth(trousers().source(), order, {});
    ASSERT_TRUE(fresh);
    EXPECT_TRUE(std::ranges::any_of(fresh->faults, [](const Finding& fault) {
        return fault.kind == FindingKind::NotThere && fault.subject.name == "waistband" &&
               fault.reason.find("crosses itself") != std::string::npos;
    })) << kindsOf(fresh->faults);
    for (std::size_t p = 0; p < fresh->placeOf.size(); ++p) {
        EXPECT_EQ(fresh->placeOf[p].empty(), trousers().garment().pieces[p]->name == "waistband");
    }
}

TEST(PatternFaults, NamesSeamsOfAPatternThatIsTooLarge) {
    PatternFile file = trousers().file();
    for (FilePiece& piece : file.pieces) {
        test::changePoints(piece, [](Eigen::Ref<Eigen::RowVector2d> p) { p *= 1.05; });
    }
    const auto faults = faultsOf(file);
    EXPECT_FALSE(faults.empty());
    for (const Finding& fault : faults) {
        EXPECT_EQ(fault.kind, FindingKind::LengthDiffers) << kindsOf(faults);
    }
}

}  // namespace
}  // namespace toile::prove
