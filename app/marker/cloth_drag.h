// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/layout/snapping.h"
#include "core/marker/cloth_marker.h"

namespace toile::app {

/// Moving and turning a copy by hand, within what its cloth allows. Places in mm of the cloth.

/// Turned by the next step that the rule allows: half a turn where pieces lie either way up, a
/// quarter where they lie freely. None where they lie one way.
std::optional<Placement> nextTurn(const Pattern& pattern, const LaidCopy& copy,
                                  const MarkerSettings& settings, bool clockwise);

/// Whether it may be turned by less than that.
bool turnsByDegrees(const MarkerSettings& settings);

/// Turned about its middle by this angle, or as near to it as the rule and its tolerance allow.
/// @param step  whole multiples of it alone; 0: any
Placement turnedBy(const Pattern& pattern, const LaidCopy& copy, const MarkerSettings& settings,
                   double angle, double step);

/// One copy on its way: it snaps to corners, edges and middles of the others and to the edges of
/// the cloth, with the gap and the border that are asked for.
class ClothDrag {
public:
    ClothDrag(const Pattern& pattern, const ClothMarker& marker, const MarkerSettings& settings,
              int copy, const Eigen::Vector2d& pressed);

    /// @param radius  how near is near enough to snap; 0: nothing does
    Placement movedTo(const Eigen::Vector2d& at, double radius);
    /// The last one.
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
