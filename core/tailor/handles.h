// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/cut/surface_point.h"
#include "core/cut/user_cuts.h"
#include "core/garment/piece.h"

namespace toile {

/// Handles of a cut, in order: its ends, and points that it shares with other cuts, bit by bit. A
/// path with only its ends also gets its middle; a loop with fewer than two handles gets four,
/// evenly spaced. Indices into its points.
/// Cost: O(n log n) in the points of all cuts. Pure.
std::vector<int> handlesOf(const std::vector<UserCut>& cuts, std::size_t cut);

/// Moves cuts by their handles over one piece. Immutable.
class CutShaper {
public:
    /// Cost: linear. @param piece  mm; has faces; kept
    explicit CutShaper(std::shared_ptr<const Piece> piece);

    const std::shared_ptr<const Piece>& piece() const { return piece_; }
    /// Whether the point is within 1 mm of a rim.
    bool isOnRim(const Eigen::Vector3d& point) const;
    /// Nearest point of any rim; the point itself if the piece has none. Cost: its edges.
    Eigen::Vector3d onRim(const Eigen::Vector3d& point) const;

    /// Places along the whole rim that a point is on, at most `spacing` mm apart, unordered; empty
    /// if it is on none.
    std::vector<Eigen::Vector3d> rimThrough(const Eigen::Vector3d& point, double spacing) const;

    /// Moves a point of a cut, preferably a handle, to the place on the surface nearest to `to`.
    /// The line follows up to the next handles, less with distance by arc length, and stays on the
    /// surface; other cuts through that point follow. An end on a rim stays on rims. A line that
    /// was straight in a plane between its handles can be restored by moving it back.
    /// Cost: a nearest-point query for each moved point.
    void move(std::vector<UserCut>& cuts, std::size_t cut, int point,
              const Eigen::Vector3d& to) const;

    /// Points along a cut on the surface, at most `spacing` mm apart. A closed cut repeats its
    /// first.
    std::vector<Eigen::Vector3d> drawn(const UserCut& cut, double spacing) const;

private:
    struct RimPlace {
        int index = -1;  ///< into `rim_`
        Eigen::Vector3d point{0, 0, 0};
        double distance = 0;
    };
    RimPlace nearestRim(const Eigen::Vector3d& point) const;
    Eigen::Vector3d onSurface(const Eigen::Vector3d& point) const;
    void moveOne(UserCut& cut, int point, const std::vector<int>& handles,
                 const Eigen::Vector3d& to) const;

    std::shared_ptr<const Piece> piece_;
    NearestSurface nearest_;
    std::vector<int> rim_;     ///< edges
    std::vector<int> rimSet_;  ///< per edge of `rim_`: index of its rim
};

/// Length of the polyline; for a loop including the way back to the first point. mm.
double lengthAlong(const UserCut& cut);

}  // namespace toile
