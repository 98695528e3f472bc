// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/piece_grain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/pattern/half_pattern.h"
#include "core/pattern/mirrored_edit.h"
#include "core/quality/metric_tensor.h"
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

Garment garmentOfPiece(MeshArrays mesh, std::optional<Points2> reference = {}) {
    return flatGarment(std::move(mesh), {}, std::move(reference)).garment;
}

MeshArrays turnedInSpace(MeshArrays mesh, const Eigen::Matrix3d& turn) {
    mesh.V = mesh.V * turn.transpose();
    return mesh;
}

const Eigen::Matrix3d kSomeTurn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();

/// The angle of the warp in the flat piece: the mean over the area, or of its lines if their
/// senses cancel out.
double throughFlat(const PieceCloth& cloth, const MeshArrays& mesh, const Points2& Q) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::RowVector3i c = mesh.F.row(f);
        Eigen::Matrix<double, 3, 2> worn;
        worn << (mesh.V.row(c[1]) - mesh.V.row(c[0])).transpose(),
            (mesh.V.row(c[2]) - mesh.V.row(c[0])).transpose();
        Eigen::Matrix2d flat;
        flat << (Q.row(c[1]) - Q.row(c[0])).transpose(), (Q.row(c[2]) - Q.row(c[0])).transpose();
        const Eigen::Vector2d parts = worn.colPivHouseholderQr().solve(warpIn(cloth, mesh, f));
        sum += flat.determinant() * flat * parts;
    }
    return std::atan2(sum.y(), sum.x());
}

/// Of two lines, in [0, pi / 2].
double betweenLines(double a, double b) {
    return std::abs(std::remainder(a - b, std::numbers::pi));
}

TEST(PieceCloth, RunsUpPlanesCylindersAndCones) {
    for (const MeshArrays& mesh : {uprightSheet(), test::cylinderSector(8, 6, 90, 1.5, 200),
                                   test::coneSector(30, 6, 100, 300, 1.5, 0.3)}) {
        const auto cloth = pieceCloths(garmentOfPiece(mesh), GrainRule::Vertical, {}).front();
        for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
            const Eigen::Vector3d warp = warpIn(*cloth, mesh, f);
            // In the triangle's plane, and the steepest direction there.
            EXPECT_NEAR(warp.y(), warp.squaredNorm(), 1e-12);
            EXPECT_GT(warp.y(), 0.5);
        }
    }
}

TEST(PieceCloth, HasNoWarpWhereThePieceLiesLevelOrNoRuleIsGiven) {
    MeshArrays mesh = uprightSheet();
    EXPECT_EQ(pieceCloths(garmentOfPiece(mesh), {}, {}).front()->warp.rows(), 0);
    mesh.V.col(2) = mesh.V.col(1);
    mesh.V.col(1).setConstant(3);
    EXPECT_EQ(pieceCloths(garmentOfPiece(mesh), GrainRule::Vertical, {}).front()->warp.rows(), 0);
}

TEST(PieceCloth, FindsTheAxisOfPlanesCylindersAndConesHoweverTheyLie) {
    for (const double turn : {0.4, 1.0, 2.0, 4.0, 6.2}) {
        for (const MeshArrays& mesh :
             {test::planeGrid(3, 7, 40), test::cylinderSector(16, 5, 60, turn, 200),
              test::coneSector(24, 5, 300, 700, std::max(turn, 2.0), 0.2)}) {
            for (const Eigen::Matrix3d& way :
                 {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), kSomeTurn}) {
                const Points3 axis = axisWarp(turnedInSpace(mesh, way));
                const Eigen::Vector3d up = way.col(1);
                EXPECT_NEAR(std::abs(axis.row(0).dot(up)), 1, 1e-9) << turn;
            }
        }
    }
}

TEST(PieceCloth, RunsAlongALyingTubeThatIsSewnToItself) {
    MeshArrays mesh = test::cylinderSector(16, 5, 60, kTurn, 200);
    mesh.V = mesh.V * Eigen::AngleAxisd(kTurn / 4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Garment garment = garmentOfPiece(mesh);
    ASSERT_EQ(garment.seams.seams.front().left.piece, garment.seams.seams.front().right.piece);
    const auto cloth = pieceCloths(garment, GrainRule::Vertical, {}).front();
    ASSERT_EQ(cloth->warp.rows(), 1);
    EXPECT_NEAR(std::abs(cloth->warp(0, 0)), 1, 1e-9);
}

/// The direction found before anything is flat is the grain that is found in the flat piece: on
/// developable pieces exactly, on curved ones within 0.02 rad.
TEST(PieceCloth, AgreesWithTheGrainOfTheFlatPiece) {
    const std::pair<MeshArrays, double> shapes[] = {
        {uprightSheet(), 1e-9},
        {test::cylinderSector(12, 8, 90, 1.5, 200), 1e-6},
        {test::coneSector(24, 6, 300, 700, 2.0, 0.2), 1e-3},
        {test::bentPanel(12), 0.02},
        {test::saddle(12, 200, 0.5), 0.02},
        {test::cylinderSector(16, 6, 60, kTurn, 200), 1e-3}};
    for (const auto& [mesh, tolerance] : shapes) {
        const Garment garment = garmentOfPiece(mesh);
        Progress progress;
        const PieceResults results = flattenGarment(garment, {}, progress);
        ASSERT_TRUE(results.front()->flat);
        const Points2& Q = results.front()->flat->Q;
        const auto found = findGrains(garment, results, nullptr, GrainRule::Vertical, {{}});
        const auto cloth = pieceCloths(garment, GrainRule::Vertical, {}).front();
        ASSERT_TRUE(found.front());
        EXPECT_LT(betweenLines(throughFlat(*cloth, mesh, Q), *found.front()), tolerance);
        // A grain typed on the flat piece comes back through the same map: its directions at
        // vertices are means over facets.
        const auto typed = pieceCloths(garment, {}, {}, results, {0.3}).front();
        EXPECT_LT(betweenLines(throughFlat(*typed, mesh, Q), 0.3), 0.02);
    }
}

TEST(PieceCloth, RunsUpTheReferencePanelAlsoIfItIsMirrored) {
    const MeshArrays mesh = test::cylinderSector(12, 8, 90, 1.5, 200);
    Progress progress;
    const PieceResults results = flattenGarment(garmentOfPiece(mesh), {}, progress);
    const Points2& Q = results.front()->flat->Q;
    for (const double mirrored : {1.0, -1.0}) {
        Points2 panel = turnedBy(Q, 0.7);
        panel.col(0) *= mirrored;
        const auto cloth =
            pieceCloths(garmentOfPiece(mesh, panel), GrainRule::Reference, {}).front();
        EXPECT_LT(betweenLines(throughFlat(*cloth, mesh, Q), std::numbers::pi / 2 - 0.7), 0.005);
    }
}

TEST(PieceCloth, CarriesFabricAndStiffness) {
    const auto cloth = pieceCloths(garmentOfPiece(uprightSheet()), {}, {*fabricPreset("denim")});
    EXPECT_EQ(cloth.front()->fabric.id, "denim");
    EXPECT_EQ(cloth.front()->stiffness, clothStiffness(*fabricPreset("denim")));
}

}  // namespace
}  // namespace toile
