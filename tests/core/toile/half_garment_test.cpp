// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "core/garment/piece.h"
#include "core/prepare/file_surface.h"
#include "core/toile/pipeline.h"
#include "tests/core/prepare/scan_shapes.h"
#include "tests/core/support/half_shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using Plane = Eigen::Hyperplane<double, 3>;

const Plane kCentre(Eigen::Vector3d::UnitX(), 0);

Result<Garment> tryTaken(const PolygonSoup& soup, const LoadOptions& options) {
    Progress progress;
    return makeGarment({{{"half.obj", std::make_shared<const PolygonSoup>(soup)}}, options},
                       progress);
}

Garment takenFrom(const PolygonSoup& soup, bool isHalf, SplitMode split = SplitMode::Auto) {
    auto garment = tryTaken(
        soup, {.unit = LengthUnit::Centimetre, .split = split, .preparing = {.isHalf = isHalf}});
    EXPECT_TRUE(garment);
    return garment ? *garment : Garment{};
}

/// All loops of all pieces, mm, ascending.
std::vector<double> allLoops(const Garment& garment) {
    std::vector<double> all;
    for (const auto& piece : garment.pieces) {
        const std::vector<double> loops = loopLengths(*piece);
        all.insert(all.end(), loops.begin(), loops.end());
    }
    std::ranges::sort(all);
    return all;
}

double clothOf(const Garment& garment) {
    double area = 0;
    for (const auto& piece : garment.pieces) {
        area += test::clothArea(piece->mesh);
    }
    return area;
}

std::set<std::string> pieceNames(const Garment& garment) {
    std::set<std::string> names;
    for (const auto& piece : garment.pieces) {
        names.insert(piece->name);
    }
    return names;
}

void expectSameCloth(const Garment& garment, const Garment& known) {
    EXPECT_EQ(pieceNames(garment), pieceNames(known));
    const std::vector<double> loops = allLoops(garment), knownLoops = allLoops(known);
    ASSERT_EQ(loops.size(), knownLoops.size());
    for (std::size_t k = 0; k < loops.size(); ++k) {
        EXPECT_NEAR(loops[k], knownLoops[k], 1e-4 * knownLoops[k]) << k;
    }
    EXPECT_NEAR(clothOf(garment), clothOf(known), 1e-4 * clothOf(known));
}

/// Half a skirt in centimetres with a map of its panel, as it unrolls.
PolygonSoup mappedHalfSkirt() {
    PolygonSoup whole = test::inCentimetres(test::skirt());
    PolygonSoup half = test::halfOf(whole, kCentre);
    for (const Eigen::Vector3d& p : half.positions) {
        half.uvs.emplace_back(test::kSkirtRadius / 10 * std::atan2(p.z(), p.x()), p.y());
    }
    half.cornerUvs = half.corners;
    return half;
}

/// Of our sample, whose neckband ends in the plane: what is sewn there would be one.
PolygonSoup tshirtWithoutNeckband() {
    Progress progress;
    const auto soup = readSoup(test::dataFile("samples/tshirt.obj"), progress);
    EXPECT_TRUE(soup);
    std::vector<int> kept;
    for (int face = 0; soup && face < soup->faceCount(); ++face) {
        const auto object =
            static_cast<std::size_t>(soup->faceObject[static_cast<std::size_t>(face)]);
        if (soup->objects[object] != "neckband") {
            kept.push_back(face);
        }
    }
    return soup ? withFaces(*soup, kept) : PolygonSoup{};
}

int readingNotes(const Garment& garment, ErrorCode code) {
    return static_cast<int>(
        std::ranges::count(garment.files.front()->problems, code, &Error::code));
}

TEST(HalfGarment, CompletedIsTheWhole) {
    const PolygonSoup whole = tshirtWithoutNeckband();
    const PolygonSoup half = test::halfOf(whole, kCentre);
    expectSameCloth(takenFrom(half, true), takenFrom(whole, false));
    const Garment found = takenFrom(half, false);
    ASSERT_TRUE(found.files.front()->reading.half);
    EXPECT_FALSE(found.files.front()->reading.half->isCompleted);
    EXPECT_EQ(readingNotes(found, ErrorCode::ReadAs), 0);
    const Garment completed = takenFrom(half, true);
    EXPECT_TRUE(completed.files.front()->reading.half->isCompleted);
    EXPECT_EQ(readingNotes(completed, ErrorCode::ReadAs), 1);
}

