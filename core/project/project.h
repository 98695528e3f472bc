// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/assemble/load_options.h"
#include "core/garment/fabric.h"
#include "core/marker/marker_settings.h"
#include "core/project/piece_settings.h"
#include "core/prove/proof_settings.h"

namespace toile {

/// A file that a project refers to: its path and a hash of its content.
struct FileReference {
    std::filesystem::path path;           ///< absolute
    std::optional<std::uint64_t> hash{};  ///< contentHash of its bytes; empty: unknown
    /// Absolute too: second place to look if there is no file at `path`. May be empty.
    std::filesystem::path elsewhere{};

    bool operator==(const FileReference&) const = default;
};

/// A piece as stored in a project.
struct ProjectPiece {
    PieceId id;        ///< none in files of version 1, which identify pieces by name
    std::string name;  ///< its own, not the user's name
    PieceSettings settings{};

    bool operator==(const ProjectPiece&) const = default;
};

/// View settings that belong to the garment.
struct ProjectView {
    std::string overlay;  ///< the window's name for it; empty: not stated
    bool wireframe = false;
    bool referencePanels = false;
    bool exactOutline = false;
    bool cuttingLine = true, notches = true, internalLines = true, grain = true, labels = true;

    bool operator==(const ProjectView&) const = default;
};

/// All the user's edits of a garment; what depends on them (pieces, seams, flat pieces) is computed
/// again. The file format is described in docs/project-file.md.
struct Project {
    std::vector<FileReference> files{};  ///< read together into a single garment
    LoadOptions loading{};
    FlattenOptions options{};
    LineSettings lines{};
    Fabric fabric = fabricPresets().front();
    MaterialList materials{};  ///< of pieces that are cut from another fabric
    std::vector<ProjectPiece> pieces{};
    PieceLabels labels{};
    MarkerPlans markers{};  ///< layouts of the pieces on cloth
    /// The pattern file to compare the pieces with.
    std::optional<FileReference> reference{};
    /// Settings of the proof; the body's path is absolute.
    ProofPlan proof{};
    /// Second place to look for the body, as in `FileReference`. May be empty.
    std::filesystem::path bodyElsewhere{};
    ProjectView view{};
    /// In a recovery file: path of the original project, empty if it was never saved.
    std::optional<std::filesystem::path> recoveryOf{};

    bool operator==(const Project&) const = default;
};

/// The settings of a garment's pieces, in its order; defaults for pieces that the project does not
/// know. Anchors are found again by position. Pure.
std::vector<PieceSettings> settingsFor(const Project& project, const Garment& garment);

/// Notes for the user if the garment differs from the one the project was made with: files with
/// another content, missing pieces. Pure.
Problems differencesTo(const Project& project, const Garment& garment);

/// The pieces with their settings, with anchors for those that are flat.
/// @param settings, results  one per piece; results may be null or empty
std::vector<ProjectPiece> projectPieces(const Garment& garment, std::vector<PieceSettings> settings,
                                        const PieceResults& results);

/// Paths and content hashes of the garment's files.
std::vector<FileReference> meshReferences(const Garment& garment);

/// Returns the missing mesh files of the project; sets `path` of files found elsewhere, including
/// the reference pattern and the proof's body. Reads the disk.
std::vector<std::filesystem::path> locateMeshes(Project& project);

}  // namespace toile
