// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/file_space.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

Garment garmentOf(LengthUnit unit, UpAxis up) {
    auto file = std::make_shared<SourceFile>();
    file->unit = unit;
    file->up = up;
    Garment garment;
    garment.files.push_back(file);
    return garment;
}

TEST(FileSpace, TakesUnitAndAxesOfTheFile) {
    const Garment garment = garmentOf(LengthUnit::Centimetre, UpAxis::Z);
    // What lies 5 cm up in the file lies 50 mm up in the piece, and the other way round.
    EXPECT_EQ(inPieceSpace({1, 2, 5}, {}, garment), Eigen::Vector3d(10, 50, -20));
    EXPECT_EQ(inFileSpace({10, 50, -20}, {}, garment), Eigen::Vector3d(1, 2, 5));
}

TEST(FileSpace, TheSeamsFilesOwnUnitGoesFirst) {
    SeamsFile seams;
    seams.unit = LengthUnit::Metre;
    const Garment garment = garmentOf(LengthUnit::Centimetre, UpAxis::Y);
    EXPECT_EQ(inPieceSpace({1, 2, 3}, seams, garment), Eigen::Vector3d(1000, 2000, 3000));
    EXPECT_EQ(inFileSpace({1000, 2000, 3000}, seams, garment), Eigen::Vector3d(1, 2, 3));
}

TEST(FileSpace, GoesThereAndBack) {
    const Eigen::Vector3d point(12.345, -678.9, 0.125);
    for (const LengthUnit unit :
         {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre, LengthUnit::Inch}) {
        for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
            const Garment garment = garmentOf(unit, up);
            const Eigen::Vector3d again =
                inPieceSpace(inFileSpace(point, {}, garment), {}, garment);
            EXPECT_LE((again - point).norm(), 1e-12 * point.norm());
        }
    }
    EXPECT_EQ(inFileSpace(point, {}, {}), point);
    EXPECT_EQ(inPieceSpace(point, {}, {}), point);
}

TEST(FileSpace, CutsAndJoinsComeAlike) {
    SeamsFile seams;
    seams.cuts = {{"c", UserCut::Kind::Path, {{1, 2, 3}, {4, 5, 6}}, true}};
    seams.joins = {{"j", {{1, 2, 3}}}};
    const Garment garment = garmentOf(LengthUnit::Inch, UpAxis::Z);
    const auto cuts = cutsInPieceSpace(seams, garment);
    const auto joins = joinsInPieceSpace(seams, garment);
    EXPECT_EQ(cuts[0].name, "c");
    EXPECT_TRUE(cuts[0].alongEdges);
    EXPECT_EQ(cuts[0].points[1], inPieceSpace({4, 5, 6}, seams, garment));
    EXPECT_EQ(joins[0].points[0], cuts[0].points[0]);
}

}  // namespace
}  // namespace toile
