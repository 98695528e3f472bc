// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/proof.h"

#include <gtest/gtest.h>

#include "core/prove/fresh_cloth.h"
#include "core/toile/pipeline.h"
#include "tests/core/prove/proved_garment.h"
#include "tests/core/support/laid_rows.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// A garment file, flat, sewn back together.
Result<std::shared_ptr<const Proof>> provenFile(const std::filesystem::path& file) {
    Progress progress;
    const auto garment = loadGarment({file}, {}, progress);
    EXPECT_TRUE(garment);
    const PieceResults results = flattenGarment(*garment, {}, progress);
    const LaidOutPattern laid = inRows(*garment, results);
    return proofOf(ExportSource(*garment, results, laid), {}, progress);
}

TEST(Proof, MeasuresEveryPieceOfASample) {
    const auto proof = provenFile(test::sourceFile("resources/samples/tshirt.obj"));
    ASSERT_TRUE(proof);
    for (const ProvenPiece& piece : (*proof)->pieces) {
        EXPECT_TRUE(piece.isSewn());
        EXPECT_TRUE(piece.gap.allFinite() && piece.strain.allFinite());
    }
    EXPECT_TRUE((*proof)->hasSettled);
    EXPECT_TRUE((*proof)->faults.empty());
    EXPECT_LT((*proof)->gap.mean, 1);
}

class ProofStarts : public testing::TestWithParam<const char*> {};

TEST_P(ProofStarts, EndInTheSamePlaceFromTheDesignAndFromTenMillimetresOff) {
    const auto path = test::dataFile(GetParam());
    TOILE_NEEDS_SHARED(path);
    const test::ProvedGarment garment(path);
    const auto fresh = prove::freshCloth(garment.source(), {}, {});
    ASSERT_TRUE(fresh);
    const sew::Cloth& cloth = fresh->cloth;
    const sew::WornSurface design(garment.design());
    Points3 off = cloth.X;
    for (Eigen::Index v = 0; v < off.rows(); ++v) {
        off.row(v) += 10 * design.placeOf(cloth.X.row(v).transpose()).away.transpose();
    }
    sew::SettleOptions options;
    options.share = 2e-3;
    const auto fromDesign = sew::settle(cloth, cloth.X, design, options, {});
    const auto fromOff = sew::settle(cloth, off, design, options, {});
    ASSERT_TRUE(fromDesign && fromOff);
    EXPECT_TRUE(fromDesign->hasSettled && fromOff->hasSettled);
    EXPECT_LT((fromDesign->X - fromOff->X).rowwise().norm().mean(), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Proof, ProofStarts,
                         testing::Values("samples/tshirt.obj", "garments/polo.obj"));

}  // namespace
}  // namespace toile
