// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/garment/seam.h"

namespace toile {

/// The part of `a` that `b` has, 0 to 1: 0 where they are of two lines, or run against each other.
double covered(const LineStretch& a, const LineStretch& b);

/// The seam that has most of a place, whichever way round; -1 where none has any of it.
int seamAt(const SeamGraph& graph, const SeamPlace& place);

/// Gives every seam what was said about it: of those places that have more than half of the seam,
/// the one that fits best; of equals the last. Names stay unique. Cost: n log n.
void applySettings(SeamGraph& graph, const std::vector<SeamSettings>& settings);

/// The settings with another ease for a seam, which says what else there is to say of it too.
std::vector<SeamSettings> withEase(std::vector<SeamSettings> settings, const Seam& seam,
                                   std::optional<double> ease);
/// The same, with where it is drawn.
std::vector<SeamSettings> withEase(std::vector<SeamSettings> settings, const Seam& seam,
                                   std::optional<double> ease, std::optional<SeamPart> drawn);

/// The same for many, as a seams file says it: by the names of seams, before any is renamed.
/// @param problems  gets NoSuchSeam for names that fit no seam that is sewn, or several
std::vector<SeamSettings> withEaseByName(std::vector<SeamSettings> settings, const SeamGraph& graph,
                                         const std::map<std::string, double>& ease,
                                         Problems& problems);

/// The ease of all seams of which it was stated, by their names.
std::map<std::string, double> easeByName(const SeamGraph& graph);

}  // namespace toile
