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

/// What a person says of laying a pattern on cloth. Lengths in mm, angles in radians. On the cloth
/// the warp runs along x from 0, and y goes across it from one selvedge at 0 to the other.

/// How copies may be turned, the grain along the warp.
enum class TurnRule {
    HalfTurns,  ///< either way up
    OneWay,     ///< cloth with a nap, or a print with an up
    Free,       ///< cloth without a grain
};

/// The pattern of a printed or woven cloth; 0: none in that direction.
struct ClothRepeat {
    double warp = 0, weft = 0;
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< of one of its tiles on the cloth

    bool operator==(const ClothRepeat&) const = default;
};

/// A part of a hide of its own quality, or a hole in it.
struct HideZone {
    geometry::Polygon outline;
    int grade = 0;  ///< from 1, the best; 0: a hole, where nothing lies
};

/// A leather hide: where no zone is, it is of grade 1.
struct Hide {
    std::string name;
    geometry::Polygon outline;
    std::vector<HideZone> zones{};
};

/// How the pieces of one material are laid. What stands here is all that a marker follows from,
/// beside the pattern.
struct MarkerSettings {
    double width = 0;                        ///< 0: as the fabric says (`Fabric::width`)
    std::optional<Eigen::Vector2d> sheet{};  ///< sheets instead: along the warp, across it
    std::vector<std::shared_ptr<const Hide>> hides{};  ///< or hides, in this order
    double gap = 0;                                    ///< between two copies at least
    double border = 0;  ///< between a copy and all edges of the cloth
    TurnRule turns = TurnRule::HalfTurns;
    double tolerance = 0;   ///< and so much more to both sides
    bool isFolded = false;  ///< lengthwise, the fold at y = 0: pieces on the fold lie along it
    ClothRepeat repeat{};
    std::vector<std::string> matched{};  ///< seams, by name, along which the repeat goes on
    std::map<std::string, int>
        grades{};      ///< the worst that a piece may have, by its name; others: any
    int garments = 1;  ///< how many are cut
    std::uint64_t seed = 1;

    bool operator==(const MarkerSettings&) const = default;
};

/// Which of the copies that are cut of a piece: `number` from 0, over all garments.
struct CopyKey {
    PieceId piece{};
    int number = 0;

    bool operator==(const CopyKey&) const = default;
    bool operator<(const CopyKey& other) const {
        return piece == other.piece ? number < other.number : piece < other.piece;
    }
};

/// A copy that a person has laid: it stays there.
struct KeptCopy {
    CopyKey copy{};
    int sheet = 0;  ///< or hide, from 0
    Placement placement{};

    bool operator==(const KeptCopy&) const = default;
};

}  // namespace toile
