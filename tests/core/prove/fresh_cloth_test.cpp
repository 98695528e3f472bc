// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/fresh_cloth.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/mesh/edge_table.h"
#include "core/sew/gap.h"
#include "core/sew/settle.h"
#include "tests/core/prove/proved_garment.h"
#include "tests/core/sew/cloth_shapes.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile::prove {
namespace {

/// Whole, sewn along every seam, and begun on the design.
void expectSewn(const test::ProvedGarment& garment, const ProofOrder& order) {
    const auto fresh = freshCloth(garment.source(), order, {});
    ASSERT_TRUE(fresh) << sentence(fresh.error());
    const sew::Cloth& cloth = fresh->cloth;
    EXPECT_GT(sew::restAreas(cloth).minCoeff(), 0);
    const MeshArrays form = garment.design();
    const sew::WornSurface design(form);
    for (Eigen::Index v = 0; v < cloth.X.rows(); ++v) {
        ASSERT_LT(design.distanceTo(cloth.X.row(v).transpose()), 0.5);
    }
    const auto sewn = sew::sewnVertices(cloth);
    EXPECT_EQ(std::ranges::count(sewn, 1) > 0, !fresh->seams.empty());
    for (std::size_t p = 0; p < fresh->placeOf.size(); ++p) {
        const Piece& piece = *garment.garment().pieces[p];
        for (std::size_t v = 0; v < fresh->placeOf[p].size(); ++v) {
            const SurfacePoint& place = fresh->placeOf[p][v];
            ASSERT_EQ(cloth.pieceOf[place.face], static_cast<int>(p));
            const double far = (positionOf({cloth.X, cloth.F}, place).transpose() -
                                piece.mesh.V.row(static_cast<Eigen::Index>(v)))
                                   .norm();
            EXPECT_LT(far, 30) << piece.name;
        }
    }
}

TEST(FreshCloth, LiesOnTheDesignAtFirst) {
    for (const char* sample : {"tshirt", "trousers", "cap", "bodice", "skirt"}) {
        SCOPED_TRACE(sample);
        const test::ProvedGarment garment(
            test::sourceFile(std::string("resources/samples/") + sample + ".obj"));
        expectSewn(garment, {});
        ProofOrder coarse;
        coarse.settings.edge = 20;
        expectSewn(garment, coarse);
    }
}

TEST(FreshCloth, SewsDartsAndPiecesThatWereCut) {
    LoadOptions options;
    options.seams = *readSeamsFile(test::sourceFile("resources/samples/tshirt.seams.json"));
    const test::ProvedGarment garment(test::sourceFile("resources/samples/tshirt.obj"), options);
    expectSewn(garment, {});
}

/// A square that is let into a hole of another.
TEST(FreshCloth, SewsAPatchIntoAHole) {
    const MeshArrays grid = test::planeGrid(20, 20, 10);
    sew::CutCloth cut;
    for (const bool isPatch : {false, true}) {
        const MeshArrays part = test::part(grid, [&](const Eigen::RowVector3d& middle) {
            return (std::abs(middle.x() - 100) < 40 && std::abs(middle.y() - 110) < 30) == isPatch;
        });
        const auto first = cut.V.rows(), firstFace = cut.F.rows();
        cut.V.conservativeResize(first + part.V.rows(), 3);
        cut.V.bottomRows(part.V.rows()) = part.V;
        cut.F.conservativeResize(firstFace + part.F.rows(), 3);
        cut.F.bottomRows(part.F.rows()) = part.F.array() + static_cast<int>(first);
        cut.pieceOf.insert(cut.pieceOf.end(), static_cast<std::size_t>(part.F.rows()),
                           isPatch ? 1 : 0);
    }
    const test::TemporaryFolder folder;
    LoadOptions options;
    options.unit = LengthUnit::Millimetre;
    options.up = UpAxis::Y;
    const test::ProvedGarment garment(folder.write("patch.obj", test::objectsOf(cut)), options);
    ASSERT_EQ(garment.garment().pieces.size(), 2u);
    for (const double edge : {0.0, 15.0}) {
        ProofOrder order;
        order.settings.edge = edge;
        const auto fresh = freshCloth(garment.source(), order, {});
        ASSERT_TRUE(fresh);
        EXPECT_TRUE(fresh->faults.empty());
        const sew::Cloth& cloth = fresh->cloth;
        EXPECT_NEAR(sew::restAreas(cloth).sum(), 200 * 200, 0.1);
        // The rim of the whole is all the rim there is.
        const EdgeTable table = buildEdgeTable(cloth.F, static_cast<int>(cloth.X.rows()));
        double rim = 0;
        for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
            const Eigen::RowVector3d way =
                cloth.X.row(table.edges(e, 0)) - cloth.X.row(table.edges(e, 1));
            rim += table.isBorder(e) ? way.norm() : 0;
        }
        EXPECT_NEAR(rim, 4 * 200, 0.01);
    }
}

