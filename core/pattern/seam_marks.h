// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/placement.h"
#include "core/pattern/label.h"
#include "core/pattern/pattern.h"
#include "core/pattern/piece_grain.h"

namespace toile {

/// Heights of the capitals of a seam's number, mm: readable at arm's length; barely readable.
inline constexpr double kLargestNumber = 6, kSmallestNumber = 0.8;
/// Height of its name.
inline constexpr double kSeamNameHeight = 2.5;

/// Marks for finding a seam's other side: a tick at each end, from the outline into the cloth, and
/// along the edge the seam's number, followed by its name if there is room. Both sides have the
/// same marks. In sheet directions, relative to the placement's offset.
struct SeamMark {
    int number = 0;
    bool second = false;                        ///< the other mark of a piece sewn to itself
    std::array<std::optional<Chord>, 2> ticks;  ///< none if a seam ends there, straight on
    std::optional<LabelPlace> numberPlace{};    ///< its middle; none if it would be illegible
    std::optional<LabelPlace> namePlace{};      ///< only next to a number
    std::string name;
    double angle = 0;  ///< of both texts, radians, never upside down
};

/// A seam's number as written: with a dot if no name follows and it would be another number upside
/// down, "6.".
std::string numberText(const SeamMark& mark);

/// The marks of a piece's seams, sorted by number; free edges have none. A number is as large as
/// fits near its edge, preferably at the middle of the seam; texts do not overlap lines, ticks or
/// other texts.
/// @param obstacles  other lines to keep clear of, as placed
/// Cost: n log n. Pure.
std::vector<SeamMark> seamMarks(const PatternPiece& piece, const Placement& placement,
                                const std::vector<Points2>& obstacles = {});

/// Adds all of a seam's marks to the obstacles of other texts.
void addObstacles(const SeamMark& mark, std::vector<Points2>& obstacles);

/// The direction of the same line for a text that is never upside down.
double readableAngle(double angle);

}  // namespace toile
