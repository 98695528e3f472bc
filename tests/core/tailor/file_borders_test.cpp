// SPDX-License-Identifier: GPL-3.0-or-later
// What borders within the skin, of materials, groups or a UV map, say about where it is cut.
#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "core/tailor/cut_advice.h"
#include "core/tailor/mesh_lines.h"
#include "tests/core/tailor/worn_shapes.h"

namespace toile {
namespace {

/// The file that a piece comes from, its triangles of the materials that their middles say.
PolygonSoup soupOf(const Piece& piece, const std::function<int(const Eigen::Vector3d&)>& material) {
    PolygonSoup soup;
    for (Eigen::Index v = 0; v < piece.mesh.V.rows(); ++v) {
        soup.positions.emplace_back(piece.mesh.V.row(v));
    }
    soup.materials = {"front", "back", "other"};
    for (Eigen::Index f = 0; f < piece.mesh.F.rows(); ++f) {
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (int k = 0; k < 3; ++k) {
            soup.corners.push_back(piece.mesh.F(f, k));
            middle += piece.mesh.V.row(piece.mesh.F(f, k)) / 3;
        }
        soup.faceStart.push_back(static_cast<int>(soup.corners.size()));
        soup.faceMaterial.push_back(material(middle));
    }
    return soup;
}

CutAdvice adviceWith(const std::shared_ptr<const Piece>& piece,
                     const std::function<int(const Eigen::Vector3d&)>& material) {
    return adviseCuts(piece, {}, {.borders = fileBorders(*piece, soupOf(*piece, material))});
}

std::vector<AdvisedCut> linesOf(const CutAdvice& advice, TailorLine line) {
    std::vector<AdvisedCut> found;
    std::ranges::copy_if(advice.cuts, std::back_inserter(found),
                         [line](const AdvisedCut& cut) { return cut.what.line == line; });
    return found;
}

TEST(FileBorders, AreEvidence) {
    const auto shirt = test::wornPiece(test::wornShirt());
    const auto told = adviceWith(shirt, [](const auto& at) { return at.z() > 0 ? 0 : 1; });
    const auto areAlong = [](const CutAdvice& advice) {
        return std::ranges::count_if(linesOf(advice, TailorLine::Side),
                                     [](const AdvisedCut& cut) { return cut.what.isFileBorder; });
    };
    EXPECT_EQ(areAlong(adviseCuts(shirt, {}, {})), 0);
    EXPECT_EQ(areAlong(told), 2);
    EXPECT_TRUE(fileBorders(*shirt, soupOf(*shirt, [](const auto&) { return 0; })).empty());
}

TEST(FileBorders, BesideARimAllRoundAreABandAndOthersAreOfferedOnly) {
    const auto shirt = test::wornPiece(test::wornShirt());
    const CutAdvice advice = adviceWith(shirt, [](const Eigen::Vector3d& at) {
        const bool isBand = std::abs(at.x()) < 120 && at.y() > (at.z() > 0 ? 480 : 560);
        return isBand ? 2 : at.y() < 300 ? 1 : 0;
    });
    const auto bands = linesOf(advice, TailorLine::Band),
               styles = linesOf(advice, TailorLine::Style);
    ASSERT_EQ(bands.size(), 1U);
    EXPECT_TRUE(bands[0].isNeeded);
    EXPECT_EQ(bands[0].what.cut.name, "band");
    EXPECT_EQ(bands[0].what.cut.kind, UserCut::Kind::Loop);
    ASSERT_EQ(styles.size(), 1U);
    EXPECT_TRUE(styles[0].what.isFileBorder);
    EXPECT_FALSE(styles[0].isNeeded);
}

TEST(FileBorders, HalfRoundARimAreNoBand) {
    const CutAdvice advice =
        adviceWith(test::wornPiece(test::wornShirt()),
                   [](const Eigen::Vector3d& at) { return at.z() > 0 && at.y() < 40 ? 2 : 0; });
    EXPECT_TRUE(linesOf(advice, TailorLine::Band).empty());
    ASSERT_EQ(linesOf(advice, TailorLine::Style).size(), 1U);
    EXPECT_FALSE(linesOf(advice, TailorLine::Style)[0].isNeeded);
}

TEST(FileBorders, WhereTheShoulderSeamEndsTheArmholeMayRunAlongTheRidge) {
    // Of two sleeves set in 40 mm farther out behind, the seam runs along the ridge for as much.
    const CutAdvice advice =
        adviceWith(test::wornPiece(test::wornShirt()), [](const Eigen::Vector3d& at) {
            const double sleeve = at.z() < 0 && at.y() > 520 ? 280 : 240;
            return std::abs(at.x()) > sleeve ? 2 : at.z() > 0 ? 0 : 1;
        });
    const auto armholes = linesOf(advice, TailorLine::Armhole);
    const auto shoulders = linesOf(advice, TailorLine::Shoulder);
    ASSERT_EQ(armholes.size(), 2U);
    ASSERT_EQ(shoulders.size(), 2U);
    for (const AdvisedCut& armhole : armholes) {
        EXPECT_GT(armhole.what.likeliness, 0.94);
    }
    for (const AdvisedCut& shoulder : shoulders) {
        EXPECT_NEAR(std::abs(shoulder.what.cut.points.back().x()), 240, 1);
        EXPECT_NEAR(shoulder.what.cut.points.back().y(), 600, 1);
    }
}

}  // namespace
}  // namespace toile
