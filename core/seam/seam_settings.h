// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/garment/seam.h"

namespace toile {

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
