// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "app/document/document_state.h"
#include "app/document/view_state.h"
#include "app/jobs/job.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/export_file.h"
#include "core/formats/formats.h"
#include "core/project/project.h"

namespace toile::app {

class Document;

/// The project that is saved of a document. Requires a garment. Linear in the outlines;
/// thread-safe.
Project projectOf(const DocumentState& state, const Derived& derived, const ViewState& view);
/// How the document is shown, as it is saved.
ProjectView savedView(const ViewState& view);
/// How the project was shown; `before` where it does not say.
ViewState viewOf(const ProjectView& saved, ViewState before);
/// The state of an opened project, with the garment made for it; without its reference pattern.
DocumentState stateOf(const Project& project, GarmentInputs inputs, const Garment& garment);

/// The jobs that write files of the document, and those that read projects and patterns. What they
/// take is a snapshot: edits may go on. What they are to call is called on the GUI thread.

/// Writes the flat pieces to one file; its ending chooses the format. Cancelled, it leaves the file
/// as it was.
/// @param only  the pieces that are written; none: all, for the two jobs below too
/// @param done  called once the file is written
std::unique_ptr<Job> exportJob(const Document& document, std::filesystem::path path,
                               const ExportOptions& options, std::set<int> only,
                               std::function<void(const Exported&)> done);

/// The beginning of the file that an export would write. Errors: of the format's writer.
std::unique_ptr<Job> beginningJob(const Document& document, FormatId format,
                                  const ExportOptions& options, std::set<int> only,
                                  std::function<void(const std::string&)> done);

/// The pattern and the drawing of it that files and paper would have.
std::unique_ptr<Job> drawingJob(const Document& document, std::set<int> only,
                                std::function<void(std::shared_ptr<const DrawnPattern>)> done);

/// What a project file held when it was last read or written here: what else it holds now, another
/// program has put there. Shared by those jobs that run one after the other; the GUI thread makes
/// one, and leaves it to them.
struct KnownFile {
    std::filesystem::path path{};
    std::optional<std::uint64_t> hash{};  ///< contentHash of the bytes; none: not known
};

/// Whether the file is as it is to be. Not written is only what others have changed.
enum class SaveOutcome { Written, ChangedByOthers };

struct SaveTarget {
    std::filesystem::path path{};
    /// Where this is no saving but a recovery file: the project's path or none.
    std::optional<std::filesystem::path> recoveryOf{};
    /// What is known of the files that are written; none: is not asked about. Where the path is
    /// the known one and others have changed it, nothing is written; else it is known now.
    std::shared_ptr<KnownFile> known{};
    bool overwrite = false;  ///< what others have changed too
};

/// Writes the open document as a project file. Requires an open garment.
/// @param done  not called where the file cannot be written
std::unique_ptr<Job> saveJob(const Document& document, SaveTarget target,
                             std::function<void(SaveOutcome)> done);

/// Reads the pattern that the pieces are to be compared with, by its ending (`readPatternFile`).
/// @param done  not called where it cannot be read
std::unique_ptr<Job> referenceJob(std::filesystem::path path,
                                  std::function<void(ReferenceFile)> done);

/// Where files are found that are not where the project says.
using FoundMeshes = std::map<std::filesystem::path, std::filesystem::path>;

struct OpenedProject {
    Project project;  ///< with the paths that were found
    Derived derived;
    ReferenceFile reference;  ///< with its path where it could not be read, too: that is a note
    Problems notes;           ///< what is other than it was when the project was saved
    KnownFile known;          ///< the project's file; of a recovery file the one that it is of
};

/// Reads a project file and its meshes, and prepares what the 3D view shows of them. One of the two
/// is called.
/// @param missing  meshes that are not there: nothing was opened
std::unique_ptr<Job> projectJob(
    std::filesystem::path path, FoundMeshes found, std::function<void(OpenedProject)> done,
    std::function<void(const std::vector<std::filesystem::path>&)> missing);

}  // namespace toile::app
