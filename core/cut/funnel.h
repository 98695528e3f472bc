// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/cut/path_strip.h"

namespace toile {

/// A strip laid flat, triangle by triangle.
struct FlatStrip {
    /// A crossed side, seen in the direction of travel.
    struct Gate {
        Eigen::Vector2d left, right;
        int leftVertex, rightVertex;
    };

    Eigen::Vector2d from, to;
    std::vector<Gate> gates;  ///< one per exit
};

FlatStrip layFlat(const SurfaceLinks& links, const Strip& strip);

/// Where the shortest way through a flat strip bends.
struct Bend {
    int gate;   ///< a gate with the bend's vertex at one end
    bool left;  ///< which end
    Eigen::Vector2d at;
};

/// Bends of the shortest way from `from` to `to` through all gates, in order [LP84]. Cost: linear
/// as a rule, quadratic in the number of gates at worst.
std::vector<Bend> shortestThroughGates(const FlatStrip& strip);

}  // namespace toile
