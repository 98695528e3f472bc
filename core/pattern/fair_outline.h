// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/garment/piece.h"
#include "core/pattern/dart_places.h"
#include "core/pattern/mirrored_lines.h"
#include "core/pattern/outline_reference.h"
#include "core/pattern/segments.h"

namespace toile {

/// How to draw one outline: all inputs of its line except for the exact outline.
/// Places are arc lengths in 3D along the outline, mm.
struct OutlinePlan {
    struct Stretch {
        double from = 0, to = 0;
        double tolerance = 0;   ///< mm
        bool straight = false;  ///< drawn as a straight line

        bool operator==(const Stretch&) const = default;
    };
    struct Corner {
        double at = 0;
        double turn = 0;      ///< of the line there, radians
        bool isFree = false;  ///< any turn is allowed, as wrinkles have changed it

        bool operator==(const Corner&) const = default;
    };

    /// Its legs are drawn straight, and its mouth as wide as the intake.
    using Dart = TypedDart;

    /// One per segment, in order; they cover the outline. Empty: the line is not made fair.
    std::vector<Stretch> stretches;
    std::vector<Corner> corners;  ///< ascending
    double smoothing = 0;         ///< mm
    double stated = 0;          ///< if wrinkled: default tolerance, mm; larger deviations are noted
    std::vector<Dart> darts{};  ///< set by the user, sorted by `from`
    /// Set if the piece is drawn as a mirror image; stretches, corners and darts are then those of
    /// the leading piece.
    std::optional<MirroredOutline> mirrored{};

    bool operator==(const OutlinePlan&) const = default;
};

/// For outlines roughened by wrinkles: replaces the default tolerance, mm, by about the height of a
/// wrinkle, and multiplies the smoothing length. Custom tolerances disable both.
inline constexpr double kWrinkledTolerance = 8, kWrinkledSmoothing = 1.2;

/// @param turnChanges  per turn point (`truedTurns`)
/// @param isWrinkled   the garment (`roughness`): then also corners that are neither trued nor set
///                     by hand may turn by another angle
OutlinePlan planOutline(const OutlineSegments& segments, const LineSettings& settings,
                        const std::vector<double>& turnChanges, bool isWrinkled = false);

/// The fair line of an outline: near the exact one, of the same length between any two vertices,
/// and as evenly curved as possible (fair_line.h). Before, straight segments are made straight and
/// the user's darts are opened (`reshapedOutline`), whatever the tolerance. In narrow bands the
/// tolerance is a quarter of the width. If the line, or the polygon of the outline's vertices on
/// it, crosses itself more often than the exact outline, the tolerance around the crossings is
/// reduced until it does not (`FlatLine::hasYielded`).
/// @param reference  the exact outline
/// Errors: those of `reshapedOutline`; LineNotDrawn if the line still crosses itself after the last
/// reduction; Cancelled.
/// Cost: n log n in vertices and steps, some milliseconds a metre. Pure.
Result<FlatLine> fairOutline(const OutlineReference& reference, const OutlinePlan& plan,
                             const Progress& progress);

/// Positions of the outline's vertices on its line, #boundary x 2.
Points2 verticesOn(const FlatLine& line, const Piece& piece);

}  // namespace toile
