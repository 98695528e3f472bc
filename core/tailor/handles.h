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

/// The points by which a cut is taken hold of, in order: its ends, and where it shares a point, to
/// the last bit, with other cuts. A path that has none but its ends has its middle, too; a loop
/// with fewer than two has four, spread evenly. Indices into its points.
/// Cost: O(n log n) in the points of all cuts. Pure.
std::vector<int> handlesOf(const std::vector<UserCut>& cuts, std::size_t cut);

/// Moves cuts by their handles over one piece. Immutable.
class CutShaper {
public:
    /// Cost: linear. @param piece  mm; has faces; kept
    explicit CutShaper(std::shared_ptr<const Piece> piece);

    const std::shared_ptr<const Piece>& piece() const { return piece_; }
    /// Within 1 mm.
    bool isOnRim(const Eigen::Vector3d& point) const;
    /// Nearest point of any rim; the point itself where the piece has none. Cost: its edges.
    Eigen::Vector3d onRim(const Eigen::Vector3d& point) const;

    /// Places along the whole rim that a point lies on, `spacing` mm apart at most, in no order;
    /// empty where it lies on none.
    std::vector<Eigen::Vector3d> rimThrough(const Eigen::Vector3d& point, double spacing) const;

    /// Moves a point of a cut, which is best a handle, to the place on the surface nearest to `to`.
    /// The line goes along up to the next handles, less the farther, by arc length, and stays on
    /// the surface; the other cuts through that point follow. An end on a rim stays on rims. A line
    /// that was straight between its handles in a plane can be moved back as it was.
    /// Cost: a question to the surface for each point moved.
    void move(std::vector<UserCut>& cuts, std::size_t cut, int point,
              const Eigen::Vector3d& to) const;

    /// Points along a cut on the surface, `spacing` mm apart at most. One that goes round repeats
    /// its first.
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
    std::vector<int> rimSet_;  ///< per edge of `rim_`: which rim it is of
};

/// Along its points; a loop with the way back to the first. mm.
double lengthAlong(const UserCut& cut);

}  // namespace toile
