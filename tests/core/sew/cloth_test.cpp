// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/sew/seam_samples.h"
#include "tests/core/sew/cloth_shapes.h"
#include "tests/core/support/shapes.h"

namespace toile::sew {
namespace {

/// A flat strip from x = `from` on, of as many squares along y as given, 120 mm high.
MeshArrays stripAt(double from, int rows) {
    const double size = 120.0 / rows;
    MeshArrays mesh = test::planeGrid(2, rows, size);
    mesh.V.col(0).array() += from - (from < 0 ? mesh.V.col(0).maxCoeff() : 0);
    return mesh;
}

/// Two strips side by side, sewn along x = 0 where their vertices are not across from each other.
Garment twoStrips(int leftRows, int rightRows) {
    Garment garment;
    const auto left = test::asPiece(stripAt(-1e-9, leftRows), "left");
    const auto right = test::asPiece(stripAt(0, rightRows), "right");
    garment.pieces = {left, right};
    const auto sideAt = [](const Piece& piece, bool up) {
        SeamSide side;
        double arc = 0, low = 0, high = 0;
        const auto n = piece.boundary.size();
        for (std::size_t k = 0; k < n; ++k) {
            const Eigen::RowVector3d p = piece.mesh.V.row(piece.boundary[k]);
            if (std::abs(p[0]) < 1e-6 && p[1] < 1e-6) {
                low = arc;
            }
            if (std::abs(p[0]) < 1e-6 && p[1] > 119) {
                high = arc;
            }
            arc += (piece.mesh.V.row(piece.boundary[(k + 1) % n]) - p).norm();
        }
        side.reversed = !up;
        side.start = low;
        side.end = high;
        if (up && side.end < side.start) {
            side.end += arc;
        }
        if (!up && side.end > side.start) {
            side.start += arc;
        }
        return side;
    };
    Seam seam;
    seam.left = sideAt(*left, true);
    seam.right = sideAt(*right, false);
    seam.left.piece = 0;
    seam.right.piece = 1;
    for (const int rows : {leftRows, rightRows}) {
        for (int k = 0; k <= rows; ++k) {
            const double s = 120.0 * k / rows;
            seam.matches.push_back({seam.left.start + s, seam.right.start - s});
        }
    }
    garment.seams.seams = {seam};
    return garment;
}

std::vector<Points2> asTheyLie(const Garment& garment) {
    std::vector<Points2> parts;
    for (const auto& piece : garment.pieces) {
        parts.emplace_back(piece->mesh.V.leftCols<2>());
    }
    return parts;
}

/// It lies in space as the pattern does.
void expectUnmoved(const Cloth& cloth) {
    for (Eigen::Index p = 0; p < cloth.Q.rows(); ++p) {
        const Eigen::RowVector3d x = cloth.X.row(cloth.clothVertex[p]);
        EXPECT_NEAR((x.leftCols<2>() - cloth.Q.row(p)).norm(), 0, 1e-6) << p;
    }
}

int countSewn(const Cloth& cloth) {
    return static_cast<int>(std::ranges::count(sewnVertices(cloth), 1));
}

TEST(Cloth, SewnPointsAreOneVertex) {
    const CutCloth cut = test::tubeCloth(6, 3, 20, 30);
    const Cloth cloth = sewTogether(cut);
    EXPECT_EQ(cloth.X.rows(), 6 * 4);
    EXPECT_EQ(cloth.F.rows(), cut.F.rows());
    EXPECT_EQ(countSewn(cloth), 4);
    EXPECT_EQ(cloth.collapsed, 0);
    EXPECT_NEAR(restAreas(cloth).sum(), vertexAreas(cloth).sum(), 1e-9);
}

TEST(Cloth, TriangleWhoseCornersAreSewnToEachOtherIsLeftOut) {
    CutCloth cut = test::flatCloth(1, 1, 10);
    cut.sewn.emplace_back(cut.F(0, 0), cut.F(0, 1));
    const Cloth cloth = sewTogether(cut);
    EXPECT_EQ(cloth.collapsed, 1);
    EXPECT_EQ(cloth.F.rows(), 1);
}

TEST(Cloth, APointThatNoTriangleUsesIsNoVertex) {
    CutCloth cut = test::flatCloth(1, 1, 10);
    const Eigen::RowVector3i ear = cut.F.row(0), other = cut.F.row(1);
    int tip = -1;
    std::vector<int> sides;
    for (const int corner : ear) {
        if ((other.array() == corner).any()) {
            sides.push_back(corner);
        } else {
            tip = corner;
        }
    }
    // The other triangle must stay: a point of it is sewn to one that only the ear has.
    cut.sewn.emplace_back(tip, sides[0]);
    const Cloth cloth = sewTogether(cut);
    EXPECT_EQ(cloth.X.rows(), 3);
    EXPECT_GT(vertexAreas(cloth).minCoeff(), 0);
    cut.sewn = {};
    cut.F.conservativeResize(1, 3);
    cut.pieceOf.resize(1);
    const Cloth half = sewTogether(cut);
    EXPECT_EQ(half.X.rows(), 3);
    EXPECT_EQ(std::ranges::count(half.clothVertex, -1), 1);
    EXPECT_EQ(countSewn(half), 0);
}

TEST(Cloth, SidesWithTheSameSamplesAreSewnVertexByVertex) {
    const Garment garment = twoStrips(4, 4);
    const auto cut = cutAlongSeams(garment, asTheyLie(garment));
    ASSERT_TRUE(cut);
    const Cloth cloth = sewTogether(*cut);
    EXPECT_EQ(cut->Q.rows(), 2 * 15);
    EXPECT_EQ(cloth.X.rows(), 25);
    EXPECT_EQ(countSewn(cloth), 5);
    expectUnmoved(cloth);
}

TEST(Cloth, SidesWithOtherSamplesAreDividedWhereTheOtherHasAVertex) {
    const Garment garment = twoStrips(4, 3);
    const auto cut = cutAlongSeams(garment, asTheyLie(garment));
    ASSERT_TRUE(cut);
    const Cloth cloth = sewTogether(*cut);
    EXPECT_EQ(countSewn(cloth), 2 + 3 + 2);  // ends, and all inner vertices of either side
    EXPECT_NEAR(restAreas(cloth).sum(), 120 * 60 + 120 * 80, 1e-6);
    // Nothing has moved: it lies flat without strain, and is as long along the seam as before.
    for (const auto& shape : restShapes(cloth)) {
        EXPECT_GT(shape.area, 0);
    }
    expectUnmoved(cloth);
}

TEST(Cloth, EaseIsSpreadEvenly) {
    Garment garment = twoStrips(4, 4);
    std::vector<Points2> parts = asTheyLie(garment);
    parts[0].col(1) *= 1.1;
    const auto cut = cutAlongSeams(garment, parts);
    ASSERT_TRUE(cut);
    const Cloth cloth = sewTogether(*cut);
    EXPECT_EQ(countSewn(cloth), 5);
    EXPECT_NEAR(restAreas(cloth).sum(), 1.1 * 120 * 60 + 120 * 60, 1e-6);
}

TEST(Cloth, PieceThatIsNotFlatIsLeftOut) {
    const Garment garment = twoStrips(2, 2);
    std::vector<Points2> parts = asTheyLie(garment);
    parts[1].resize(0, 2);
    const auto cut = cutAlongSeams(garment, parts);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->F.rows(), garment.pieces[0]->mesh.F.rows());
    parts[0].resize(0, 2);
    EXPECT_EQ(cutAlongSeams(garment, parts).error().code, ErrorCode::NoGeometry);
}

}  // namespace
}  // namespace toile::sew
