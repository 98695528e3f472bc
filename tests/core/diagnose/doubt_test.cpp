// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnose/doubt.h"

#include <memory>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// Pieces that lie flat as they are.
struct FlatGarment {
    Garment garment;
    PieceResults results;

    std::shared_ptr<PieceResult> add(const MeshArrays& mesh, const std::string& name) {
        const auto piece = std::make_shared<Piece>(makePiece(name, mesh));
        piece->id = {results.size() + 1};
        auto result = std::make_shared<PieceResult>();
        result->piece = piece;
        result->flat.emplace();
        result->flat->Q = mesh.V.leftCols<2>();
        garment.pieces.push_back(piece);
        results.push_back(result);
        return result;
    }

    std::vector<Finding> doubts() const { return findDoubts(garment, results); }
};

/// A strip of ten cells of which so many are wider on the cloth by a factor.
void widenFirstCells(PieceResult& result, int cells, double factor) {
    Points2& Q = result.flat->Q;
    const double from = Q.col(0).minCoeff();
    const double width = (Q.col(0).maxCoeff() - from) / 10 * cells;
    for (auto row : Q.rowwise()) {
        const double x = row[0] - from;
        row[0] = from + (x < width ? factor * x : x + (factor - 1) * width);
    }
}

TEST(Doubt, NothingIsInDoubtWhereNothingIsStrained) {
    FlatGarment flat;
    flat.add(test::planeGrid(10, 1, 50), "strip");
    EXPECT_TRUE(flat.doubts().empty());
}

TEST(Doubt, StrainBeyondClothIsOneWhereItIsOfMoreThanSingleTriangles) {
    for (const double factor : {1.6, 0.6}) {  // too wide and too narrow alike
        FlatGarment flat;
        const auto strained = flat.add(test::planeGrid(10, 1, 50), "strip");
        widenFirstCells(*strained, 2, factor);
        const auto doubts = flat.doubts();
        ASSERT_EQ(doubts.size(), 1U) << factor;
        EXPECT_EQ(doubts[0].kind, FindingKind::StrainBeyondCloth);
        EXPECT_EQ(doubts[0].pieces, std::vector<int>{0});
        EXPECT_NEAR(doubts[0].badness, 0.2, 1e-12);  // a fifth of the worn area
        EXPECT_NE(sentence(doubts[0]).find("strip: strain exceeds 25 % on 20.0 %"),
                  std::string::npos)
            << sentence(doubts[0]);
    }
}

TEST(Doubt, StrainThatClothTakesIsNone) {
    FlatGarment flat;
    widenFirstCells(*flat.add(test::planeGrid(10, 1, 50), "strip"), 2, 1 / 1.2);
    EXPECT_TRUE(flat.doubts().empty());
    EXPECT_FALSE(hasFaults(flat.garment, flat.results, flat.doubts()));
}

TEST(Doubt, StrainIsAFaultByItsMeanOrWhereMuchOfItIsHigh) {
    struct Case {
        int cells;
        double strain;
        bool isDoubt, isFault;
    };
    for (const Case& known : {Case{10, 0.11, false, false}, Case{10, 0.13, true, true},
                              Case{2, 0.24, false, false}, Case{2, 0.35, true, true}}) {
        FlatGarment flat;
        widenFirstCells(*flat.add(test::planeGrid(10, 1, 50), "strip"), known.cells,
                        1 / (1 + known.strain));
        const auto doubts = flat.doubts();
        EXPECT_EQ(!doubts.empty(), known.isDoubt) << known.cells << " of " << known.strain;
        EXPECT_EQ(!doubts.empty() && doubts[0].severity == Severity::Fault, known.isFault)
            << known.strain;
        EXPECT_EQ(hasFaults(flat.garment, flat.results, doubts), known.isFault);
        if (known.isDoubt) {
            EXPECT_NE(sentence(doubts[0]).find("(--auto-cut --max-strain 5)"), std::string::npos);
        }
    }
}

TEST(Doubt, AChosenFabricThatStretchesTakesMore) {
    FlatGarment flat;
    widenFirstCells(*flat.add(test::planeGrid(10, 1, 50), "strip"), 10, 1 / 1.3);
    const auto isFault = [&flat](const char* fabric) {
        const auto doubts = findDoubts(flat.garment, flat.results, {*fabricPreset(fabric)});
        return hasFaults(flat.garment, flat.results, doubts);
    };
    EXPECT_TRUE(isFault("unstated"));
    EXPECT_TRUE(isFault("denim"));
    EXPECT_FALSE(isFault("spandex"));
}

TEST(Doubt, WhatWastesClothIsAFault) {
    FlatGarment flat;
    const auto result = flat.add(test::planeGrid(2, 2, 50), "panel");
    const auto isFaulty = [&flat] { return hasFaults(flat.garment, flat.results, {}); };
    result->quality.emplace();
    EXPECT_FALSE(isFaulty());
    result->quality->outlineCrossings = 1;
    EXPECT_TRUE(isFaulty());
    *result->quality = {};
    result->quality->flippedTriangles = 1;
    EXPECT_TRUE(isFaulty());
    *result->quality = {};
    result->error = Error{ErrorCode::LeftOut};
    EXPECT_FALSE(isFaulty());
    result->error = Error{ErrorCode::SeveralLoops};
    EXPECT_TRUE(isFaulty());
    result->error.reset();
    flat.garment.problems = {{ErrorCode::NoBodySeen}};
    EXPECT_FALSE(isFaulty());
    flat.garment.problems = {{ErrorCode::CutImpossible}};
    EXPECT_TRUE(isFaulty());
}

