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
/// How the project was shown, or as `before` if it does not say.
ViewState viewOf(const ProjectView& saved, ViewState before);
/// The state of an opened project, with the garment made for it; without its reference pattern.
DocumentState stateOf(const Project& project, GarmentInputs inputs, const Garment& garment);

/// Jobs that write files of the document, and jobs that read projects and patterns. Each takes a
/// snapshot, so that edits may go on. Callbacks run on the GUI thread.

/// Writes the flat pieces to one file in the format of its ending. If it is cancelled, the file
/// stays as it was.
/// @param only  the pieces to write; none: all, for the next two jobs, too
/// @param done  called when the file is written
std::unique_ptr<Job> exportJob(const Document& document, std::filesystem::path path,
                               const ExportOptions& options, std::set<int> only,
                               std::function<void(const Exported&)> done);

/// The beginning of the file that an export would write. Errors: of the format's writer.
std::unique_ptr<Job> beginningJob(const Document& document, FormatId format,
                                  const ExportOptions& options, std::set<int> only,
                                  std::function<void(const std::string&)> done);

/// The pattern and its drawing for files and paper.
std::unique_ptr<Job> drawingJob(const Document& document, std::set<int> only,
                                std::function<void(std::shared_ptr<const DrawnPattern>)> done);

/// The content of a project file when it was last read or written here: any other content comes
/// from another program. Shared by jobs that run one after the other; the GUI thread creates it,
/// and only these jobs use it.
struct KnownFile {
    std::filesystem::path path{};
    std::optional<std::uint64_t> hash{};  ///< contentHash of the bytes; none: unknown
};

/// Whether the file was written, or left because others have changed it.
enum class SaveOutcome { Written, ChangedByOthers };

struct SaveTarget {
    std::filesystem::path path{};
    /// For a recovery file: the path of the project, or an empty one.
    std::optional<std::filesystem::path> recoveryOf{};
    /// The known content of the file; null: overwrite any. If the path is the known one and others
    /// have changed it, nothing is written; otherwise the new content becomes the known one.
    std::shared_ptr<KnownFile> known{};
    bool overwrite = false;  ///< also if others have changed it
};

/// Writes the open document as a project file. Requires an open garment.
/// @param done  not called if the file cannot be written
std::unique_ptr<Job> saveJob(const Document& document, SaveTarget target,
                             std::function<void(SaveOutcome)> done);

/// Reads a reference pattern in the format of its ending (`readPatternFile`).
/// @param done  not called if it cannot be read
std::unique_ptr<Job> referenceJob(std::filesystem::path path,
                                  std::function<void(ReferenceFile)> done);

/// New places of files that are not where the project says.
using FoundMeshes = std::map<std::filesystem::path, std::filesystem::path>;

struct OpenedProject {
    Project project;  ///< with the new paths
    Derived derived;
    ReferenceFile reference;  ///< with its path even if it could not be read, which is a note
    Problems notes;           ///< differences to when the project was saved
    KnownFile known;          ///< the project file, or the one that a recovery file belongs to
};

/// Reads a project file and its meshes, and prepares the 3D view. Calls one of the two functions.
/// @param missing  gets the meshes that were not found: nothing was opened
std::unique_ptr<Job> projectJob(
    std::filesystem::path path, FoundMeshes found, std::function<void(OpenedProject)> done,
    std::function<void(const std::vector<std::filesystem::path>&)> missing);

}  // namespace toile::app
