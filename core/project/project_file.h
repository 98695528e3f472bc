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

/// A project as read, and what the person should know of that.
struct ReadProject {
    Project project;
    Problems notes{};        ///< UnknownKey
    std::uint64_t hash = 0;  ///< contentHash of the file's bytes
};

/// The ending of project files.
inline constexpr std::string_view kProjectEnding = ".toile";
bool isProjectFile(const std::filesystem::path& path);

/// Reads a project file; the meshes are not touched (`locateMeshes`).
/// Errors: FileUnreadable; MalformedProject, naming the key and what is wrong; NewerProject.
Result<ReadProject> readProject(const std::filesystem::path& path);
/// The same for a text in memory. Any text gives a project or an error. Linear. Pure.
/// @param name    of the file, for messages
/// @param folder  absolute: what relative paths are relative to
Result<ReadProject> parseProject(std::string_view text, const std::string& name,
                                 const std::filesystem::path& folder);

/// The file's text: reads back to the same project, every number to the last bit. Same project,
/// same bytes. Precondition: numbers are finite.
/// @param folder  absolute: what the file will lie in. Empty: paths are absolute only. Pure.
std::string projectText(const Project& project, const std::filesystem::path& folder);
/// Writes it beside the old one, which stays whole if anything goes wrong: the contentHash of what
/// was written. Errors: FileUnwritable.
Result<std::uint64_t> writeProject(const std::filesystem::path& path, const Project& project);

/// The version of the project format that is written, and up to which files are read.
inline constexpr int kProjectVersion = 3;

/// Makes a document of one version into one of the next, as far as it is what it should be: what is
/// wrong in it is found when it is read.
struct ProjectUpgrade {
    int from;
    void (*apply)(JsonDocument& document);
};

/// Version 1 knew pieces by name: `pieces` was an object, `partOf` a name.
void listPieces(JsonDocument& document);

/// Version 2 knew exact outlines only: nothing had been said of lines.
void sayNothingOfLines(JsonDocument& document);

/// One for each version before the present one.
inline constexpr ProjectUpgrade kProjectUpgrades[] = {{1, listPieces}, {2, sayNothingOfLines}};

/// Applies, one after the other, the upgrades from `version` on; each says its new "version".
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
