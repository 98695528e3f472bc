// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/id.h"
#include "core/geometry/placement.h"
#include "core/geometry/polygon.h"

namespace toile {

/// User settings for laying a pattern on cloth. Lengths in mm, angles in radians. On the cloth the
/// warp runs along x from 0, and y goes across from one selvedge at 0 to the other.

/// Allowed turns of copies, relative to the grain along the warp.
enum class TurnRule {
    HalfTurns,  ///< 0 or 180 degrees
    OneWay,     ///< for cloth with a nap or a directional print
    Free,       ///< for cloth without a grain
};

/// The repeat of a printed or woven cloth; 0: none in that direction.
struct ClothRepeat {
    double warp = 0, weft = 0;
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< of a tile on the cloth

    bool operator==(const ClothRepeat&) const = default;
};

/// A region of a hide with its own grade, or a hole in it.
struct HideZone {
    geometry::Polygon outline;
    int grade = 0;  ///< from 1, the best; 0: a hole
};

/// A leather hide: grade 1 outside all zones.
struct Hide {
    std::string name;
    geometry::Polygon outline;
    std::vector<HideZone> zones{};
};

/// How the pieces of one material are laid. A marker depends only on these settings and the
/// pattern.
struct MarkerSettings {
    double width = 0;                        ///< 0: that of the fabric (`Fabric::width`)
    std::optional<Eigen::Vector2d> sheet{};  ///< sheets instead: along the warp, across it
    std::vector<std::shared_ptr<const Hide>> hides{};  ///< or hides, in this order
    double gap = 0;                                    ///< smallest distance between two copies
    double border = 0;  ///< between a copy and all edges of the cloth
    TurnRule turns = TurnRule::HalfTurns;
    double tolerance = 0;   ///< additional turn to either side
    bool isFolded = false;  ///< lengthwise, the fold at y = 0: pieces on the fold touch it
    ClothRepeat repeat{};
    std::vector<std::string> matched{};   ///< seams, by name, across which the repeat is matched
    std::map<std::string, int> grades{};  ///< worst allowed grade by piece name; others: any
    int garments = 1;                     ///< number of garments to cut
    std::uint64_t seed = 1;

    bool operator==(const MarkerSettings&) const = default;
};

/// Identifies a copy of a piece: `number` from 0, over all garments.
struct CopyKey {
    PieceId piece{};
    int number = 0;

    bool operator==(const CopyKey&) const = default;
    bool operator<(const CopyKey& other) const {
        return piece == other.piece ? number < other.number : piece < other.piece;
    }
};

/// A copy placed by the user: it stays there.
struct KeptCopy {
    CopyKey copy{};
    int sheet = 0;  ///< sheet or hide, from 0
    Placement placement{};

    bool operator==(const KeptCopy&) const = default;
};

/// Settings and manual placements for the pieces of one material.
struct MarkerPlan {
    MarkerSettings settings{};
    std::vector<KeptCopy> kept{};  ///< by copy, each once; includes pieces that no longer exist

    bool operator==(const MarkerPlan&) const = default;
};

/// By material; the garment's own fabric has an empty name.
using MarkerPlans = std::map<std::string, MarkerPlan>;

}  // namespace toile
