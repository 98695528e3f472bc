// SPDX-License-Identifier: GPL-3.0-or-later
// Real meshes against the figures of an independent prototype. The data stands beside the project.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/flatten/interior/interior.h"
#include "core/mesh/cotangents.h"
#include "core/quality/measures.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/turned_triangles.h"

namespace toile {
namespace {

nlohmann::json expectedFigures() {
    std::ifstream file(test::sharedFile("../expected.json"));
    return nlohmann::json::parse(file);
}

std::vector<std::string> disksAndDress() {
    return {"disks/cylinder_locally_refined.off",
            "disks/face.obj",
            "disks/hemisphere.obj",
            "disks/lion-head.off",
            "disks/mannequin-devil.off",
            "disks/maxface.obj",
            "disks/maze.obj",
            "disks/nefertiti.off",
            "disks/patch-30.off",
            "disks/three_peaks.off",
            "garments/dress14_pieces.obj",
            "garments/dress.obj",
            "garments/longsleeve.obj",
            "garments/polo.obj",
            "garments/tee_sim.obj",
            "garments/tshirt.obj",
            "garments/tee_sim_pieces.obj",
            "garments/polo_pieces.obj"};
}

/// The entry of a piece: by its number, or, for the garments whose panels were put apart (in
/// another order than the welded file lists them), the one of the same size and nearest Pi_theta.
nlohmann::json takeEntry(nlohmann::json& all, const std::string& file, std::size_t number,
                         const PieceResult& result, std::size_t pieces) {
    const std::string method(name(result.options.method));
    if (pieces == 1) {
        return all.at(file);
    }
    if (file.find("_pieces") == std::string::npos || file.find("dress14") != std::string::npos) {
        return all.at(file + "#" + std::to_string(number));
    }
    std::string welded = file;
    welded.erase(welded.find("_pieces"), std::string("_pieces").size());
    nlohmann::json best;
    std::string bestKey;
    for (std::size_t k = 0; k < pieces; ++k) {
        const std::string key = welded + "#" + std::to_string(k);
        if (!all.contains(key)) {
            continue;  // taken by another piece
        }
        const nlohmann::json& entry = all.at(key);
        const auto distance = [&](const nlohmann::json& of) {
            return std::abs(of[method]["pi_theta"].get<double>() - result.quality->piTheta);
        };
        if (entry["faces"] == result.piece->mesh.F.rows() &&
            (best.is_null() || distance(entry) < distance(best))) {
            best = entry;
            bestKey = key;
        }
    }
    all.erase(bestKey);
    return best;
}

/// The prototype knows the mesh's own weights only: the same outline filled with these, where the
/// result was placed by others.
Points2 byPlainWeights(const PieceResult& result) {
    if (result.flat->delaunayFlips == 0) {
        return result.flat->Q;
    }
    const Piece& piece = *result.piece;
    Points2 outline(static_cast<Eigen::Index>(piece.boundary.size()), 2);
    for (std::size_t i = 0; i < piece.boundary.size(); ++i) {
        outline.row(static_cast<Eigen::Index>(i)) = result.flat->Q.row(piece.boundary[i]);
    }
    const auto points = fillInterior({piece.table.edges, cotangentWeights(piece.mesh, piece.table)},
                                     piece.mesh.V, piece.boundary, outline, Progress());
    EXPECT_TRUE(points);
    return *points;
}

class ExpectedFigures
    : public testing::TestWithParam<std::tuple<std::string, Method, BoundarySolver>> {};

TEST_P(ExpectedFigures, AreMet) {
    const auto& [file, method, solver] = GetParam();
    TOILE_NEEDS_SHARED(test::sharedFile(file));
    TOILE_NEEDS_SHARED(test::sharedFile("../expected.json"));
    nlohmann::json all = expectedFigures();
    Progress progress;
    const auto garment = loadGarment({test::sharedFile(file)}, {LengthUnit::Metre}, progress);
    ASSERT_TRUE(garment) << sentence(garment.error());
    const PieceResults results = flattenGarment(*garment, {method, solver}, progress);
    const std::string key(name(method));
    for (std::size_t k = 0; k < results.size(); ++k) {
        SCOPED_TRACE(results[k]->piece->name);
        ASSERT_TRUE(results[k]->flat) << sentence(*results[k]->error);
        const nlohmann::json entry = takeEntry(all, file, k, *results[k], results.size());
        ASSERT_TRUE(entry.contains(key));
        const nlohmann::json& expected = entry[key];
        const Points2 placed = byPlainWeights(*results[k]);
        const PieceQuality quality = measure(*results[k]->piece, placed);
        EXPECT_LE(results[k]->quality->flippedTriangles, quality.flippedTriangles);
        ASSERT_EQ(results[k]->piece->mesh.F.rows(), entry["faces"].get<int>());
        ASSERT_EQ(results[k]->piece->boundary.size(), entry["boundary"].get<std::size_t>());
        EXPECT_NEAR(quality.piTheta, expected["pi_theta"].get<double>(), 1e-5);
        EXPECT_NEAR(quality.piE, expected["pi_e"].get<double>(), 1e-5);
        EXPECT_NEAR(quality.piA, expected["pi_a"].get<double>(), 1e-5);
        // It counts by the sign of areas, and none that has collapsed.
        const int turned = test::turnedTriangles(placed, results[k]->piece->mesh.F);
        EXPECT_EQ(turned, expected["flipped"].get<int>());
        EXPECT_GE(quality.flippedTriangles, turned);
        EXPECT_EQ(quality.outlineCrossings, expected["crossings"].get<int>());
        EXPECT_NEAR(results[k]->flat->angleEnergy, expected["angle_energy"].get<double>(), 1e-6);
        EXPECT_LE(results[k]->flat->closureGap, 1e-10);
        EXPECT_LE(quality.maxBoundaryLengthError, 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(SharedSlow, ExpectedFigures,
                         testing::Combine(testing::ValuesIn(disksAndDress()),
                                          testing::Values(Method::Wang2005, Method::Curvature),
                                          testing::Values(BoundarySolver::Newton,
                                                          BoundarySolver::Slcp)),
                         [](const auto& shown) {
                             std::string text = std::get<0>(shown.param) + "_" +
                                                std::string(name(std::get<1>(shown.param))) + "_" +
                                                std::string(name(std::get<2>(shown.param)));
                             std::replace_if(
                                 text.begin(), text.end(),
                                 [](char c) { return std::isalnum(c) == 0; }, '_');
                             return text;
                         });

TEST(RealGarments, DelaunayWeightsTakeTheFlipsFromAnObtuseDisk) {
    const auto file = test::sharedFile("disks/three_peaks.off");
    TOILE_NEEDS_SHARED(file);
    Progress progress;
    const auto garment = loadGarment({file}, {LengthUnit::Metre}, progress);
    ASSERT_TRUE(garment);
    for (const Method method : {Method::Wang2005, Method::Curvature}) {
        SCOPED_TRACE(name(method));
        const auto result = flattenGarment(*garment, {method}, progress).front();
        ASSERT_TRUE(result->flat);
        EXPECT_EQ(result->flat->delaunayFlips, 104);
        EXPECT_EQ(result->quality->flippedTriangles, 0);
        EXPECT_EQ(measure(*result->piece, byPlainWeights(*result)).flippedTriangles, 33);
    }
}

class SolversOfData : public testing::TestWithParam<const char*> {};

TEST_P(SolversOfData, AgreeOnEveryPiece) {
    const auto file = test::dataFile(GetParam());
    TOILE_NEEDS_SHARED(file);
    Progress progress;
    const auto garment = loadGarment({file}, {LengthUnit::Metre}, progress);
    ASSERT_TRUE(garment);
    const auto newton =
        flattenGarment(*garment, {Method::Wang2005, BoundarySolver::Newton}, progress);
    const auto slcp = flattenGarment(*garment, {Method::Wang2005, BoundarySolver::Slcp}, progress);
    ASSERT_FALSE(newton.empty());
    for (std::size_t k = 0; k < newton.size(); ++k) {
        SCOPED_TRACE(newton[k]->piece->name);
        ASSERT_EQ(newton[k]->flat.has_value(), slcp[k]->flat.has_value());
        if (newton[k]->flat) {
            EXPECT_LE((newton[k]->flat->Q - slcp[k]->flat->Q).cwiseAbs().maxCoeff(),
                      1e-9 * newton[k]->quality->perimeter3d);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, SolversOfData,
                         testing::Values("samples/tshirt.obj", "samples/bodice.obj",
                                         "samples/trousers.obj", "samples/cap.obj",
                                         "samples/skirt.obj", "samples/shapes/cube-h.obj"));
INSTANTIATE_TEST_SUITE_P(Shared, SolversOfData,
                         testing::Values("garments/dress14_pieces.obj",
                                         "garments/tee_sim_pieces.obj", "garments/polo_pieces.obj",
                                         "garments/skirt_clo.obj"));

TEST(RealGarments, TheTeeHasItsMeanEdgeError) {
    const auto file = test::sharedFile("garments/tee_sim_pieces.obj");
    TOILE_NEEDS_SHARED(file);
    Progress progress;
    const auto garment = loadGarment({file}, {LengthUnit::Centimetre}, progress);
    ASSERT_TRUE(garment);
    double mean = 0;
    for (const auto& result : flattenGarment(*garment, {Method::Wang2005}, progress)) {
        ASSERT_TRUE(result->flat);
        EXPECT_EQ(result->quality->flippedTriangles, 0);
        mean += result->quality->piE / 6;
    }
    EXPECT_EQ(garment->pieces.size(), 6U);
    EXPECT_NEAR(mean, 0.0211, 0.02 * 0.0211);
}

void expectFlattenedExactly(const Garment& garment) {
    Progress progress;
    for (const BoundarySolver solver : {BoundarySolver::Newton, BoundarySolver::Slcp}) {
        const auto results = flattenGarment(garment, {Method::Wang2005, solver}, progress);
        ASSERT_TRUE(results.front()->flat) << sentence(*results.front()->error);
        EXPECT_LE(results.front()->quality->maxBoundaryLengthError, 1e-9);
    }
}

TEST(RealGarments, ATinyAndAFarPanelAreFlattenedExactly) {
    for (const char* name : {"nasty/panel_tiny.obj", "nasty/panel_far.obj"}) {
        SCOPED_TRACE(name);
        const auto file = test::sharedFile(name);
        TOILE_NEEDS_SHARED(file);
        Progress progress;
        const auto garment = loadGarment({file}, {LengthUnit::Centimetre}, progress);
        ASSERT_TRUE(garment);
        expectFlattenedExactly(*garment);
    }
}

TEST(RealGarments, ATinyAndAFarSampleAreFlattenedExactly) {
    Progress progress;
    const auto garment =
        loadGarment({test::dataFile("samples/tshirt.obj")}, {LengthUnit::Millimetre}, progress);
    ASSERT_TRUE(garment);
    for (const auto& [scale, away] : {std::pair(1e-7, 0.0), std::pair(1.0, 1e6)}) {
        SCOPED_TRACE(scale);
        MeshArrays mesh = garment->pieces[2]->mesh;
        mesh.V = (mesh.V * scale).array() + away;
        Garment moved;
        moved.pieces = {std::make_shared<const Piece>(makePiece("sleeve", std::move(mesh)))};
        expectFlattenedExactly(moved);
    }
}

/// Means over a garment's pieces.
struct Means {
    const char* file;
    Method method;
    double piTheta, piE, piA;
};

/// Our own garments have no prototype: the figures are those of the program when it met all of the
/// prototype's, by either solver.
class SampleFigures : public testing::TestWithParam<std::tuple<Means, BoundarySolver>> {};

TEST_P(SampleFigures, AreMet) {
    const auto& [expected, solver] = GetParam();
    Progress progress;
    const auto garment =
        loadGarment({test::dataFile(expected.file)}, {LengthUnit::Millimetre}, progress);
    ASSERT_TRUE(garment) << sentence(garment.error());
    const PieceResults results = flattenGarment(*garment, {expected.method, solver}, progress);
    Eigen::Array3d sum = Eigen::Array3d::Zero();
    for (const auto& result : results) {
        SCOPED_TRACE(result->piece->name);
        ASSERT_TRUE(result->flat) << sentence(*result->error);
        const PieceQuality quality = measure(*result->piece, byPlainWeights(*result));
        sum += Eigen::Array3d(quality.piTheta, quality.piE, quality.piA);
        EXPECT_LE(result->flat->closureGap, 1e-10);
        EXPECT_LE(quality.maxBoundaryLengthError, 1e-9);
        EXPECT_EQ(result->quality->flippedTriangles, 0);
        EXPECT_EQ(quality.outlineCrossings, 0);
    }
    sum /= static_cast<double>(results.size());
    EXPECT_NEAR(sum[0], expected.piTheta, 1e-5);
    EXPECT_NEAR(sum[1], expected.piE, 1e-5);
    EXPECT_NEAR(sum[2], expected.piA, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(
    Samples, SampleFigures,
    testing::Combine(
        testing::Values(
            Means{"samples/tshirt.obj", Method::Wang2005, 0.01187023, 0.03683995, 0.06518020},
            Means{"samples/tshirt.obj", Method::Curvature, 0.01270643, 0.02312804, 0.04624152},
            Means{"samples/bodice.obj", Method::Wang2005, 0.00665853, 0.03833777, 0.06868338},
            Means{"samples/bodice.obj", Method::Curvature, 0.00837733, 0.01498078, 0.03126422},
            Means{"samples/trousers.obj", Method::Wang2005, 0.00354035, 0.03048424, 0.04624247},
            Means{"samples/trousers.obj", Method::Curvature, 0.00579612, 0.01148561, 0.02341747},
            Means{"samples/cap.obj", Method::Wang2005, 0.01412366, 0.03217298, 0.05213747},
            Means{"samples/cap.obj", Method::Curvature, 0.01417874, 0.01817053, 0.03514741},
            Means{"samples/skirt.obj", Method::Wang2005, 0.00191177, 0.01103703, 0.01965560},
            Means{"samples/skirt.obj", Method::Curvature, 0.00278153, 0.00338315, 0.00690367}),
        testing::Values(BoundarySolver::Newton, BoundarySolver::Slcp)));

}  // namespace
}  // namespace toile
