// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/base/json_fields.h"
#include "core/base/result.h"
#include "core/project/project.h"

namespace toile {

/// A project as read, with notes for the user.
struct ReadProject {
    Project project;
    Problems notes{};        ///< UnknownKey
    std::uint64_t hash = 0;  ///< contentHash of the file's bytes
};

/// File name extension of projects.
inline constexpr std::string_view kProjectEnding = ".toile";
bool isProjectFile(const std::filesystem::path& path);

/// Reads a project file; the meshes are not touched (`locateMeshes`).
/// Errors: FileUnreadable; MalformedProject, naming the key and the fault; NewerProject.
Result<ReadProject> readProject(const std::filesystem::path& path);
/// The same for a text in memory. Any text gives a project or an error. Linear. Pure.
/// @param name    of the file, for messages
/// @param folder  absolute: base of relative paths
Result<ReadProject> parseProject(std::string_view text, const std::string& name,
                                 const std::filesystem::path& folder);

/// The file's text, which reads back to the same project to the last bit of every number. Same
/// project, same bytes. Precondition: numbers are finite.
/// @param folder  absolute: the folder of the file. Empty: write absolute paths only. Pure.
std::string projectText(const Project& project, const std::filesystem::path& folder);
/// Writes the file (`writeFile`: the old one stays whole on failure) and returns the contentHash of
/// the written bytes. Errors: FileUnwritable.
Result<std::uint64_t> writeProject(const std::filesystem::path& path, const Project& project);

/// The version of the project format that is written, and the newest that can be read.
inline constexpr int kProjectVersion = 4;

/// Converts a document of one version to the next, as far as it is valid; faults are reported when
/// it is read.
struct ProjectUpgrade {
    int from;
    void (*apply)(JsonDocument& document);
};

/// Version 1 identified pieces by name: `pieces` was an object, `partOf` a name.
void listPieces(JsonDocument& document);

/// Version 2 knew exact outlines only and had no settings of lines.
void sayNothingOfLines(JsonDocument& document);

/// Version 3 gave all free edges the width of hems.
void keepHemWidths(JsonDocument& document);

/// One upgrade for each earlier version.
inline constexpr ProjectUpgrade kProjectUpgrades[] = {
    {1, listPieces}, {2, sayNothingOfLines}, {3, keepHemWidths}};

/// Applies the upgrades from `version` on in order; each sets the new "version".
inline void upgradeProject(JsonDocument& document, int version,
                           std::span<const ProjectUpgrade> upgrades) {
    for (;; ++version) {
        const auto next = std::ranges::find(upgrades, version, &ProjectUpgrade::from);
        if (next == upgrades.end()) {
            return;
        }
        next->apply(document);
        document["version"] = version + 1;
    }
}

}  // namespace toile
