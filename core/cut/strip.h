// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/cut/surface_links.h"

namespace toile {

/// The consecutive triangles along a curve: triangle i is left by the side `exits[i]`. The curve
/// starts in the first and ends in the last one.
struct Strip {
    SurfacePoint from;  ///< with weights for the first triangle
    SurfacePoint to;    ///< with weights for the last triangle
    std::vector<int> exits;
};

/// The strip along a polyline. At a vertex it turns to the side with the smaller angle, so that the
/// polyline runs inside the strip or along its rim. Nothing if neighbouring points share no
/// triangle, or if walls on both sides block the way around a vertex.
std::optional<Strip> stripAlong(const SurfaceLinks& links, const std::vector<SurfacePoint>& points);

/// Sides crossed when going around `vertex` from one triangle to another; nothing if a wall blocks
/// the way. @param leftward  anti-clockwise, seen from the right side
std::optional<std::vector<int>> exitsAround(const SurfaceLinks& links, int vertex, int fromFace,
                                            int toFace, bool leftward);

/// Removes steps back and forth across one edge, and triangles at the ends that are not needed
/// because the end point already touches the next one.
void tidy(const SurfaceLinks& links, Strip& strip);

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

/// A bend of the shortest path through a flat strip.
struct Bend {
    int gate;   ///< a gate with the bend's vertex at one end
    bool left;  ///< which end
    Eigen::Vector2d at;
};

/// Bends of the shortest path from `from` to `to` through all gates, in order [LP84]. Cost: usually
/// linear, at worst quadratic in the number of gates.
std::vector<Bend> shortestThroughGates(const FlatStrip& strip);

}  // namespace toile
