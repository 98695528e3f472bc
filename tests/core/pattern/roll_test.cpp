// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "core/pattern/walk.h"
#include "tests/core/pattern/notched_garments.h"
#include "tests/core/seam/seam_shapes.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

SeamRoll rollOf(const test::Notched& of, int seam) {
    DrawnLoops loops(of.results);
    return {of.garment.seams.seams[static_cast<std::size_t>(seam)], loops};
}

Eigen::Vector2d touchingPoint(const SeamRoll& roll, const RolledPlace& rolled) {
    return roll.left().pointAt(rolled.at.left).transpose();
}

/// The rolled piece is the mirror image of the other in a line through the point where they touch;
/// vertices of one number mirror each other.
void expectReflection(const test::Notched& pair, const SeamRoll& roll, double share, int vertices) {
    const RolledPlace rolled = roll.at(share);
    const auto placeOf = [&](const SeamSide& side, int k) -> Eigen::Vector2d {
        return pair.results[static_cast<std::size_t>(side.piece)]->flat->Q.row(k).transpose();
    };
    const Seam& seam = roll.seam();
    const auto imageOf = [&](int k) { return rolled.motion.applied(placeOf(seam.right, k)); };
    const Eigen::Vector2d touching = touchingPoint(roll, rolled);
    int farthest = 0;
    for (int k = 0; k < vertices; ++k) {
        const auto apart = [&](int v) { return (imageOf(v) - placeOf(seam.left, v)).norm(); };
        farthest = apart(k) > apart(farthest) ? k : farthest;
    }
    const Eigen::Vector2d normal = (imageOf(farthest) - placeOf(seam.left, farthest)).normalized();
    for (int k = 0; k < vertices; ++k) {
        const Eigen::Vector2d from = placeOf(seam.left, k) - touching;
        const Eigen::Vector2d to = imageOf(k) - touching;
        EXPECT_NEAR((from - 2 * from.dot(normal) * normal - to).norm(), 0, 1e-6) << share;
    }
}

TEST(Roll, OfMirrorImagesIsAReflectionInTheTangent) {
    // Straight edges; convex arcs, of two cones that meet at their wide rims.
    MeshArrays sheet = test::rectangle(0, 0, 120, 400, 3, 20);
    MeshArrays cone = test::coneSector(60, 6, 120, 300, 1.2, 0.5);
    for (MeshArrays* mesh : {&sheet, &cone}) {
        const bool isCone = mesh == &cone;
        MeshArrays twin = test::woundAgainst(*mesh);
        const int axis = isCone ? 1 : 0;
        const double wall = isCone ? mesh->V.col(1).minCoeff() : mesh->V.col(0).maxCoeff();
        twin.V.col(axis) = 2 * wall - twin.V.col(axis).array();
        const test::Notched pair = test::notched(test::plane({*mesh, twin}));
        ASSERT_FALSE(pair.garment.seams.seams[0].matches.empty());
        const SeamRoll roll = rollOf(pair, 0);
        for (const double share : {0.0, 0.001, 0.2, 0.5, 0.77, 1.0}) {
            expectReflection(pair, roll, share, static_cast<int>(mesh->V.rows()));
            EXPECT_NEAR(roll.at(share).walked.error(), 0, 1e-6);
        }
        EXPECT_NEAR(roll.at(1).walked.left, roll.seam().length3d[0], 1e-6);
    }
}

// A cap and the hole that it was cut from: rolled nowhere, as their lines are one.
TEST(Roll, OfLinesThatAreOneInThePlaneDoesNotMove) {
    const MeshArrays whole = test::rectangle(0, 0, 400, 400, 40, 40);
    const auto isLeft = [](const Eigen::RowVector3d& p) {
        return p.x() < 200 + 60 * std::sin(p.y() / 80);
    };
    const test::Notched pair = test::notched(
        test::plane({test::part(whole, isLeft),
                     test::part(whole, [&](const Eigen::RowVector3d& p) { return !isLeft(p); })}));
    const SeamRoll roll = rollOf(pair, 0);
    const Placement first = roll.at(0).motion;
    for (int k = 1; k <= 200; ++k) {
        const Placement now = roll.at(k / 200.0).motion;
        EXPECT_NEAR(wrappedAngle(now.turn - first.turn), 0, 1e-6) << k;
        EXPECT_NEAR((now.offset - first.offset).norm(), 0, 1e-4) << k;
    }
}

class RollOf : public testing::TestWithParam<const char*> {};

TEST_P(RollOf, TouchesAtEveryShareAndLaysNotchesOnEachOther) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam()));
    LineSettings fair;
    fair.fairing = Fairing{};
    for (const LineSettings& lines : {LineSettings{}, fair}) {
        const test::Notched all = test::notched(test::garmentFrom(GetParam()), lines);
        const auto notches = all.found();
        for (const SeamWalk& walk : walkSeams(all.garment, all.results, all.segments, notches)) {
            const SeamRoll roll = rollOf(all, walk.seam);
            Placement before = roll.at(0).motion;
            for (int k = 0; k <= 20; ++k) {
                const RolledPlace rolled = roll.at(k / 20.0);
                EXPECT_FALSE(rolled.motion.mirrored);
                EXPECT_NEAR((rolled.motion.applied(roll.right().pointAt(rolled.at.right)) -
                             touchingPoint(roll, rolled))
                                .norm(),
                            0, 1e-9);
                before = roll.at(k / 20.0 - 1e-7).motion;
                EXPECT_NEAR(wrappedAngle(rolled.motion.turn - before.turn), 0, 1e-3);
            }
            WalkedLengths sum;
            for (const WalkStation& station : walk.stations) {
                sum.left += station.left;
                sum.right += station.right;
                sum.ease += station.ease;
                const WalkedLengths walked = roll.at(shareOf(roll.seam(), station.at)).walked;
                EXPECT_NEAR(walked.left, sum.left, 1e-6);
                EXPECT_NEAR(walked.right, sum.right, 1e-6);
                EXPECT_NEAR(walked.ease, sum.ease, 1e-6);
            }
            for (const Notch& notch : notches[static_cast<std::size_t>(walk.seam)]) {
                const RolledPlace rolled = roll.at(notch.share);
                const Eigen::Vector2d left = roll.left().flat.pointAt(notch.flat.left);
                const Eigen::Vector2d right = roll.right().flat.pointAt(notch.flat.right);
                EXPECT_NEAR((rolled.motion.applied(right) - left).norm(), 0, 1e-6);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Garments, RollOf,
                         testing::Values("samples/tshirt.obj", "samples/bodice.obj"));
INSTANTIATE_TEST_SUITE_P(Slow, RollOf,
                         testing::Values("samples/cap.obj", "samples/skirt.obj",
                                         "garments/tee_sim.obj"));

}  // namespace
}  // namespace toile
