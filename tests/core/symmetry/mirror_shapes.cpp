// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/symmetry/mirror_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/seam/find_seams.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile::test {
namespace {

constexpr double kHeight = 600;
/// The side panels take this angle to either side of the x axis, radians.
constexpr double kSideAngle = 0.4;

/// On the tube, at an angle from +x towards +z and a share of the height.
Eigen::Vector3d onTube(double angle, double share) {
    const double front = std::max(0.0, std::sin(angle));
    const double width = 1 - 0.3 * share;
    return {width * 200 * std::cos(angle), kHeight * share,
            width * (110 * std::sin(angle) + 60 * front * front)};
}

std::shared_ptr<const Piece> panel(const std::string& name, double from, double to, int columns,
                                   int rows, const Motion& motion) {
    MeshArrays mesh = planeGrid(columns, rows, 1);
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        const double angle = from + (to - from) * mesh.V(v, 0) / columns;
        const Eigen::Vector3d p = onTube(angle, mesh.V(v, 1) / rows);
        mesh.V.row(v) = motion ? motion(p) : p;
    }
    return asPiece(std::move(mesh), name);
}

Garment sewn(Pieces pieces) {
    Garment garment;
    garment.pieces = std::move(pieces);
    garment.uncut = garment.pieces;
    garment.seams = findSeams(garment.pieces);
    return garment;
}

}  // namespace

Garment tube4(const Motion& motion, int leftRows) {
    constexpr double kTurn = std::numbers::pi, s = kSideAngle;
    return sewn({panel("front", s, kTurn - s, 10, 12, motion),
                 panel("left", -s, s, 4, leftRows, motion),
                 panel("back", kTurn + s, 2 * kTurn - s, 10, 12, motion),
                 panel("right", kTurn - s, kTurn + s, 4, 12, motion)});
}

Eigen::Vector3d draped(const Eigen::Vector3d& p) {
    return p + 3 * Eigen::Vector3d(std::sin(p.y() / 90 + p.z() / 50), std::sin(p.x() / 70),
                                   std::cos(p.x() / 60 + p.y() / 80));
}

Eigen::Vector3d turned(const Eigen::Vector3d& direction) {
    const Eigen::AngleAxisd turn(1.1, Eigen::Vector3d(2, -1, 3).normalized());
    return turn * direction;
}

Eigen::Vector3d moved(const Eigen::Vector3d& p) {
    return turned(p) + Eigen::Vector3d(120, -40, 700);
}

Garment inOppositeOrder(const Garment& garment) {
    return sewn({garment.pieces.rbegin(), garment.pieces.rend()});
}

Garment garmentOf(const std::string& file) {
    Progress progress;
    auto garment = loadGarment({dataFile(file)}, {}, progress);
    EXPECT_TRUE(garment) << file;
    return garment ? std::move(*garment) : Garment{};
}

}  // namespace toile::test
