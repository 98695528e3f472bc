// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/formats/drawing/drawing.h"
#include "core/mesh/mesh_arrays.h"
#include "core/pattern/line_settings.h"

namespace toile {

/// A line as read, mm, y up, at its position in the drawing.
struct ReadLine {
    LayerKind layer = LayerKind::Cut;
    std::string id{};  ///< from the drawing; empty if the format does not name lines
    Points2 points = Points2(0, 2);
    bool closed = false;
    /// `points` are only some points on the line; lengths are measured between these.
    bool hasKeyPoints = false;
    int stretches = 1;  ///< with key points: stretches between turn points
};

struct ReadDrawing {
    std::vector<ReadLine> lines{};
    int pieces = 0;  ///< counted by blocks, groups or outlines, depending on the format
};

/// After each export the files are read by readers that share no code with the writers, and
/// compared with their source, before they replace an old file.

/// Maximum deviation of a file from its source, mm.
inline constexpr double kReadBackCoordinates = 0.02, kReadBackLengths = 0.05;
/// Relative tolerance of lengths, if it is larger: above 50 m.
inline constexpr double kReadBackLengthShare = 1e-6;
/// Tolerance of a line on a grid, if it is larger still: this multiple of the standard deviation of
/// the line's length when its points are rounded to the grid.
inline constexpr double kReadBackRounding = 4;

/// The figures of a file without errors.
struct ReadBack {
    int pieces = 0, seams = 0;
    double largest = 0;         ///< difference of any coordinate or length, mm
    std::array<int, 2> dots{};  ///< of a picture, of which only the size is read
};

/// A difference found in a file. @param subject  the line, piece or part; empty: the file
Error notReadBack(std::string_view subject, const std::string& what);

/// "read back: 13 pieces, largest difference 0.004 mm", or "read back: 2480 x 3508 dots".
std::string readBackSentence(const ReadBack& found);

/// Compares lines with those of a drawing. Each line of these layers is there once (by id, else in
/// order), and there are no others. No point is farther from the other line than
/// kReadBackCoordinates. No closed line and no side of a seam is off by more than kReadBackLengths
/// (kReadBackLengthShare of long ones); for key points this applies to each stretch.
/// @param layers  layers of the format
/// @param grid  of its coordinates if it is as coarse as kReadBackCoordinates, mm
/// Errors: NotReadBack, with the line and the figure.
/// Cost: linear in the points. Pure.
Result<ReadBack> comparedWithDrawing(const ReadDrawing& read, const Drawing& drawing,
                                     const std::vector<LayerKind>& layers, double grid = 0);

/// The largest distance of the points of either line from the other, both from the same first point
/// in the same direction; for a line of key points only, that of its own points. mm; infinite if
/// either has no point. Cost: linear if they run alike. Pure.
double distanceBetween(const ReadLine& read, const DrawnPath& path);

}  // namespace toile
