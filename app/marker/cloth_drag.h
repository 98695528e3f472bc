// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/layout/snapping.h"
#include "core/marker/cloth_marker.h"

namespace toile::app {

/// Moving and turning a copy by hand, within the limits of its cloth. Positions in mm on the cloth.

/// Turns by the next step the rule allows: 180 degrees if pieces can be reversed, 90 if they can
/// lie freely. Nullopt for one-way cloth.
std::optional<Placement> nextTurn(const Pattern& pattern, const LaidCopy& copy,
                                  const MarkerSettings& settings, bool clockwise);

/// Whether smaller turns are allowed.
bool turnsByDegrees(const MarkerSettings& settings);

/// Turns around the middle by this angle, or the nearest that rule and tolerance allow.
/// @param step  only whole multiples of it; 0: any angle
Placement turnedBy(const Pattern& pattern, const LaidCopy& copy, const MarkerSettings& settings,
                   double angle, double step);

/// Drags a copy. It snaps to corners, edges and middles of other copies and to the cloth's edges,
/// keeping gap and border.
class ClothDrag {
public:
    ClothDrag(const Pattern& pattern, const ClothMarker& marker, const MarkerSettings& settings,
              int copy, const Eigen::Vector2d& pressed);

    /// @param radius  snapping distance; 0: no snapping
    Placement movedTo(const Eigen::Vector2d& at, double radius);
    /// The result of the last move.
    const SnappedMove& snapped() const { return move_; }

private:
    Placement before_;
    Eigen::Vector2d pressed_;
    Eigen::AlignedBox2d box_;
    Points2 corners_;
    SnapTargets targets_;
    SnappedMove move_{};
};

}  // namespace toile::app
