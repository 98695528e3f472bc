// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/garment/seam.h"

namespace toile {

/// What a person has said about a seam, or about the part of one that was there then.
struct SeamSettings {
    SeamPlace place;
    /// As Seam::ease, of the left side of `place`; none: as the 3D lengths have it.
    std::optional<double> ease{};
    std::string name{};  ///< shown in place of the one made up; empty: that one

    bool operator==(const SeamSettings&) const = default;
};

/// The seam that has most of a place, whichever way round; -1 where none has any of it.
int seamAt(const SeamGraph& graph, const SeamPlace& place);

/// Gives every seam what was said about it: of those places that have more than half of the seam,
/// the one that fits best; of equals the last. Names stay unique. Cost: seams times settings.
void applySettings(SeamGraph& graph, const std::vector<SeamSettings>& settings);

/// The settings with another ease for a seam, which says what else there is to say of it too.
std::vector<SeamSettings> withEase(std::vector<SeamSettings> settings, const Seam& seam,
                                   std::optional<double> ease);

/// The same as a seams file says it, by the names of seams.
/// @param problems  gets NoSuchSeam for names that fit no seam that is sewn, or several
std::vector<SeamSettings> settingsByName(const SeamGraph& graph,
                                         const std::map<std::string, double>& ease,
                                         Problems& problems);

/// The ease of all seams of which it was stated, by their names.
std::map<std::string, double> easeByName(const SeamGraph& graph);

}  // namespace toile
