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

/// How one outline is to be drawn: beside the exact outline all that its line follows from.
/// Places are arc lengths in 3D along the outline, mm.
struct OutlinePlan {
    struct Stretch {
        double from = 0, to = 0;
        double tolerance = 0;   ///< mm
        bool straight = false;  ///< as one straight line

        bool operator==(const Stretch&) const = default;
    };
    struct Corner {
        double at = 0;
        double turn = 0;      ///< that the line is to have there, radians
        bool isFree = false;  ///< the line may turn otherwise: wrinkles have changed the turn

        bool operator==(const Corner&) const = default;
    };

    /// Its legs become straight lines, and its mouth as wide as the intake.
    using Dart = TypedDart;

    /// One per segment, in order; they cover the outline. None: the line is not to be made fair.
    std::vector<Stretch> stretches;
    std::vector<Corner> corners;  ///< ascending
    double smoothing = 0;         ///< mm
    double stated =
        0;  ///< of a wrinkled garment the usual tolerance, mm: to stray further is noted
    std::vector<Dart> darts{};  ///< by `from`; those that a person has typed
    /// Of a piece that is to be a mirror image: then stretches, corners and darts are the leading
    /// one's.
    std::optional<MirroredOutline> mirrored{};

    bool operator==(const OutlinePlan&) const = default;
};

/// Where wrinkles make the outlines rough: instead of the usual tolerance, mm, about the height of
/// a wrinkle; and what the smoothing length is multiplied by. Any other tolerance is kept.
inline constexpr double kWrinkledTolerance = 8, kWrinkledSmoothing = 1.2;

/// @param turnChanges  per turn point (`truedTurns`)
/// @param isWrinkled   the garment (`roughness`): then also corners that are neither trued nor set
///                     by hand may turn by another angle
OutlinePlan planOutline(const OutlineSegments& segments, const LineSettings& settings,
                        const std::vector<double>& turnChanges, bool isWrinkled = false);

/// The fair line of an outline: near the exact one, of the same length between any two vertices,
/// curved as evenly as that allows (fair_line.h). What is to be straight is made straight before,
/// and darts that are typed are opened (`reshapedOutline`), whatever the tolerance. Where the piece
/// is a narrow band the tolerance is a quarter of its width. Where the line, or the polygon of the
/// outline's vertices on it, would cross itself more often than the exact outline, the tolerance is
/// reduced around the crossings until it does not (`FlatLine::hasYielded`).
/// @param reference  the exact outline
/// Errors: those of `reshapedOutline`; LineNotDrawn where the line crosses itself however near it
/// stays; Cancelled.
/// Cost: n log n in vertices and steps, some milliseconds a metre. Pure.
Result<FlatLine> fairOutline(const OutlineReference& reference, const OutlinePlan& plan,
                             const Progress& progress);

/// Where the vertices of the outline lie on its line, #boundary x 2.
Points2 verticesOn(const FlatLine& line, const Piece& piece);

}  // namespace toile
