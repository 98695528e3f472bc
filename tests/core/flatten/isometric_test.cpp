// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/flatten/interior/interior.h"
#include "core/flatten/isometric/isometric_descent.h"
#include "core/quality/measures.h"
#include "core/quality/outline_crossings.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/flat_trouble.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/turned_triangles.h"

namespace toile {
namespace {

FlattenOptions solvedBy(Method method, Quality quality = Quality::Standard) {
    FlattenOptions options;
    options.method = method;
    options.quality = quality;
    return options;
}

struct Measured {
    FlatPiece flat;
    PieceQuality quality;
};

Measured measured(const Piece& piece, const FlattenOptions& options) {
    Progress progress;
    auto flat = flatten(piece, options, progress);
    EXPECT_TRUE(flat) << sentence(flat.error());
    const PieceQuality quality = measure(piece, flat->Q);
    return {std::move(*flat), quality};
}

/// The triangles' angles at each boundary vertex sum to its planar angle, not to that plus a full
/// turn, and interior ones to one turn: with no triangle flipped, the map is locally one-to-one.
void expectImmersed(const Piece& piece, const Points2& Q) {
    EXPECT_EQ(test::turnedTriangles(Q, piece.mesh.F), 0);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(Q.rows());
    const Eigen::MatrixX3d corners = cornerAngles2d(Q, piece.mesh.F);
    for (int f = 0; f < piece.mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            sum[piece.mesh.F(f, k)] += corners(f, k);
        }
    }
    for (const int v : piece.boundary) {
        sum[v] = 2 * std::numbers::pi;
    }
    EXPECT_LE((sum.array() - 2 * std::numbers::pi).abs().maxCoeff(), 1e-6);
}

TEST(Isometric, LeavesDevelopablePiecesAsTheyAre) {
    for (const MeshArrays& mesh :
         {test::planeGrid(7, 4, 10), test::cylinderSector(12, 6, 50, 2.0, 80),
          test::coneSector(10, 6, 20, 90, 1.5, 0.5), test::flounce(350.5, 80, 200, 60, 4)}) {
        const auto piece = test::asPiece(mesh);
        const Measured result = measured(*piece, solvedBy(Method::Isometric));
        EXPECT_NEAR(*result.quality.symmetricDirichlet, 1, 1e-9);
        EXPECT_LE(result.quality.piE, 1e-6);
        EXPECT_LE(result.quality.maxBoundaryLengthError, 1e-12);
    }
}

TEST(Isometric, IsNeverWorseThanItsStartAndKeepsLengths) {
    for (const MeshArrays& mesh :
         {test::sphericalCap(8, 100, 1.5), test::saddle(10, 100, 0.01), test::cubeOpenedAlongH(),
          test::cubeSlitAlongOneEdge(), test::sliverGrid(12, 13, 10, 3)}) {
        const auto piece = test::asPiece(mesh);
        const Measured start = measured(*piece, solvedBy(Method::Curvature));
        const Measured result = measured(*piece, solvedBy(Method::Isometric));
        ASSERT_TRUE(start.quality.symmetricDirichlet);
        ASSERT_TRUE(result.quality.symmetricDirichlet);
        EXPECT_LE(*result.quality.symmetricDirichlet, *start.quality.symmetricDirichlet);
        EXPECT_LE(result.quality.maxBoundaryLengthError, 1e-11);
        EXPECT_EQ(result.quality.outlineCrossings, 0);
        expectImmersed(*piece, result.flat.Q);
    }
}

TEST(Isometric, DialTradesTimeForDistortion) {
    const auto piece = test::asPiece(test::sphericalCap(10, 100, 2.2));
    const Measured draft = measured(*piece, solvedBy(Method::Isometric, Quality::Draft));
    const Measured standard = measured(*piece, solvedBy(Method::Isometric, Quality::Standard));
    const Measured fine = measured(*piece, solvedBy(Method::Isometric, Quality::Fine));
    EXPECT_LT(draft.flat.interiorIterations, standard.flat.interiorIterations);
    EXPECT_LE(standard.flat.interiorIterations, fine.flat.interiorIterations);
    EXPECT_LE(*standard.quality.symmetricDirichlet, *draft.quality.symmetricDirichlet);
    EXPECT_LE(*fine.quality.symmetricDirichlet, *standard.quality.symmetricDirichlet);
    const double excess = *fine.quality.symmetricDirichlet - 1;
    EXPECT_LE(*standard.quality.symmetricDirichlet - 1, 1.001 * excess);
    EXPECT_LE(*draft.quality.symmetricDirichlet - 1, 1.1 * excess);
}

TEST(Isometric, FindsTheSameFromACircle) {
    const auto piece = test::asPiece(test::sphericalCap(8, 100, 1.5));
    const Progress progress;
    const auto circle = tutteOnCircle(*piece, progress);
    ASSERT_TRUE(circle);
    const auto descended = isometric::lowerIsometricEnergy(piece->mesh, piece->table,
                                                           piece->boundary, *circle, {}, progress);
    ASSERT_TRUE(descended) << sentence(descended.error());
    EXPECT_TRUE(descended->converged);
    const Measured result = measured(*piece, solvedBy(Method::Isometric));
    EXPECT_NEAR(descended->distortion, *result.quality.symmetricDirichlet, 1e-3);
}

/// A closed finger, deeper and deeper over the same rim: flat without flips as long as doubles can
/// hold Tutte's triangles, and beyond that a result with a note, never a failure.
TEST(Isometric, FlattensFingersOrSaysThatItCannot) {
    for (const int along : {20, 60, 200}) {
        constexpr int kAround = 12;
        MeshArrays mesh{Points3::Zero(kAround * along + 1, 3),
                        Triangles::Zero(2 * kAround * (along - 1) + kAround, 3)};
        int face = 0;
        for (int ring = 0; ring < along; ++ring) {
            for (int k = 0; k < kAround; ++k) {
                const double turn = 2 * std::numbers::pi * k / kAround;
                mesh.V.row(kAround * ring + k) << 10 * std::cos(turn), 10 * std::sin(turn),
                    5.0 * ring;
                const int a = kAround * ring + k;
                const int b = kAround * ring + (k + 1) % kAround;
                if (ring + 1 < along) {
                    mesh.F.row(face++) << a, b, a + kAround;
                    mesh.F.row(face++) << b, b + kAround, a + kAround;
                } else {
                    mesh.F.row(face++) << a, b, kAround * along;
                }
            }
        }
        mesh.V.row(kAround * along) << 0, 0, 5.0 * along;
        const auto piece = test::asPiece(mesh);
        ASSERT_FALSE(piece->defect) << sentence(*piece->defect);
        const Measured result = measured(*piece, solvedBy(Method::Isometric));
        EXPECT_TRUE(result.flat.Q.allFinite());
        EXPECT_LE(result.quality.maxBoundaryLengthError, 1e-9);
        const auto told = [&result](ErrorCode code) -> bool {
            return std::ranges::count(result.flat.notes, code, &Error::code) > 0;
        };
        const bool flipped = result.quality.flippedTriangles > 0;
        EXPECT_EQ(flipped, along == 200);
        EXPECT_EQ(told(ErrorCode::TrianglesFlipped), flipped) << along;
        EXPECT_FALSE(flipped && told(ErrorCode::EndedEarly));  // which says that it can be used
    }
}

TEST(Isometric, RefusesAFlippedStart) {
    const auto piece = test::asPiece(test::planeGrid(3, 3, 1));
    Points2 Q = piece->mesh.V.leftCols<2>();
    Q.col(0) *= -1;
    const Progress progress;
    const auto descended = isometric::lowerIsometricEnergy(piece->mesh, piece->table,
                                                           piece->boundary, Q, {}, progress);
    ASSERT_FALSE(descended);
    EXPECT_EQ(descended.error().code, ErrorCode::NotFinite);
}

TEST(Isometric, EndsWhenCancelled) {
    const auto piece = test::asPiece(test::sphericalCap(8, 100, 1.5));
    Progress progress;
    const auto circle = tutteOnCircle(*piece, progress);
    progress.cancel();
    const auto descended = isometric::lowerIsometricEnergy(piece->mesh, piece->table,
                                                           piece->boundary, *circle, {}, progress);
    ASSERT_FALSE(descended);
    EXPECT_EQ(descended.error().code, ErrorCode::Cancelled);
}

TEST(Isometric, MovesTheSidesOfASlitApart) {
    for (const double bend : {0.3, 1.0}) {
        const auto piece = test::asPiece(test::saddleWithSlit(16, 200, bend));
        EXPECT_GT(measured(*piece, solvedBy(Method::Curvature)).quality.outlineCrossings, 0);
        const Measured result = measured(*piece, solvedBy(Method::Isometric));
        EXPECT_EQ(result.quality.outlineCrossings, 0);
        EXPECT_LE(result.quality.maxBoundaryLengthError, 1e-11);
        expectImmersed(*piece, result.flat.Q);
    }
}

/// Every third edge of the outline is split close to its start.
MeshArrays withTinyEdges(MeshArrays mesh) {
    constexpr double kPlace = 0.003;
    const std::vector<int> outline = test::asPiece(MeshArrays(mesh))->boundary;
    for (std::size_t k = 0; k < outline.size(); k += 3) {
        const int from = outline[k];
        const int to = outline[(k + 1) % outline.size()];
        const auto middle = static_cast<int>(mesh.V.rows());
        const auto last = mesh.F.rows();
        mesh.V.conservativeResize(middle + 1, 3);
        mesh.V.row(middle) = (1 - kPlace) * mesh.V.row(from) + kPlace * mesh.V.row(to);
        mesh.F.conservativeResize(last + 1, 3);
        for (int f = 0; f < last; ++f) {
            for (int i = 0; i < 3; ++i) {
                if (mesh.F(f, i) == from && mesh.F(f, (i + 1) % 3) == to) {
                    mesh.F.row(last) << middle, to, mesh.F(f, (i + 2) % 3);
                    mesh.F(f, (i + 1) % 3) = middle;
                }
            }
        }
    }
    return mesh;
}

/// Sides that slide along each other at tiny edges, and so at tiny distances, took 300 steps.
TEST(Isometric, MovesSidesWithTinyEdgesApartInFewSteps) {
    const auto piece = test::asPiece(withTinyEdges(test::saddleWithSlit(16, 200, 1)));
    Progress progress;
    const auto flat = flatten(*piece, solvedBy(Method::Isometric), progress);
    ASSERT_TRUE(flat) << sentence(flat.error());
    EXPECT_EQ(outlineCrossings(flat->Q, piece->boundary), 0);
    EXPECT_GT(flat->apartStrain, 0);
    constexpr int kFew = 100;
    EXPECT_LT(progress.fraction(), 1 - std::pow(0.9, kFew));
}

TEST(Isometric, DoesNotForceAFlounceApart) {
    const auto piece = test::asPiece(test::flounce(425, 80, 200, 60, 5));
    const Measured result = measured(*piece, solvedBy(Method::Isometric));
    EXPECT_GT(result.quality.outlineCrossings, 0);
    EXPECT_NEAR(*result.quality.symmetricDirichlet, 1, 1e-9);
    EXPECT_LE(result.quality.maxBoundaryLengthError, 1e-11);
    expectImmersed(*piece, result.flat.Q);
}

/// A fan over random corners unrolls exactly, and lies on itself in hundreds of layers. No simple
/// outline is anywhere near: the hundreds of steps of looking for one are saved.
TEST(Isometric, DoesNotLookForAWayOutOfAKnot) {
    constexpr int kCorners = 300;
    std::mt19937 random(5);
    MeshArrays fan{{kCorners, 3}, {kCorners - 2, 3}};
    for (double& coordinate : fan.V.reshaped()) {
        coordinate = std::uniform_real_distribution<double>(0, 100)(random);
    }
    for (int f = 0; f < kCorners - 2; ++f) {
        fan.F.row(f) << 0, f + 1, f + 2;
    }
    const auto piece = test::asPiece(std::move(fan));
    Progress progress;
    const auto flat = flatten(*piece, solvedBy(Method::Isometric), progress);
    ASSERT_TRUE(flat) << sentence(flat.error());
    EXPECT_GT(outlineCrossings(flat->Q, piece->boundary), 10 * kCorners);
    constexpr int kFew = 20;
    EXPECT_LT(progress.fraction(), 1 - std::pow(0.9, kFew));
}

/// Distortions an independent prototype reached, with the margin asked for.
class IsometricDisks : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(IsometricDisks, MeetTheirDistortion) {
    const auto& [name, bound] = GetParam();
    const auto file = test::dataFile(name);
    TOILE_NEEDS_SHARED(file);
    Progress progress;
    const auto garment = loadGarment({file}, {LengthUnit::Metre}, progress);
    ASSERT_TRUE(garment);
    double worst = 0;
    for (const auto& piece : garment->pieces) {
        SCOPED_TRACE(piece->name);
        const Measured result = measured(*piece, solvedBy(Method::Isometric));
        ASSERT_TRUE(result.quality.symmetricDirichlet);
        worst = std::max(worst, *result.quality.symmetricDirichlet);
        EXPECT_LE(result.quality.maxBoundaryLengthError, 1e-9);
        EXPECT_EQ(result.quality.outlineCrossings, 0);
        expectImmersed(*piece, result.flat.Q);
    }
    EXPECT_LE(worst, bound);
}

INSTANTIATE_TEST_SUITE_P(Shared, IsometricDisks,
                         testing::Values(std::pair{"disks/hemisphere.obj", 1.305},
                                         std::pair{"disks/nefertiti.off", 1.031},
                                         std::pair{"disks/patch-30.off", 1.101},
                                         std::pair{"disks/three_peaks.off", 1.69},
                                         std::pair{"disks/maxface.obj", 1.030},
                                         std::pair{"disks/lion-head.off", 4.50},
                                         std::pair{"disks/mannequin-devil.off", 8.2}));
/// What is reached, with a fiftieth more of the excess: no prototype was asked.
INSTANTIATE_TEST_SUITE_P(Samples, IsometricDisks,
                         testing::Values(std::pair{"samples/shapes/cube-h.obj", 1.0764},
                                         std::pair{"samples/bodice.obj", 1.00093},
                                         std::pair{"samples/cap.obj", 1.00218},
                                         std::pair{"samples/trousers.obj", 1.00076},
                                         std::pair{"samples/tshirt.obj", 1.0047}));

/// Mean distance from the reference panels, weighted by area: at most this, and not
/// above any other method that keeps the lengths.
class IsometricGarments : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(IsometricGarments, ComeNearestToTheTruePanels) {
    const auto& [name, bound] = GetParam();
    const auto file = test::sharedFile(std::string("garments/") + name);
    TOILE_NEEDS_SHARED(file);
    Progress progress;
    LoadOptions load;
    load.split = SplitMode::Uv;
    const auto garment = loadGarment({file}, load, progress);
    ASSERT_TRUE(garment);
    const auto meanDistance = [&](Method method) {
        double sum = 0;
        double area = 0;
        for (const auto& result : flattenGarment(*garment, solvedBy(method), progress)) {
            EXPECT_TRUE(result->quality && result->quality->reference);
            EXPECT_LE(result->quality->maxBoundaryLengthError, 1e-9);
            if (method == Method::Isometric) {
                EXPECT_EQ(result->quality->flippedTriangles, 0);
            }
            sum += result->quality->reference->rms * result->quality->area3d;
            area += result->quality->area3d;
        }
        return sum / area;
    };
    const double isometric = meanDistance(Method::Isometric);
    EXPECT_LE(isometric, bound);
    for (const MethodTraits& other : allMethods()) {
        if (other.keepsLengths) {
            EXPECT_LE(isometric, meanDistance(other.method)) << other.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Shared, IsometricGarments,
                         testing::Values(std::pair{"tee_sim.obj", 1.3}, std::pair{"dress.obj", 2.2},
                                         std::pair{"longsleeve.obj", 4.3},
                                         std::pair{"tshirt.obj", 4.6},
                                         std::pair{"polo.obj", 10.2}));

}  // namespace
}  // namespace toile
