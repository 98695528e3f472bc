// SPDX-License-Identifier: GPL-3.0-or-later
// Garments that nobody would sew: each is proved in finite numbers, or says why not.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/prove/fresh_cloth.h"
#include "core/prove/proof.h"
#include "core/seam/find_seams.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/laid_rows.h"
#include "tests/core/support/literal_mesh.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

Garment oddGarment(const std::vector<MeshArrays>& meshes) {
    Garment garment;
    garment.files = {std::make_shared<const SourceFile>()};
    for (const MeshArrays& mesh : meshes) {
        const std::size_t number = garment.pieces.size() + 1;
        auto piece = std::make_shared<Piece>(makePiece("piece " + std::to_string(number), mesh));
        test::identify(*piece, number);
        garment.pieces.push_back(std::move(piece));
    }
    garment.uncut = garment.pieces;
    garment.seams = findSeams(garment.pieces);
    return garment;
}

Result<std::shared_ptr<const Proof>> proofOfResults(const Garment& garment,
                                                    const PieceResults& results) {
    const LaidOutPattern laid = inRows(garment, results);
    return proofOf(ExportSource(garment, results, laid), {}, {});
}

PieceResults flatResults(const Garment& garment) {
    Progress progress;
    return flattenGarment(garment, {}, progress);
}

/// Every figure is one, and the words can be made.
void expectFinite(const Garment& garment, const Proof& proof) {
    EXPECT_EQ(proof.pieces.size(), garment.pieces.size());
    for (const sew::SpreadFigures& figures : {proof.gap, proof.strain}) {
        EXPECT_TRUE(std::isfinite(figures.mean) && std::isfinite(figures.most95) &&
                    std::isfinite(figures.max));
    }
    for (const ProvenPiece& piece : proof.pieces) {
        EXPECT_TRUE(piece.sewn.allFinite());
        EXPECT_TRUE(piece.gap.allFinite());
        EXPECT_TRUE(piece.strain.allFinite());
        EXPECT_TRUE(std::isfinite(piece.mostPull) && std::isfinite(piece.mostSlack));
        EXPECT_TRUE(std::isfinite(piece.freeShare));
    }
    EXPECT_EQ(sentence(proof, garment).find("nan"), std::string::npos);
    EXPECT_EQ(writeProof(garment, proof).find("nan"), std::string::npos);
}

MeshArrays moved(MeshArrays mesh, double x) {
    mesh.V.col(0).array() += x;
    return mesh;
}

MeshArrays turnedOver(MeshArrays mesh) {
    mesh.F = mesh.F.rowwise().reverse().eval();
    return mesh;
}

TEST(OddProof, OnePieceWithoutSeamsLiesWhereItWas) {
    const Garment garment = oddGarment({test::planeGrid(6, 6, 20)});
    const auto proof = proofOfResults(garment, flatResults(garment));
    ASSERT_TRUE(proof) << sentence(proof.error());
    expectFinite(garment, **proof);
    EXPECT_LT((*proof)->gap.max, 0.01);
    EXPECT_TRUE((*proof)->faults.empty());
}

TEST(OddProof, ClothThatEndsNowhereNearTheDesignIsAFault) {
    const Garment garment = oddGarment({test::planeGrid(6, 6, 20)});
    const PieceResults results = flatResults(garment);
    const LaidOutPattern laid = inRows(garment, results);
    const ExportSource source(garment, results, laid);
    ProofOrder order;
    order.scale = 6;
    const auto proof = proofOf(source, order, {});
    ASSERT_TRUE(proof) << sentence(proof.error());
    EXPECT_TRUE(std::ranges::any_of((*proof)->faults, [](const Finding& fault) {
        return fault.kind == FindingKind::FarOff && fault.badness > 0;
    })) << (*proof)->gap.mean;
}

TEST(OddProof, PiecesThatDoNotTouchAreProvedSideBySide) {
    const MeshArrays sheet = test::planeGrid(6, 6, 20);
    const Garment garment = oddGarment({sheet, moved(sheet, 500)});
    const auto proof = proofOfResults(garment, flatResults(garment));
    ASSERT_TRUE(proof) << sentence(proof.error());
    expectFinite(garment, **proof);
    EXPECT_LT((*proof)->gap.max, 0.01);
}

