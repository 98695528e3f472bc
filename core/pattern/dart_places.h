// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"

namespace toile {

/// Where a dart is on the outline of its piece. Arc lengths in 3D, mm: `from` at the mouth and
/// within the first turn, over the tip to the mouth again.
struct DartPlace {
    int piece = -1;
    double from = 0, tip = 0, to = 0;

    double firstLeg() const { return tip - from; }
    double secondLeg() const { return to - tip; }
};

/// Of a seam of kind Dart with both sides on one outline, one of which ends where the other begins.
/// @param seam  index into the graph  Cost: the piece's outline. Pure.
std::optional<DartPlace> dartPlace(const Garment& garment, int seam);

/// Between straight legs of these lengths: the intake of an angle at the tip, radians in [0, pi],
/// and the angle of an intake within reach.
double intakeOf(const DartPlace& dart, double angle);
double angleOf(const DartPlace& dart, double intake);

/// What a person has said of darts, by seam; of seams that are no darts now nothing. The last of
/// several counts.  Cost: seams times settings. Pure.
std::map<int, DartSettings> saidOfDarts(const SeamGraph& graph, const LineSettings& settings);

/// A dart that opens by as much as a person has typed.
struct TypedDart : DartPlace {
    double intake = 0;  ///< mm

    bool operator==(const TypedDart& other) const {
        return piece == other.piece && from == other.from && tip == other.tip && to == other.to &&
               intake == other.intake;
    }
};

/// Per piece, by `from`; of two of which one lies within the other the first.  Pure.
std::vector<std::vector<TypedDart>> typedDarts(const Garment& garment,
                                               const LineSettings& settings);

/// Whether a place on an outline that is so long lies within a dart, its mouth left out.
bool isWithin(const DartPlace& dart, double perimeter, double at);

}  // namespace toile
