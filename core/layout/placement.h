// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

namespace toile {

/// Where a flat piece lies on the sheet, in mm and radians: it is mirrored (x becomes -x) where
/// asked for, turned anti-clockwise about the origin of its own coordinates, then moved.
struct Placement {
    Eigen::Vector2d offset = Eigen::Vector2d::Zero();
    double turn = 0;
    bool mirrored = false;  ///< the fabric's wrong side faces the reader

    Eigen::Vector2d applied(const Eigen::Vector2d& point) const {
        return offset + linear() * point;
    }

    /// The point of the piece that lies at a place of the sheet.
    Eigen::Vector2d undone(const Eigen::Vector2d& place) const {
        return linear().transpose() * (place - offset);  // orthogonal
    }

    Eigen::Matrix2d linear() const {
        const double c = std::cos(turn), s = std::sin(turn), x = mirrored ? -1 : 1;
        return (Eigen::Matrix2d() << x * c, -s, x * s, c).finished();
    }

    bool operator==(const Placement&) const = default;
};

/// What is known of a piece beyond its shape when it is drawn on a sheet.
struct PieceOnSheet {
    std::optional<Placement> placement{};  ///< none: in a row
    /// Direction of the warp in the piece's own coordinates, radians; none where nobody has said.
    std::optional<double> grain{};
    int quantity = 1;           ///< how many are cut
    bool mirroredPair = false;  ///< each of them also mirrored: left and right
    std::string name{};         ///< what it is called; empty: as it is in the garment

    bool operator==(const PieceOnSheet&) const = default;
};

/// mm from the origin: farther away nothing is laid.
inline constexpr double kFarthestOnSheet = 1e9;

}  // namespace toile