TEST(OddProof, APieceThatIsNotFlatHasNoCloth) {
    const MeshArrays sheet = test::planeGrid(6, 6, 20);
    MeshArrays tube = test::tube(12, 4);
    tube.V *= 50;
    const Garment garment = oddGarment({sheet, moved(tube, 500)});
    const PieceResults results = flatResults(garment);
    EXPECT_FALSE(results[1]->flat);
    const auto proof = proofOfResults(garment, results);
    ASSERT_TRUE(proof) << sentence(proof.error());
    expectFinite(garment, **proof);
    EXPECT_TRUE((*proof)->pieces[0].isSewn());
    EXPECT_FALSE((*proof)->pieces[1].isSewn());
}

TEST(OddProof, WithoutAnyFlatPieceThereIsNothingToSew) {
    MeshArrays tube = test::tube(12, 4);
    tube.V *= 50;
    const Garment garment = oddGarment({tube});
    const auto proof = proofOfResults(garment, flatResults(garment));
    ASSERT_FALSE(proof);
    EXPECT_EQ(proof.error().code, ErrorCode::NoGeometry);
}

TEST(OddProof, PiecesLeftOutAreMissedByNobody) {
    const MeshArrays sheet = test::planeGrid(6, 6, 20);
    const Garment garment = oddGarment({sheet, moved(sheet, 120)});
    PieceResults results = flatResults(garment);
    auto out = std::make_shared<PieceResult>(*results[0]);
    out->flat.reset();
    out->quality.reset();
    out->error = Error{ErrorCode::LeftOut, subjectOf(*garment.pieces[0])};
    results[0] = out;
    const auto proof = proofOfResults(garment, results);
    ASSERT_TRUE(proof) << sentence(proof.error());
    expectFinite(garment, **proof);
    EXPECT_TRUE((*proof)->pieces[1].isSewn());
}

TEST(OddProof, APieceWoundTheOtherWayIsSewnAllTheSame) {
    const MeshArrays sheet = test::planeGrid(6, 6, 20);
    const Garment garment = oddGarment({sheet, turnedOver(moved(sheet, 120))});
    ASSERT_TRUE(std::ranges::any_of(garment.seams.seams,
                                    [](const Seam& seam) { return seam.kind != SeamKind::Free; }));
    const MeshArrays design = prove::designSurface(garment).value();
    for (Eigen::Index f = 0; f < design.F.rows(); ++f) {
        const Eigen::RowVector3d a = design.V.row(design.F(f, 0));
        const Eigen::RowVector3d u = design.V.row(design.F(f, 1)) - a,
                                 v = design.V.row(design.F(f, 2)) - a;
        EXPECT_GT(u.x() * v.y() - u.y() * v.x(), 0) << f;  // as the first piece's
    }
    const auto proof = proofOfResults(garment, flatResults(garment));
    ASSERT_TRUE(proof) << sentence(proof.error());
    expectFinite(garment, **proof);
    EXPECT_LT((*proof)->gap.max, 0.01);
}

/// A sector whose two sides are sewn to each other up to the tip: there a triangle between the
/// first points of both collapses.
TEST(OddProof, AConeWithItsTipIsSewn) {
    constexpr int kRings = 6, kAround = 12;
    std::vector<Eigen::RowVector3d> points{{0, 0, 0}};
    const double radius = 1.0 / 6, fall = std::sqrt(1 - radius * radius);  // 60 degrees, flat
    for (int ring = 1; ring <= kRings; ++ring) {
        for (int k = 0; k <= kAround; ++k) {
            const double angle = 2 * std::numbers::pi * k / kAround, slant = 25.0 * ring;
            points.emplace_back(slant * radius * std::sin(angle), -slant * fall,
                                slant * radius * std::cos(angle));
        }
    }
    const auto at = [](int ring, int k) { return 1 + (ring - 1) * (kAround + 1) + k; };
    std::vector<Eigen::RowVector3i> faces;
    for (int k = 0; k < kAround; ++k) {
        faces.emplace_back(0, at(1, k), at(1, k + 1));
        for (int ring = 1; ring < kRings; ++ring) {
            faces.emplace_back(at(ring, k), at(ring + 1, k), at(ring + 1, k + 1));
            faces.emplace_back(at(ring, k), at(ring + 1, k + 1), at(ring, k + 1));
        }
    }
    MeshArrays cone{Points3(std::ssize(points), 3), Triangles(std::ssize(faces), 3)};
    for (Eigen::Index v = 0; v < cone.V.rows(); ++v) {
        cone.V.row(v) = points[v];
    }
    for (Eigen::Index f = 0; f < cone.F.rows(); ++f) {
        cone.F.row(f) = faces[f];
    }
    const Garment garment = oddGarment({cone});
    ASSERT_FALSE(garment.seams.seams.empty());
    const PieceResults results = flatResults(garment);
    const LaidOutPattern laid = inRows(garment, results);
    for (const double edge : {0.0, 12.0, 7.0}) {
        ProofOrder order;
        order.settings.edge = edge;
        const auto proof = proofOf(ExportSource(garment, results, laid), order, {});
        ASSERT_TRUE(proof) << edge << ": " << sentence(proof.error());
        expectFinite(garment, **proof);
        EXPECT_TRUE((*proof)->hasSettled);
        EXPECT_LT((*proof)->gap.mean, 2) << edge;
    }
}