TEST(Doubt, FilesAreInDoubtByTheirAxisAndTheirSide) {
    Garment garment;
    const auto file = std::make_shared<SourceFile>();
    file->path = "skirt.obj";
    garment.files = {file};
    EXPECT_TRUE(findDoubts(garment, {}).empty());
    file->upInDoubt = true;
    file->upReason = "z may be up";
    file->side = {ClothSide::Way::Inwards, "99 %"};
    const auto doubts = findDoubts(garment, {});
    ASSERT_EQ(doubts.size(), 2U);
    EXPECT_EQ(doubts[0].kind, FindingKind::UpAxisInDoubt);
    EXPECT_EQ(doubts[0].subject.name, "skirt.obj");
    EXPECT_NE(sentence(doubts[0]).find("(z may be up). "), std::string::npos);
    EXPECT_TRUE(sentence(doubts[0]).ends_with(" (--up y or --up z)."));
    EXPECT_EQ(doubts[1].kind, FindingKind::InsideOut);
    EXPECT_NE(sentence(doubts[1]).find("(--turn-over)."), std::string::npos);
    EXPECT_FALSE(hasFaults(garment, {}, doubts));
}

TEST(Doubt, AFewTrianglesAreNone) {
    FlatGarment flat;
    const auto strained = flat.add(test::planeGrid(10, 10, 50), "panel");
    strained->flat->Q(0, 0) -= 40;  // a corner: at most two triangles of two hundred
    EXPECT_TRUE(flat.doubts().empty());
}

TEST(Doubt, ManyScrapsAreOneButNotThoseLeftOut) {
    FlatGarment flat;
    for (int k = 0; k <= kManyScraps; ++k) {
        flat.add(test::planeGrid(1, 1, 5), "scrap " + std::to_string(k));
    }
    const auto doubts = flat.doubts();
    ASSERT_EQ(doubts.size(), 1U);
    EXPECT_EQ(doubts[0].kind, FindingKind::ManyScraps);
    EXPECT_TRUE(doubts[0].pieces.empty());

    const auto left = std::make_shared<PieceResult>(*flat.results[3]);
    left->flat.reset();
    left->error = Error{ErrorCode::LeftOut, subjectOf(*left->piece)};
    flat.results[3] = left;
    EXPECT_TRUE(flat.doubts().empty());  // as many as may be
}

TEST(Doubt, SmallPiecesThatAreLargeEnoughAreNoScraps) {
    FlatGarment flat;
    for (int k = 0; k < 3 * kManyScraps; ++k) {
        flat.add(test::planeGrid(1, 1, 10.01), "patch " + std::to_string(k));
    }
    EXPECT_TRUE(flat.doubts().empty());
}

CutRecord recordOf(const MeshArrays& mesh, CutAuthor author, double length) {
    CutRecord record;
    record.whole = std::make_shared<const Piece>(makePiece("whole", mesh));
    record.cuts = {{"cut", author, UserCut::Kind::Path, "whole", length, {}}};
    return record;
}

TEST(Doubt, CutsOfOurOwnThatAreLongerThanTheOutlineAreOne) {
    const MeshArrays square = test::planeGrid(2, 2, 50);  // 400 mm around
    Garment garment;
    garment.cutRecords = {recordOf(square, CutAuthor::Automatic, 401)};
    const auto doubts = findDoubts(garment, {});
    ASSERT_EQ(doubts.size(), 1U);
    EXPECT_EQ(doubts[0].kind, FindingKind::LongCuts);
    EXPECT_EQ(doubts[0].subject.name, "whole");

    garment.cutRecords = {recordOf(square, CutAuthor::Automatic, 399)};
    EXPECT_TRUE(findDoubts(garment, {}).empty());
    garment.cutRecords = {recordOf(square, CutAuthor::User, 4000)};  // who cuts knows why
    EXPECT_TRUE(findDoubts(garment, {}).empty());
    garment.cutRecords = {recordOf(test::octahedron(), CutAuthor::Automatic, 4000)};
    EXPECT_TRUE(findDoubts(garment, {}).empty());  // it must be cut, and has no outline
}

TEST(Doubt, CutsOfWhatIsLeftOutDoNotCount) {
    Garment garment;
    garment.cutRecords = {recordOf(test::planeGrid(2, 2, 50), CutAuthor::Automatic, 401)};
    const auto piece = garment.cutRecords[0].whole;
    garment.cutRecords[0].pieces = {piece};
    const auto left = std::make_shared<PieceResult>();
    left->piece = piece;
    EXPECT_EQ(findDoubts(garment, {left}).size(), 1U);
    left->error = Error{ErrorCode::LeftOut, subjectOf(*piece)};
    EXPECT_TRUE(findDoubts(garment, {left}).empty());
}

TEST(Doubt, WhatIsNotThereIsNotLookedAt) {
    FlatGarment flat;
    widenFirstCells(*flat.add(test::planeGrid(10, 1, 50), "strip"), 5, 3);
    flat.results[0] = nullptr;
    EXPECT_TRUE(flat.doubts().empty());
}

TEST(Doubt, EveryKindSaysWhatToTry) {
    for (const FindingKind kind :
         {FindingKind::UpAxisInDoubt, FindingKind::InsideOut, FindingKind::StrainBeyondCloth,
          FindingKind::ManyScraps, FindingKind::LongCuts}) {
        EXPECT_NE(*findingWords(kind).advice, '\0');
    }
}

}  // namespace
}  // namespace toile
