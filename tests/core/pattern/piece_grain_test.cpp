// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/piece_grain.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/pattern/half_pattern.h"
#include "core/pattern/mirrored_edit.h"
#include "core/quality/grain_cost.h"
#include "core/seam/find_seams.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/symmetry/mirror_shapes.h"

namespace toile {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// One piece whose flat coordinates are given.
struct FlatGarment {
    Garment garment;
    PieceResults results;
};

FlatGarment flatGarment(MeshArrays mesh, Points2 Q, std::optional<Points2> reference = {}) {
    FlatGarment made;
    Piece piece = makePiece("piece", std::move(mesh));
    piece.reference = std::move(reference);
    const auto shared = std::make_shared<const Piece>(std::move(piece));
    made.garment.pieces = {shared};
    made.garment.seams = findSeams(made.garment.pieces);
    auto result = std::make_shared<PieceResult>();
    result->piece = shared;
    result->flat.emplace().Q = std::move(Q);
    made.results = {result};
    return made;
}

std::optional<double> grainOf(const FlatGarment& flat, GrainRule rule) {
    return findGrains(flat.garment, flat.results, nullptr, rule, {*fabricPreset("woven")}).front();
}

Points2 turnedBy(const Points2& points, double angle) {
    return points * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose();
}

/// Of two directions, in [0, pi].
double between(double a, double b) {
    return std::abs(std::remainder(a - b, kTurn));
}

/// An upright sheet, and the same lying in the plane.
MeshArrays uprightSheet() {
    return test::planeGrid(4, 6, 50);
}

Points2 inThePlane(const MeshArrays& mesh) {
    return mesh.V.leftCols(2);
}

TEST(PieceGrain, RunsUpTheGarmentHoweverThePieceLies) {
    const MeshArrays mesh = uprightSheet();
    for (const double angle : {0.0, 0.7, 2.5, -1.2}) {
        const auto grain =
            grainOf(flatGarment(mesh, turnedBy(inThePlane(mesh), angle)), GrainRule::Vertical);
        ASSERT_TRUE(grain);
        EXPECT_NEAR(between(*grain, std::numbers::pi / 2 + angle), 0, 1e-12);
    }
}

TEST(PieceGrain, IsUnsetWhereThePieceLiesLevel) {
    MeshArrays mesh = uprightSheet();
    const Points2 Q = inThePlane(mesh);
    mesh.V.col(2) = mesh.V.col(1);
    mesh.V.col(1).setConstant(3);
    EXPECT_FALSE(grainOf(flatGarment(mesh, Q), GrainRule::Vertical));
}

/// A tube along x, open along its underside, with the flat piece as it is unrolled.
FlatGarment lyingTube(double share) {
    MeshArrays mesh = test::planeGrid(8, 24, 1);
    Points2 Q(mesh.V.rows(), 2);
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        const double along = 40 * mesh.V(v, 0);
        const double angle = share * kTurn * (mesh.V(v, 1) / 24 - 0.5);
        mesh.V.row(v) << along, 60 * std::cos(angle), 60 * std::sin(angle);
        Q.row(v) << along, 60 * angle;
    }
    return flatGarment(std::move(mesh), std::move(Q));
}

TEST(PieceGrain, RunsAlongASleeveThatIsHeldOut) {
    const auto grain = grainOf(lyingTube(1), GrainRule::Vertical);
    ASSERT_TRUE(grain);
    EXPECT_NEAR(std::abs(std::sin(*grain)), 0, 1e-6);
}

TEST(PieceGrain, RunsOverTheShoulderOfAPieceThatIsNoTube) {
    const auto grain = grainOf(lyingTube(0.6), GrainRule::Vertical);
    ASSERT_TRUE(grain);
    EXPECT_NEAR(std::abs(std::cos(*grain)), 0, 1e-6);
}

TEST(PieceGrain, FollowsTheReferencePanel) {
    const MeshArrays mesh = uprightSheet();
    const Points2 Q = inThePlane(mesh);
    const auto grain =
        grainOf(flatGarment(mesh, Q, turnedBy(Q, std::numbers::pi / 3)), GrainRule::Reference);
    ASSERT_TRUE(grain);
    EXPECT_NEAR(between(*grain, std::numbers::pi / 6), 0, 1e-12);
    const auto without = grainOf(flatGarment(mesh, Q), GrainRule::Reference);
    ASSERT_TRUE(without);
    EXPECT_NEAR(between(*without, std::numbers::pi / 2), 0, 1e-12);
}

TEST(PieceGrain, IsTurnedOnlyWhereTheClothSuffersLessByThat) {
    const MeshArrays mesh = uprightSheet();
    const auto least = [&](double x, double y) -> double {
        Points2 Q = inThePlane(mesh);
        Q.col(0) *= x;
        Q.col(1) *= y;
        return grainOf(flatGarment(mesh, Q), GrainRule::LeastStrain).value_or(99);
    };
    EXPECT_NEAR(least(1, 1), std::numbers::pi / 2, 1e-12);
    const double stretched = least(1, 0.8);  // the cloth must give way upwards
    const double turn = between(stretched, std::numbers::pi / 2) / (std::numbers::pi / 4);
    EXPECT_NEAR(turn, std::round(turn), 1e-9);
    EXPECT_GT(turn, 0.5);
}

