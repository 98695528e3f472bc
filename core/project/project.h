// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/garment/fabric.h"
#include "core/marker/marker_plan.h"
#include "core/pipeline/pipeline.h"
#include "core/project/piece_settings.h"
#include "core/prove/proof_settings.h"

namespace toile {

/// A file that a project names: where it was, and what was in it.
struct FileReference {
    std::filesystem::path path;           ///< absolute
    std::optional<std::uint64_t> hash{};  ///< contentHash of its bytes; none: not known
    /// Absolute too: where else to look, where there is no file at `path`. May be empty.
    std::filesystem::path elsewhere{};

    bool operator==(const FileReference&) const = default;
};

/// A piece as a project knows it.
struct ProjectPiece {
    PieceId id;        ///< none in files of version 1, which know pieces by name
    std::string name;  ///< its own, not what a person calls it
    PieceSettings settings{};

    bool operator==(const ProjectPiece&) const = default;
};

/// How the garment was shown, as far as it belongs to the garment.
struct ProjectView {
    std::string overlay;  ///< the window's word for it; empty: not stated
    bool wireframe = false;
    bool referencePanels = false;
    bool exactOutline = false;
    bool cuttingLine = true, notches = true, internalLines = true, grain = true, labels = true;

    bool operator==(const ProjectView&) const = default;
};

/// Everything a person has done with a garment; what follows from it (pieces, seams, flat pieces)
/// is worked out again. The file format is described in docs/project-file.md.
struct Project {
    std::vector<FileReference> files{};  ///< read as one garment
    LoadOptions loading{};
    FlattenOptions options{};
    LineSettings lines{};
    Fabric fabric = fabricPresets().front();
    MaterialList materials{};  ///< of the pieces that are cut from another fabric
    std::vector<ProjectPiece> pieces{};
    PieceLabels labels{};
    MarkerPlans markers{};  ///< how the pieces are laid on cloth
    /// The pattern file that the pieces are compared with.
    std::optional<FileReference> reference{};
    /// How the pattern is proved; the body's path is absolute.
    ProofPlan proof{};
    /// Where else to look for the body, as of `FileReference`. May be empty.
    std::filesystem::path bodyElsewhere{};
    ProjectView view{};
    /// Where this is the recovery file of another: that project's path, empty where it had none.
    std::optional<std::filesystem::path> recoveryOf{};

    bool operator==(const Project&) const = default;
};

/// The settings of a garment's pieces, in its order; as nobody had said anything where the project
/// does not know a piece. Anchors are found again by where they lie. Pure.
std::vector<PieceSettings> settingsFor(const Project& project, const Garment& garment);

/// What the person should know where the garment is not the one the project was made with: files
/// whose content is another, pieces that are no more there. Pure.
Problems differencesTo(const Project& project, const Garment& garment);

/// The pieces with their settings, with anchors for those that are flat.
/// @param settings, results  one per piece; results may be null or left out
std::vector<ProjectPiece> projectPieces(const Garment& garment, std::vector<PieceSettings> settings,
                                        const PieceResults& results);

/// Paths and content hashes of the garment's files.
std::vector<FileReference> meshReferences(const Garment& garment);

/// Meshes of the project that are not there; `path` of files found elsewhere, the reference pattern
/// and the proof's body too, is set to that. Touches the disk.
std::vector<std::filesystem::path> locateMeshes(Project& project);

}  // namespace toile
