// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/piece_names.h"

#include <gtest/gtest.h>

#include "core/toile/pipeline.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

/// Two squares, "front" and "back", sewn along one edge.
Garment sewnSquares() {
    const test::TemporaryFolder folder;
    const auto file = folder.write("two.obj",
                                   "v 0 0 0\nv 100 0 0\nv 100 100 0\nv 0 100 0\nv 200 0 0\n"
                                   "v 200 100 0\no front\nf 1 2 3\nf 1 3 4\no back\nf 2 5 6\n"
                                   "f 2 6 3\n");
    LoadOptions options;
    options.unit = LengthUnit::Millimetre;
    Progress progress;
    return loadGarment({file}, options, progress).value();
}

TEST(PieceNames, AnotherNameIsShownAndNoneBringsTheOwnBack) {
    const Garment garment = sewnSquares();
    PieceLabels labels = withName({}, garment, 0, "  Vorderteil ");
    EXPECT_EQ(nameOf(labels, *garment.pieces[0]), "Vorderteil");
    EXPECT_EQ(nameOf(labels, *garment.pieces[1]), "back");
    labels = withName(std::move(labels), garment, 0, " ");
    EXPECT_EQ(nameOf(labels, *garment.pieces[0]), "front");
}

TEST(PieceNames, NoTwoPiecesAreCalledTheSame) {
    const Garment garment = sewnSquares();
    PieceLabels labels = withName({}, garment, 0, "back");
    EXPECT_EQ(nameOf(labels, *garment.pieces[0]), "back 2");
    labels = withName(std::move(labels), garment, 1, "back 2");
    EXPECT_EQ(nameOf(labels, *garment.pieces[1]), "back 2 2");
}

TEST(PieceNames, SeamsFollowTheirPieces) {
    const Garment garment = sewnSquares();
    const PieceLabels labels = withName({}, garment, 1, "Rücken");
    bool isSewn = false;
    for (const Seam& seam : garment.seams.seams) {
        const std::string name = nameOf(labels, garment, seam);
        isSewn = isSewn || name == "front / Rücken" || name == "Rücken / front";
        EXPECT_EQ(name.find("back"), std::string::npos) << name;
    }
    EXPECT_TRUE(isSewn);
}

TEST(PieceNames, FilesGetAGarmentWithTheseNamesAndTheSameIds) {
    const Garment garment = sewnSquares();
    const PieceLabels labels = withName({}, garment, 0, "Vorderteil");
    Progress progress;
    const PieceResults results = flattenGarment(garment, {}, progress);
    const Garment renamed = named(garment, labels);
    const PieceResults renamedResults = resultsFor(renamed, results);
    EXPECT_EQ(renamed.pieces[0]->name, "Vorderteil");
    EXPECT_EQ(renamed.pieces[0]->id, garment.pieces[0]->id);
    EXPECT_EQ(renamed.pieces[1], garment.pieces[1]);
    EXPECT_EQ(renamedResults[0]->piece, renamed.pieces[0]);
    EXPECT_EQ(renamedResults[0]->fingerprint, results[0]->fingerprint);
    EXPECT_EQ(renamedResults[1], results[1]);
}

}  // namespace
}  // namespace toile