TEST(PieceGrain, NoTurnPutsMoreOfTheClothBeyondTheFabric) {
    const MeshArrays mesh = uprightSheet();
    const Fabric& woven = *fabricPreset("woven");
    for (int i = 0; i < 24; ++i) {
        Points2 Q = inThePlane(mesh);
        const double t = 0.7 * i;
        for (Eigen::Index v = 0; v < Q.rows(); ++v) {  // another strain in every place
            Q.row(v) += 6 * Eigen::RowVector2d(std::sin(t + mesh.V(v, 1) / 90),
                                               std::cos(2 * t + mesh.V(v, 0) / 70));
        }
        const FlatGarment flat = flatGarment(mesh, Q);
        const auto straight = grainOf(flat, GrainRule::Vertical);
        const auto best = grainOf(flat, GrainRule::LeastStrain);
        ASSERT_TRUE(straight && best);
        EXPECT_LE(strainedArea(mesh, Q, woven, *best).share(),
                  strainedArea(mesh, Q, woven, *straight).share() + 1e-12);
    }
}

class GrainOfPairs : public testing::TestWithParam<const char*> {};

TEST_P(GrainOfPairs, IsOneAnswerForBoth) {
    const std::string file = GetParam();
    if (file != "tube") {
        TOILE_NEEDS_SHARED(test::dataFile(file));
    }
    const Garment garment = file == "tube" ? test::tube4(test::draped) : test::garmentOf(file);
    LineSettings lines;
    lines.mirror = Mirror::Mean;
    FlattenOptions options;
    options.method = Method::Curvature;
    Progress progress;
    const PieceResults results = flattenGarment(garment, options, progress, 0, lines);
    const auto symmetry = findSymmetry(garment);
    ASSERT_TRUE(symmetry);
    for (const auto& [rule, word] : kGrainRuleWords) {
        const auto grains =
            findGrains(garment, results, &*symmetry, rule, std::vector<Fabric>(results.size()));
        for (int p = 0; p < static_cast<int>(grains.size()); ++p) {
            const int other = symmetry->pieces.counterpart[p];
            if (other <= p) {
                continue;
            }
            ASSERT_TRUE(grains[p] && grains[other]) << word;
            const auto image = mirroredDirection(garment, results, *symmetry, p, *grains[p]);
            ASSERT_TRUE(image);
            EXPECT_NEAR(between(*image, *grains[other]), 0, 1e-12) << word << ' ' << p;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Garments, GrainOfPairs, testing::Values("tube", "garments/tee_sim.obj"));

class GrainOfSymmetric : public testing::TestWithParam<const char*> {};

TEST_P(GrainOfSymmetric, IsParallelToTheFold) {
    const std::string file = GetParam();
    if (file != "tube") {
        TOILE_NEEDS_SHARED(test::dataFile(file));
    }
    const Garment garment = file == "tube" ? test::tube4(test::draped) : test::garmentOf(file);
    LineSettings lines;
    lines.mirror = Mirror::Mean;
    Progress progress;
    const PieceResults results = flattenGarment(garment, {Method::Curvature}, progress, 0, lines);
    const auto symmetry = findSymmetry(garment);
    ASSERT_TRUE(symmetry);
    const std::vector<DrawnMirror> mirrors = drawnMirrors(results);
    int symmetric = 0;
    for (const auto& [rule, word] : kGrainRuleWords) {
        const auto grains =
            findGrains(garment, results, &*symmetry, rule, std::vector<Fabric>(results.size()));
        for (std::size_t p = 0; p < grains.size(); ++p) {
            if (!mirrors[p].isSymmetric || !grains[p]) {
                continue;
            }
            ++symmetric;
            const Points2& line = results[p]->flat->line->points;
            const Eigen::RowVector2d fold = line.row(line.rows() / 2) - line.row(0);
            const double off = *grains[p] - std::atan2(fold.y(), fold.x());
            // Along the fold or square to it; where the cloth suffers less by it, on the bias.
            const double steps = rule == GrainRule::Vertical ? 2 : 4;
            EXPECT_NEAR(std::sin(steps * off), 0, 1e-12) << word << ' ' << p;
            EXPECT_LE(std::abs(*grains[p]), 2 * std::numbers::pi) << word << ' ' << p;
        }
    }
    EXPECT_GT(symmetric, 0);
}

INSTANTIATE_TEST_SUITE_P(Garments, GrainOfSymmetric,
                         testing::Values("tube", "samples/tshirt.obj", "garments/tee_sim.obj",
                                         "garments/dress.obj"));

class GrainOfDesigns : public testing::TestWithParam<const char*> {};

/// Designers lay panels as the garment hangs: the rules agree about the trunk.
TEST_P(GrainOfDesigns, IsUpThePanels) {
    const auto path = test::dataFile(GetParam());
    TOILE_NEEDS_SHARED(path);
    const Garment garment = test::garmentOf(GetParam());
    FlattenOptions options;
    options.method = Method::Curvature;
    Progress progress;
    const PieceResults results = flattenGarment(garment, options, progress);
    const auto hanging = findGrains(garment, results, nullptr, GrainRule::Vertical,
                                    std::vector<Fabric>(results.size()));
    const auto designed = findGrains(garment, results, nullptr, GrainRule::Reference,
                                     std::vector<Fabric>(results.size()));
    for (std::size_t p = 0; p < results.size(); ++p) {
        ASSERT_TRUE(hanging[p] && designed[p]);
        EXPECT_LT(std::abs(std::sin(*hanging[p] - *designed[p])), std::sin(0.2))
            << results[p]->piece->name;
    }
}

INSTANTIATE_TEST_SUITE_P(Garments, GrainOfDesigns,
                         testing::Values("garments/tee_sim.obj", "garments/polo.obj",
                                         "garments/skirt_clo.obj", "garments/longsleeve.obj"));

}  // namespace
}  // namespace toile
