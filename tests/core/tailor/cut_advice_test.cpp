// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/cut_advice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/toile/pipeline.h"
#include "tests/core/support/shapes.h"
#include "tests/core/tailor/worn_shapes.h"

namespace toile {
namespace {

constexpr double kPi = std::numbers::pi;

/// A surface of revolution about y, of rings of 48: from the axis down a profile of (radius,
/// height), each stretch of it divided; the first point lies on the axis.
/// @param isClosed  the last point lies on the axis, too
MeshArrays revolved(const std::vector<Eigen::Vector2d>& corners, int perStretch, bool isClosed) {
    constexpr int kAround = 48;
    std::vector<Eigen::Vector2d> profile;
    for (std::size_t c = 1; c < corners.size(); ++c) {
        for (int k = 1; k <= perStretch; ++k) {
            const double t = double(k) / perStretch;
            profile.push_back((1 - t) * corners[c - 1] + t * corners[c]);
        }
    }
    if (isClosed) {
        profile.pop_back();
    }
    const int rings = static_cast<int>(profile.size());
    MeshArrays mesh;
    mesh.V.resize(1 + rings * kAround + (isClosed ? 1 : 0), 3);
    mesh.V.row(0) << 0, corners.front().y(), 0;
    for (int r = 0; r < rings; ++r) {
        for (int k = 0; k < kAround; ++k) {
            const double angle = 2 * kPi * (k + 0.5 * (r % 2)) / kAround;
            mesh.V.row(1 + r * kAround + k) << profile[r].x() * std::cos(angle), profile[r].y(),
                profile[r].x() * std::sin(angle);
        }
    }
    std::vector<std::array<int, 3>> faces;
    const auto at = [](int r, int k) { return 1 + r * kAround + (k + kAround) % kAround; };
    for (int k = 0; k < kAround; ++k) {
        faces.push_back({0, at(0, k + 1), at(0, k)});
        for (int r = 0; r + 1 < rings; ++r) {
            const int shift = r % 2;  // the lower ring is half a step ahead, or behind
            faces.push_back({at(r, k), at(r, k + 1), at(r + 1, k + shift)});
            faces.push_back({at(r, k + 1), at(r + 1, k + 1 + shift), at(r + 1, k + shift)});
            if (shift == 0) {
                faces[faces.size() - 2] = {at(r, k), at(r, k + 1), at(r + 1, k)};
                faces[faces.size() - 1] = {at(r, k + 1), at(r + 1, k + 1), at(r + 1, k)};
            }
        }
        if (isClosed) {
            const int last = static_cast<int>(mesh.V.rows()) - 1;
            faces.push_back({last, at(rings - 1, k), at(rings - 1, k + 1)});
        }
    }
    if (isClosed) {
        mesh.V.bottomRows(1) << 0, corners.back().y(), 0;
    }
    mesh.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        mesh.F.row(static_cast<Eigen::Index>(f)) << faces[f][0], faces[f][1], faces[f][2];
    }
    return mesh;
}

std::shared_ptr<const Piece> formPiece(MeshArrays mesh) {
    auto piece = std::make_shared<Piece>(*test::asPiece(std::move(mesh)));
    piece->sourceVertex.resize(static_cast<std::size_t>(piece->mesh.V.rows()));
    piece->sourceFace.resize(static_cast<std::size_t>(piece->mesh.F.rows()));
    std::iota(piece->sourceVertex.begin(), piece->sourceVertex.end(), 0);
    std::iota(piece->sourceFace.begin(), piece->sourceFace.end(), 0);
    return piece;
}

TEST(CutAdvice, ADartToItsApexUnrollsACone) {
    // 60 degrees off upright: it unrolls to a sector that lacks a part of a turn.
    const double slant = 200, radius = slant * std::sin(kPi / 3);
    const auto cone = formPiece(revolved({{0, slant * std::cos(kPi / 3)}, {radius, 0}}, 16, false));
    const CutAdvice advice = adviseCuts(cone, {}, {});
    ASSERT_FALSE(advice.cuts.empty());
    const AdvisedCut& dart = advice.cuts.front();
    EXPECT_EQ(dart.what.line, TailorLine::Dart);
    EXPECT_NEAR(dart.length, slant, 0.01 * slant);
    EXPECT_NEAR(dart.what.cut.points.back().y(), slant * std::cos(kPi / 3), 1e-9);
    EXPECT_GT(advice.before.mean, 0.02);
    EXPECT_LT(dart.predicted.mean, 1e-3);
    ASSERT_TRUE(dart.intake);
    const double lacks = 2 * kPi * (1 - std::sin(kPi / 3));
    EXPECT_NEAR(dart.intake->angle, lacks, 0.05 * lacks);
    EXPECT_NEAR(dart.intake->width, lacks * slant, 0.05 * lacks * slant);
    EXPECT_EQ(advice.cuts.size(), 1U);
}

TEST(CutAdvice, AHemisphereIsCutToItsPole) {
    const auto half = formPiece(test::sphericalCap(24, 100, kPi / 2));
    const CutAdvice advice = adviseCuts(half, {}, {});
    ASSERT_FALSE(advice.cuts.empty());
    const AdvisedCut& first = advice.cuts.front();
    EXPECT_NEAR(first.length, 50 * kPi, 2);
    const auto pole = std::ranges::min_element(first.what.cut.points, {}, [](const auto& point) {
        return (point - Eigen::Vector3d(0, 100, 0)).norm();
    });
    EXPECT_LT((*pole - Eigen::Vector3d(0, 100, 0)).norm(), 1e-6);
    EXPECT_LT(first.predicted.mean, advice.before.mean / 2);
}

TEST(CutAdvice, ALidIsCutOffAlongItsRim) {
    const auto tin = formPiece(revolved({{0, 150}, {80, 150}, {80, 0}}, 12, false));
    const CutAdvice advice = adviseCuts(tin, {}, {});
    ASSERT_FALSE(advice.cuts.empty());
    const AdvisedCut& rim = advice.cuts.front();
    EXPECT_EQ(rim.what.line, TailorLine::Ridge);
    EXPECT_EQ(rim.what.cut.kind, UserCut::Kind::Loop);
    EXPECT_NEAR(rim.length, 160 * kPi, 2);
    EXPECT_LT(rim.predicted.mean, 1e-6);
    Progress progress;
    const auto solved = solvedStrain(tin, {}, advice, 1, {}, progress);
    ASSERT_TRUE(solved);
    EXPECT_LT(solved->mean, 1e-3);
    EXPECT_EQ(advice.cuts.size(), 1U);
}

TEST(CutAdvice, ASolidIsCoveredByGores) {
    const auto ball = formPiece(revolved({{0, 100}, {100, 100}, {100, -100}, {0, -100}}, 8, true));
    MeshArrays round = ball->mesh;
    round.V.rowwise().normalize();
    round.V *= 100;
    const CutAdvice advice = adviseCuts(formPiece(round), {}, {});
    ASSERT_GT(advice.cuts.size(), 2U);
    EXPECT_EQ(advice.cuts.front().what.line, TailorLine::Centre);
    EXPECT_EQ(advice.cuts.front().what.cut.kind, UserCut::Kind::Loop);
    for (std::size_t k = 1; k < advice.cuts.size(); ++k) {
        EXPECT_LE(advice.cuts[k].predicted.mean, advice.cuts[k - 1].predicted.mean + 1e-9) << k;
    }
    EXPECT_LT(advice.cuts.back().predicted.mean, 0.2 * advice.cuts.front().predicted.mean);
}

TEST(CutAdvice, AClosedFormOfNoSidesIsOpenedFirst) {
    const auto ball = formPiece(revolved({{0, 100}, {100, 100}, {100, -100}, {0, -100}}, 8, true));
    MeshArrays dented = ball->mesh;
    dented.V.rowwise().normalize();
    for (Eigen::Index v = 0; v < dented.V.rows(); ++v) {  // no mirror image of itself
        const Eigen::Vector3d p = dented.V.row(v);
        dented.V.row(v) *= 100 + 40 * p.x() * p.y() * p.z() + 30 * p.x() * p.x() * p.y() +
                           25 * p.y() * p.y() * p.z() + 20 * p.z() * p.z() * p.x();
    }
    const CutAdvice advice = adviseCuts(formPiece(dented), {}, {});
    ASSERT_GT(advice.cuts.size(), 2U);
    EXPECT_LT(advice.cuts.back().predicted.mean, advice.before.mean);
}

TEST(CutAdvice, WhatIsEnoughIsMarked) {
    const auto half = formPiece(test::sphericalCap(24, 100, kPi / 2));
    const CutAdvice some = adviseCuts(half, {}, {.enoughStrain = 0.05});
    const CutAdvice more = adviseCuts(half, {}, {.enoughStrain = 0.02});
    const auto needed = [](const CutAdvice& advice) {
        return std::ranges::count(advice.cuts, true, &AdvisedCut::isNeeded);
    };
    EXPECT_GT(needed(some), 0);
    EXPECT_GT(needed(more), needed(some));
    const auto last = static_cast<std::size_t>(needed(some) - 1);
    EXPECT_LE(some.cuts[last].predicted.mean, 0.05);
    ASSERT_GT(last, 0U);
    EXPECT_GT(some.cuts[last - 1].predicted.mean, 0.05);
    EXPECT_EQ(needed(adviseCuts(half, {}, {.enoughStrain = 1})), 0);
}

TEST(CutAdvice, ForetoldStrainRanksAsSolvedStrainDoes) {
    // A cap in a skirt's side of no seam: prefixes of what is proposed.
    const auto half = formPiece(test::sphericalCap(16, 100, kPi / 2));
    const CutAdvice advice = adviseCuts(half, {}, {});
    ASSERT_GT(advice.cuts.size(), 4U);
    double before = 1;
    for (std::size_t k = 0; k <= 4; ++k) {
        Progress progress;
        const auto solved = solvedStrain(half, {}, advice, k, {}, progress);
        ASSERT_TRUE(solved);
        EXPECT_LT(solved->mean, before) << k;
        before = solved->mean;
        if (k > 0) {
            EXPECT_LT(solved->mean, 2 * advice.cuts[k - 1].predicted.mean);
            EXPECT_GT(solved->mean, advice.cuts[k - 1].predicted.mean / 2);
        }
    }
}

TEST(CutAdvice, TheFlatNeedsNone) {
    EXPECT_TRUE(adviseCuts(formPiece(test::planeGrid(8, 8, 20)), {}, {}).cuts.empty());
    EXPECT_TRUE(adviseCuts(formPiece(test::tube(24, 8)), {}, {}).before.mean < 1e-6);
}

TEST(CutAdvice, CancelledThereIsNone) {
    Progress progress;
    progress.cancel();
    EXPECT_TRUE(adviseCuts(formPiece(test::wornShirt()), {}, {}, progress).cuts.empty());
}

}  // namespace
}  // namespace toile