class FreshSharedCloth : public testing::TestWithParam<const char*> {};

TEST_P(FreshSharedCloth, SewsGarmentsOfOthers) {
    const auto path = test::sharedFile(std::string("garments/") + GetParam());
    TOILE_NEEDS_SHARED(path);
    LoadOptions options;
    options.autoCut = true;
    FlattenOptions flattening;
    flattening.quality = Quality::Draft;
    const test::ProvedGarment garment(path, options, flattening);
    const auto fresh = freshCloth(garment.source(), {}, {});
    ASSERT_TRUE(fresh) << sentence(fresh.error());
    for (const Finding& fault : fresh->faults) {
        ADD_FAILURE() << fault.reason;
    }
    EXPECT_GT(fresh->cloth.F.rows(), 1000);
}

INSTANTIATE_TEST_SUITE_P(FreshCloth, FreshSharedCloth,
                         testing::Values("dress14_pieces.obj", "polo_pieces.obj", "suit_mh.obj"));

struct ExactForm {
    const char* name;
    sew::CutCloth design;
    double radius;  ///< the least, of its curvature; 0: it has none
};

/// The gap grows with the square of the edge, and is twice the chord error at most.
TEST(FreshCloth, SewsExactFormsBackToTheChordError) {
    const test::TemporaryFolder folder;
    const ExactForm forms[] = {{"tube", test::tubeCloth(160, 24, 60, 60), 60},
                               {"cone", test::coneCloth(160, 24, 100, 160, 0.5), 46},
                               {"cube", test::cubeCloth(10, 100), 0}};
    for (const ExactForm& form : forms) {
        SCOPED_TRACE(form.name);
        LoadOptions options;
        options.unit = LengthUnit::Millimetre;
        options.up = UpAxis::Y;
        const test::ProvedGarment garment(folder.write("form.obj", test::objectsOf(form.design)),
                                          options);
        const MeshArrays surface = garment.design();
        const sew::WornSurface design(surface);
        sew::SettleOptions settling;
        settling.stiffness.assign(garment.garment().pieces.size(),
                                  isotropicStiffness(1000, 0.3, 0));
        double coarser = 0;
        for (const double edge : {20.0, 10.0, 5.0}) {
            ProofOrder order;
            order.settings.edge = edge;
            const auto fresh = freshCloth(garment.source(), order, {});
            ASSERT_TRUE(fresh) << sentence(fresh.error());
            const auto settled = sew::settle(fresh->cloth, fresh->cloth.X, design, settling, {});
            ASSERT_TRUE(settled);
            const double gap = sew::gapTo(design, fresh->cloth, settled->X).mean;
            RecordProperty(std::string(form.name) + std::to_string(edge), std::to_string(gap));
            // What the file's decimals and the pressure cost.
            constexpr double kFloor = 0.003;
            const double chord = form.radius > 0 ? edge * edge / (8 * form.radius) : 0;
            EXPECT_LT(gap, 2 * chord + kFloor) << edge;
            if (coarser > 0 && form.radius > 0) {
                EXPECT_LT(gap, coarser / 3 + kFloor) << edge;
            }
            coarser = gap;
        }
    }
}

}  // namespace
}  // namespace toile::prove
