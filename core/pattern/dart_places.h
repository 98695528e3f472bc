// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/cut/user_cuts.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"

namespace toile {

/// A dart becomes part of a seam if a cut continues from its tip, and is a dart again without it.

/// The cut that continues a dart as a seam: a path from its tip in the flat piece, straight along
/// the line from the middle of its mouth through its tip, to the outline. Points are in the pieces'
/// coordinates, mm; name and id are empty. Nothing if the seam is no dart, if its piece is not
/// flat, or if the path meets a hole first.
/// @param results  one per piece  @param seam  index into the graph
/// Cost: linear in the rims of the piece. Pure.
std::optional<UserCut> cutBeyondDart(const Garment& garment, const PieceResults& results, int seam);

/// The path that starts at the tip of a dart that the seam is part of; without it the dart is
/// restored. A tip is a cut's end inside the piece that was cut, not on its rim.
/// @param seam  index into the graph
/// Cost: a tree of boxes of that piece if several cuts were made in it. Pure.
std::optional<CutId> cutBeyondTip(const Garment& garment, int seam);

/// Position of a dart on the outline of its piece. Arc lengths in 3D, mm: `from` at the mouth,
/// within the first turn, over the tip to the mouth again.
struct DartPlace {
    int piece = -1;
    double from = 0, tip = 0, to = 0;

    double firstLeg() const { return tip - from; }
    double secondLeg() const { return to - tip; }
};

/// For a seam of kind Dart with both sides on one outline, one ending where the other starts.
/// @param seam  index into the graph  Cost: the piece's outline. Pure.
std::optional<DartPlace> dartPlace(const Garment& garment, int seam);

/// For straight legs of these lengths: the intake of an angle at the tip, radians in [0, pi], and
/// the angle of an intake within reach.
double intakeOf(const DartPlace& dart, double angle);
double angleOf(const DartPlace& dart, double intake);

/// Settings of darts, by seam; ignores seams that are no longer darts. The last of several settings
/// counts.  Cost: seams times settings. Pure.
std::map<int, DartSettings> statedDarts(const SeamGraph& graph, const LineSettings& settings);

/// A dart whose intake the user has set.
struct TypedDart : DartPlace {
    double intake = 0;  ///< mm

    bool operator==(const TypedDart& other) const {
        return piece == other.piece && from == other.from && tip == other.tip && to == other.to &&
               intake == other.intake;
    }
};

/// Per piece, sorted by `from`; of two nested ones, only the first.  Pure.
std::vector<std::vector<TypedDart>> typedDarts(const Garment& garment,
                                               const LineSettings& settings);

/// Whether a place on an outline of this perimeter lies within a dart, excluding its mouth.
bool isWithin(const DartPlace& dart, double perimeter, double at);

}  // namespace toile
