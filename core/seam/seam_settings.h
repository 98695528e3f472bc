// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/assemble/cut_pieces.h"
#include "core/assemble/join_pieces.h"
#include "core/garment/seam.h"
#include "core/seam/outline.h"

namespace toile {

/// The origin of a stretch of outline: the line that most of it comes from. No line if the origin
/// is unknown. @param side  along `outline`, an outline of the piece  Cost: its edges. Pure.
LineStretch stretchOf(const SeamSide& side, const seam::Outline& outline, const Piece& piece);

/// The maximal parts of an outline, as arc lengths in mm, that come from a stretch, in its order. A
/// part across the outline's first vertex is split in two. Cost: the outline's edges. Pure.
std::vector<geometry::Interval> partsOf(const LineStretch& stretch, const seam::Outline& outline,
                                        const Piece& piece);

/// Records for every seam and free edge the origin of its two sides, and gives it an id. Cost:
/// linear in the edges of the seams, times the logarithm of the outlines' edges.
void traceOrigins(const Pieces& pieces, const seam::Outlines& outlines, std::vector<Seam>& seams);

/// The command that removes a seam made by the garment's own division: points along its left side,
/// mm, including its ends.
UserJoin joinAlong(const Seam& seam, const Pieces& pieces);

/// Names seams after the user's or the tailor's cut that made them: "inseam", or "inseam 1",
/// "inseam 2" in the order of the graph; if two cuts make one seam, the first cut's name is used.
/// Names stay unique. Other seams keep their names. Cost: n log n.
void nameAfterCuts(SeamGraph& graph, const std::vector<AppliedCut>& cuts);

/// The fraction of `a` that `b` covers, 0 to 1; 0 for different lines or opposite directions.
double covered(const LineStretch& a, const LineStretch& b);

/// The seam that covers most of a place, in either direction; -1 if none covers any of it.
int seamAt(const SeamGraph& graph, const SeamPlace& place);

/// Applies stored settings to every seam: of the places that cover more than half of the seam, the
/// best fit; the last of equal fits. Names stay unique. Cost: n log n.
void applySettings(SeamGraph& graph, const std::vector<SeamSettings>& settings);

/// The settings with another ease for a seam; its other settings are kept.
std::vector<SeamSettings> withEase(std::vector<SeamSettings> settings, const Seam& seam,
                                   std::optional<double> ease);
/// The same, with the part on which the ease is drawn.
std::vector<SeamSettings> withEase(std::vector<SeamSettings> settings, const Seam& seam,
                                   std::optional<double> ease, std::optional<SeamPart> drawn);

/// The same for many seams, by their names in a seams file, before any seam is renamed.
/// @param problems  gets NoSuchSeam for names that match no sewn seam, or several
std::vector<SeamSettings> withEaseByName(std::vector<SeamSettings> settings, const SeamGraph& graph,
                                         const std::map<std::string, double>& ease,
                                         Problems& problems);

/// The stated ease of seams by name; seams without one are left out.
std::map<std::string, double> easeByName(const SeamGraph& graph);

}  // namespace toile