/// A million triangles would take minutes a step, in which nobody is heard.
TEST(OddProof, EdgesThatMakeTooManyTrianglesAreRefused) {
    const Garment garment =
        oddGarment({test::meshOf({{0, 0, 0}, {1000, 0, 0}, {0, 800, 0}}, {{0, 1, 2}})});  // 0.4 m2
    const PieceResults results = flatResults(garment);
    const LaidOutPattern laid = inRows(garment, results);
    ProofOrder order;
    order.settings.edge = kMinProofEdge;
    const auto proof = proofOf(ExportSource(garment, results, laid), order, {});
    ASSERT_FALSE(proof);
    EXPECT_EQ(proof.error().code, ErrorCode::OutOfMemory);
    // 400 000 mm2 are 923 760 equal triangles.
    EXPECT_NE(sentence(proof.error()).find("use edges of 1.8 mm or more"), std::string::npos)
        << sentence(proof.error());
}

TEST(OddProof, AThirdLayerIsSewnIntoTheSameSeam) {
    const MeshArrays sheet = test::planeGrid(6, 6, 20);
    MeshArrays flap = sheet;
    for (Eigen::Index v = 0; v < flap.V.rows(); ++v) {  // stands off the second sheet
        const double x = flap.V(v, 0);
        flap.V(v, 0) = 120 + 0.8 * x;
        flap.V(v, 2) = 0.6 * x;
    }
    const Garment garment = oddGarment({sheet, moved(sheet, 120), flap});
    EXPECT_EQ(std::ranges::count(garment.seams.seams, true, &Seam::stacked), 1);
    const auto proof = proofOfResults(garment, flatResults(garment));
    ASSERT_TRUE(proof) << sentence(proof.error());
    expectFinite(garment, **proof);
    EXPECT_TRUE((*proof)->hasSettled);
    EXPECT_TRUE((*proof)->faults.empty());
    const auto atSeam = [&](std::size_t p) {
        std::vector<Eigen::RowVector3d> places;  // along y
        for (Eigen::Index v = 0; v < sheet.V.rows(); ++v) {
            if (std::abs(garment.pieces[p]->mesh.V(v, 0) - 120) < 1e-9) {
                places.emplace_back((*proof)->pieces[p].sewn.row(v));
            }
        }
        return places;
    };
    const auto first = atSeam(0);
    ASSERT_EQ(first.size(), 7U);
    for (const std::size_t p : {1, 2}) {
        const auto other = atSeam(p);
        ASSERT_EQ(other.size(), first.size());
        for (std::size_t k = 0; k < first.size(); ++k) {
            EXPECT_LT((first[k] - other[k]).norm(), 1e-6) << p << " " << k;
        }
    }
}

TEST(OddProof, SingleTrianglesAreCloth) {
    const Garment garment =
        oddGarment({test::meshOf({{0, 0, 0}, {60, 0, 0}, {0, 80, 0}}, {{0, 1, 2}}),
                    test::meshOf({{60, 0, 0}, {60, 80, 5}, {0, 80, 0}}, {{0, 1, 2}})});
    const auto proof = proofOfResults(garment, flatResults(garment));
    ASSERT_TRUE(proof) << sentence(proof.error());
    expectFinite(garment, **proof);
}

}  // namespace
}  // namespace toile
