// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/placement.h"
#include "core/pattern/grain_line.h"
#include "core/pattern/label.h"
#include "core/pattern/pattern.h"

namespace toile {

/// Heights of the capitals of a seam's number, mm: readable at arm's length, and barely.
inline constexpr double kLargestNumber = 6, kSmallestNumber = 0.8;
/// Of its name.
inline constexpr double kSeamNameHeight = 2.5;

/// What a sewer needs to find a seam's other side: a tick at both ends, from the outline into the
/// cloth, and along the edge the seam's number, and after it its name where there is room. Both
/// sides carry the same. In sheet directions, about the placement's offset.
struct SeamMark {
    int number = 0;
    bool second = false;                        ///< a piece sewn to itself has two with one number
    std::array<std::optional<Chord>, 2> ticks;  ///< none where the seam before ends, straight on
    std::optional<LabelPlace> numberPlace{};    ///< its middle; none where it could not be read
    std::optional<LabelPlace> namePlace{};      ///< only beside a number
    std::string name;
    double angle = 0;  ///< of both texts, radians, never upside down
};

/// A seam's number as it is written: with a dot where no name follows and it would be another
/// number upside down, "6.".
std::string numberText(const SeamMark& mark);

/// The marks of a piece's seams, by number; free edges have none. A number is as large as fits near
/// its edge, at the middle of the seam or else beside it; texts meet neither lines, ticks nor each
/// other.
/// @param obstacles  other lines that texts must keep off, as they lie
/// Cost: n log n. Pure.
std::vector<SeamMark> seamMarks(const PatternPiece& piece, const Placement& placement,
                                const std::vector<Points2>& obstacles = {});

/// Adds all of a seam's marks to what other texts keep off.
void addObstacles(const SeamMark& mark, std::vector<Points2>& obstacles);

/// The same line for a text, which is never upside down.
double readableAngle(double angle);

}  // namespace toile
