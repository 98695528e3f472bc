// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/marker/marker_settings.h"

namespace toile::app {

/// What was typed for `toile marker`.
struct MarkerArguments {
    std::optional<int> rounds;      ///< after so many it ends
    std::optional<double> seconds;  ///< after the round in which so much time has passed
    int threads = 0;                ///< 0: as the machine has
    MarkerSettings settings{};      ///< but for the hides, which the command reads
    /// What of them was typed: each takes it over into other settings.
    std::vector<void (*)(const MarkerSettings& typed, MarkerSettings& settings)> stated;
    std::vector<std::filesystem::path> hides;
    std::optional<std::string> material;  ///< only of this one; empty: of the garment's own fabric
    std::optional<double> minutesPerMetre;
    std::filesystem::path report;
};

/// The settings of a project, with what was typed in their place.
/// @param typed  the settings with their hides
MarkerSettings over(MarkerSettings saved, const MarkerArguments& arguments,
                    const MarkerSettings& typed);

/// The time that a marker takes where nothing else is said.
inline constexpr double kUsualMarkerSeconds = 5;

/// Whether to go on: until the rounds are done or the time is up, whichever was typed.
bool isToGoOn(const MarkerArguments& typed, int rounds, double seconds);

/// True of a file that holds an instance of the nesting problem, and no garment.
bool isNestInstance(const std::filesystem::path& path);

/// "305x610": along the warp, across it, mm. @return what is wrong, or nothing
std::string readSheet(const std::string& typed, MarkerSettings& settings);
/// "80x60", "80x0@10,20": along the warp, across it, origin, mm. @return what is wrong, or nothing
std::string readRepeat(const std::string& typed, MarkerSettings& settings);
/// "front=2". @return what is wrong, or nothing
std::string readGrade(const std::string& typed, MarkerSettings& settings);

/// What was typed against what it goes with, typed or said by the project.
/// @param typed  with its hides  @param settings  that hold (`over`)  @return what is wrong, or
/// nothing
std::string wrongTogether(const MarkerSettings& typed, const MarkerSettings& settings);

/// What goes only with garments, or only with instances; which files can be written.
/// @return what is wrong, or nothing
std::string wrongInMarker(const std::vector<std::filesystem::path>& inputs,
                          const std::vector<std::filesystem::path>& outputs,
                          const MarkerArguments& typed);

}  // namespace toile::app
