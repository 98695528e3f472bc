// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "seam_line.h"

namespace toile::samples {

/// The closed outline of one piece, anti-clockwise in its flat layout: each point with its place
/// in the layout and in space. Built side by side; each side starts where the last one ended.
class Outline {
public:
    enum class Direction { Forward, Reversed };
    enum class Fold { No, Yes };

    /// Adds a seam whose flat curve runs over the seam's own parameter.
    /// `Fold::Yes` marks the line on which a half piece is mirrored (space x = 0).
    void add(const SeamLine& seam, const FlatCurve& flat, Direction direction = Direction::Forward,
             Fold fold = Fold::No);

    /// Adds a seam whose flat curve runs over the fraction of the seam's length.
    void addByLength(const SeamLine& seam, const FlatCurve& flat,
                     Direction direction = Direction::Forward, Fold fold = Fold::No);

    const std::vector<Vec2>& flat() const { return flat_; }

    const std::vector<Vec3>& space() const { return space_; }

    const std::vector<bool>& onFold() const { return onFold_; }

    /// Joins the end to the start. Throws std::logic_error where two sides do not meet.
    void close();

private:
    void append(Vec2 flat, Vec3 space, bool firstOfSide, bool onFold);

    std::vector<Vec2> flat_;
    std::vector<Vec3> space_;
    std::vector<bool> onFold_;
};

}  // namespace toile::samples