TEST(HalfGarment, MayStandAskew) {
    const PolygonSoup whole = test::inCentimetres(test::skirt());
    for (const double turn : {0.3, 1.9}) {
        const Plane plane(Eigen::Vector3d(std::cos(turn), 0, std::sin(turn)),
                          Eigen::Vector3d(1.5, 0, 0.5));
        const Garment completed = takenFrom(test::halfOf(whole, plane), true);
        ASSERT_EQ(completed.pieces.size(), 1U);
        const std::vector<double> loops = loopLengths(*completed.pieces.front());
        ASSERT_EQ(loops.size(), 2U);
        EXPECT_NEAR(loops[0], loops[1], 1e-6);
    }
}

TEST(HalfGarment, ItsMapGetsAMirrorImageBesideIt) {
    const Garment completed = takenFrom(mappedHalfSkirt(), true, SplitMode::Uv);
    ASSERT_EQ(completed.pieces.size(), 2U);
    const auto& [half, image] = std::tie(*completed.pieces[0], *completed.pieces[1]);
    ASSERT_FALSE(half.defect || image.defect);
    EXPECT_NEAR(loopLengths(half)[0], loopLengths(image)[0], 1e-6);
    ASSERT_TRUE(half.reference && image.reference);
    const auto turnOf = [](const Piece& piece) {
        const Points2& panel = *piece.reference;
        const auto corner = [&](int k) -> Eigen::RowVector2d {
            return panel.row(piece.mesh.F(0, k));
        };
        const Eigen::RowVector2d a = corner(1) - corner(0), b = corner(2) - corner(0);
        return a.x() * b.y() - a.y() * b.x();
    };
    // An image runs the other way around in its map, and in space: so both lie face up, or face
    // down.
    EXPECT_EQ(turnOf(half) > 0, turnOf(image) > 0);
    const double right = half.reference->col(0).maxCoeff();
    EXPECT_GT(image.reference->col(0).minCoeff(), right);
    // By what hangs together they are one.
    EXPECT_EQ(takenFrom(mappedHalfSkirt(), true, SplitMode::Components).pieces.size(), 1U);
}

TEST(HalfGarment, ItsNewSeamsHaveNames) {
    const Garment completed = takenFrom(mappedHalfSkirt(), true, SplitMode::Uv);
    std::set<std::string> names;
    for (const Seam& seam : completed.seams.seams) {
        if (seam.kind == SeamKind::Seam) {
            names.insert(seam.name);
            EXPECT_NEAR(seam.length3d[0], test::kSkirtHeight, 1e-6);
        }
    }
    EXPECT_EQ(names, (std::set<std::string>{"mirror seam 1", "mirror seam 2"}));
}

TEST(HalfGarment, AWholeOneIsNotDoubled) {
    const PolygonSoup whole = test::inCentimetres(test::skirt());
    const Garment garment = takenFrom(whole, true);
    EXPECT_FALSE(garment.files.front()->reading.half);
    EXPECT_EQ(readingNotes(garment, ErrorCode::CannotReadAs), 1);
    expectSameCloth(garment, takenFrom(whole, false));
    EXPECT_FALSE(tryTaken(whole, {.preparing = {.isHalf = true}, .strict = true}));
}

TEST(HalfGarment, WhatWasAskedForIsNoChangeToBeRefused) {
    EXPECT_TRUE(
        tryTaken(mappedHalfSkirt(),
                 {.unit = LengthUnit::Centimetre, .preparing = {.isHalf = true}, .strict = true}));
}

TEST(HalfGarment, IsMadeOfAScanThatWasPrepared) {
    const PolygonSoup half = mappedHalfSkirt();
    const auto garment = tryTaken(
        half, {.unit = LengthUnit::Centimetre,
               .preparing = {.as = FileKind::Scan, .scan = {true, 0, 0, 20}, .isHalf = true}});
    ASSERT_TRUE(garment);
    EXPECT_TRUE(garment->files.front()->reading.half);
    EXPECT_EQ(garment->pieces.size(), 1U);
}

}  // namespace
}  // namespace toile
