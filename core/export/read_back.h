// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/export/drawing.h"
#include "core/reading/read_drawing.h"

namespace toile {

/// After each export the bytes are read again, by readers that share no code with the writers, and
/// compared with what they were made from, before they take the place of an old file.

/// How far a file may be from what it is made from, mm.
inline constexpr double kReadBackCoordinates = 0.02, kReadBackLengths = 0.05;
/// Of lengths above 50 m, where that is more.
inline constexpr double kReadBackLengthShare = 1e-6;
/// Of a line on a grid, where that is more still: so many times what rounding to it does to the
/// length of a line that turns as this one does, as a rule.
inline constexpr double kReadBackRounding = 4;

/// What was found in a file that is right.
struct ReadBack {
    int pieces = 0, seams = 0;
    double largest = 0;         ///< difference of any coordinate or length, mm
    std::array<int, 2> dots{};  ///< of a picture, of which nothing but the size is read
};

/// What a file says differently. @param subject  the line, piece or part; empty: the file
Error notReadBack(std::string_view subject, const std::string& what);

/// "read back: 13 pieces, largest difference 0.004 mm", or "read back: 2480 x 3508 dots".
std::string readBackSentence(const ReadBack& found);

/// Compares lines with those of a drawing: each line of these layers is there once (by id, else in
/// order), none that is not meant, no point of one farther from the other than
/// kReadBackCoordinates, no closed line and no side of a seam off by more than kReadBackLengths
/// (kReadBackLengthShare of long ones), of key points each stretch.
/// @param layers  that the format carries  @param grid  of its coordinates, where it is as coarse
/// as
///                kReadBackCoordinates, mm  Errors: NotReadBack, with the line and the figure.
/// Cost: linear in the points. Pure.
Result<ReadBack> comparedWithDrawing(const ReadDrawing& read, const Drawing& drawing,
                                     const std::vector<LayerKind>& layers, double grid = 0);

/// The largest distance of the points of either line from the other, both from the same first
/// point in the same direction; of one with key points alone that of its own. mm; infinite where
/// one has no point. Cost: linear where they run alike. Pure.
double distanceBetween(const ReadLine& read, const DrawnPath& path);

}  // namespace toile
