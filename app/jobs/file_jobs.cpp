// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/file_jobs.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "app/base/text.h"
#include "app/document/document.h"
#include "app/jobs/derivation.h"
#include "app/jobs/reference_finder.h"
#include "core/base/file.h"
#include "core/base/id.h"
#include "core/formats/export_file.h"
#include "core/project/project_file.h"

namespace toile::app {

Project projectOf(const DocumentState& state, const Derived& derived, const ViewState& view) {
    const Garment& garment = *derived.garment;
    Project project;
    project.files = meshReferences(garment);
    project.loading = state.inputs.loading;
    project.loading.known = knownPieces(garment);
    project.options = state.options;
    project.lines = state.lines;
    project.fabric = state.fabric;
    project.materials = state.materials;
    project.pieces = projectPieces(garment, settingsOf(garment, state.settings), derived.results);
    project.labels = state.labels;
    project.markers = state.markers.all();
    project.proof = state.proof;
    if (const auto& path = state.reference.path; !path.empty()) {
        project.reference = FileReference{.path = path};
    }
    project.view = savedView(view);
    return project;
}

ProjectView savedView(const ViewState& view) {
    return {std::string(wordOf(kOverlayWords, view.overlay)),
            view.wireframe,
            view.referencePanels,
            view.exactOutline,
            view.cuttingLine,
            view.notches,
            view.internalLines,
            view.grain,
            view.labels};
}

ViewState viewOf(const ProjectView& saved, ViewState view) {
    view.overlay = parseWord(kOverlayWords, saved.overlay).value_or(view.overlay);
    view.wireframe = saved.wireframe;
    view.referencePanels = saved.referencePanels;
    view.exactOutline = saved.exactOutline;
    view.cuttingLine = saved.cuttingLine;
    view.notches = saved.notches;
    view.internalLines = saved.internalLines;
    view.grain = saved.grain;
    view.labels = saved.labels;
    return view;
}

DocumentState stateOf(const Project& project, GarmentInputs inputs, const Garment& garment) {
    DocumentState state;
    state.inputs = std::move(inputs);
    state.options = project.options;
    state.lines = project.lines;
    state.fabric = project.fabric;
    state.materials = project.materials;
    state.labels = project.labels;
    state.markers = ClothPlans(project.markers);
    state.proof = project.proof;
    if (project.reference) {
        state.reference.path = project.reference->path;
    }
    std::vector<PieceSettings> settings = settingsFor(project, garment);
    for (std::size_t i = 0; i < settings.size(); ++i) {
        state.settings.emplace(garment.pieces[i]->id, std::move(settings[i]));
    }
    return state;
}

namespace {

/// True if the file exists with another content. Reads it.
bool wasChangedByOthers(const KnownFile& known) {
    if (!known.hash) {
        return false;
    }
    const auto bytes = readFile(known.path);
    return bytes && contentHash(*bytes) != *known.hash;
}

/// The file that will be saved to, as it is on the disk now.
KnownFile knownOf(const std::filesystem::path& path, std::uint64_t hash, const Project& project) {
    if (!project.recoveryOf) {
        return {path, hash};
    }
    const auto bytes = readFile(*project.recoveryOf);
    return {*project.recoveryOf, bytes ? std::optional(contentHash(*bytes)) : std::nullopt};
}

/// Size of the preview of a file, bytes.
constexpr std::size_t kMaxOfBeginning = 20000;

/// The project of a state, even if its garment is still being made.
Result<Project> projectNow(DocumentState state, const Derived& derived,
                           const std::vector<PieceSettings>& settings, const ViewState& view,
                           Progress& progress) {
    if (derived.inputs == state.inputs) {
        return projectOf(state, derived, view);
    }
    const Result<Derivation> made = deriveGarment(state, derived, settings, progress);
    if (!made) {
        return made.error();
    }
    state.inputs = made->derived.inputs;
    state.settings = settingsAfter(*made, state, settings);
    state.materials = materialsInUse(state);
    return projectOf(state, made->derived, view);
}

struct ReadMeshes {
    OpenedProject opened;
    std::vector<std::filesystem::path> lost;  ///< then nothing was opened
};

Result<ReadMeshes> readMeshes(const std::filesystem::path& path, const FoundMeshes& found,
                              Progress& progress) {
    Result<ReadProject> read = readProject(path);
    if (!read) {
        return read.error();
    }
    ReadMeshes made;
    OpenedProject& opened = made.opened;
    Project& project = opened.project = std::move(read->project);
    opened.notes = std::move(read->notes);
    opened.known = knownOf(path, read->hash, project);
    for (FileReference& file : project.files) {
        if (const auto place = found.find(file.path); place != found.end()) {
            file.path = place->second;
        }
    }
    made.lost = locateMeshes(project);
    if (!made.lost.empty()) {
        return made;
    }
    std::vector<std::filesystem::path> paths;
    for (const FileReference& file : project.files) {
        paths.push_back(file.path);
    }
    Result<Derived> derived = readGarment(paths, project.loading, progress);
    if (!derived) {
        return derived.error();
    }
    opened.derived = std::move(derived).value();
    const Problems differences = differencesTo(project, *opened.derived.garment);
    opened.notes.insert(opened.notes.end(), differences.begin(), differences.end());
    if (project.reference) {
        const auto reference = readReference(project.reference->path);
        if (!reference) {
            opened.notes.push_back(reference.error());
        }
        opened.reference = reference ? *reference : ReferenceFile{project.reference->path};
    }
    return made;
}

}  // namespace

std::unique_ptr<Job> exportJob(const Document& document, std::filesystem::path path,
                               const ExportOptions& options, std::set<int> only,
                               std::function<void(const Exported&)> done) {
    const QString name = textOf(path.filename());
    auto work = [now = PatternNow(document, std::move(only)), path = std::move(path),
                 options](Progress& progress) -> Result<Exported> {
        return now.with(options, progress,
                        [&path](const ExportSource& source, const Progress& exporting) {
                            return exportFile(path, source, exporting);
                        });
    };
    return makeJob(QCoreApplication::translate("ExportJob", "Writing %1").arg(name),
                   std::move(work), std::move(done));
}

std::unique_ptr<Job> beginningJob(const Document& document, FormatId format,
                                  const ExportOptions& options, std::set<int> only,
                                  std::function<void(const std::string&)> done) {
    auto work = [now = PatternNow(document, std::move(only)), format,
                 options](Progress& progress) -> Result<std::string> {
        return now.with(
            options, progress,
            [format](const ExportSource& source, const Progress&) -> Result<std::string> {
                Result<ExportedFiles> made = formatOf(format).write(source);
                if (!made) {
                    return made.error();
                }
                std::string& bytes = made->front().bytes;
                bytes.resize(std::min(bytes.size(), kMaxOfBeginning));
                return std::move(bytes);
            });
    };
    return makeJob(QCoreApplication::translate("ExportJob", "Drawing the pattern"), std::move(work),
                   std::move(done));
}

std::unique_ptr<Job> drawingJob(const Document& document, std::set<int> only,
                                std::function<void(std::shared_ptr<const DrawnPattern>)> done) {
    using Made = std::shared_ptr<const DrawnPattern>;
    auto work = [now = PatternNow(document, std::move(only))](Progress& progress) -> Result<Made> {
        return now.with({}, progress, [](const ExportSource& source, const Progress&) {
            return Result<Made>(std::make_shared<const DrawnPattern>(
                DrawnPattern{source.laid().pattern, source.drawing()}));
        });
    };
    return makeJob(QCoreApplication::translate("ExportJob", "Drawing the pattern"), std::move(work),
                   std::move(done));
}

std::unique_ptr<Job> saveJob(const Document& document, SaveTarget target,
                             std::function<void(SaveOutcome)> done) {
    Q_ASSERT(document.garment());
    const QString name = textOf(target.path.filename());
    auto work = [state = document.state(), derived = document.derived(),
                 settings = document.settings(), view = document.view(),
                 target = std::move(target)](Progress& progress) -> Result<SaveOutcome> {
        // As late as possible: another program may be writing it.
        KnownFile* known = target.known.get();
        if (known && known->path == target.path && !target.overwrite &&
            wasChangedByOthers(*known)) {
            return SaveOutcome::ChangedByOthers;
        }
        const Result<Project> saved = projectNow(state, derived, settings, view, progress);
        if (!saved) {
            return saved.error();
        }
        Project project = *saved;
        project.recoveryOf = target.recoveryOf;
        const auto written = writeProject(target.path, project);
        if (!written) {
            return written.error();
        }
        if (known) {
            *known = {target.path, *written};
        }
        return SaveOutcome::Written;
    };
    return makeJob(QCoreApplication::translate("SaveJob", "Saving %1").arg(name), std::move(work),
                   std::move(done), false);
}

std::unique_ptr<Job> referenceJob(std::filesystem::path path,
                                  std::function<void(ReferenceFile)> done) {
    const QString name = textOf(path.filename());
    auto work = [path = std::move(path)](Progress&) { return readReference(path); };
    return makeJob(QCoreApplication::translate("ImportJob", "Reading %1").arg(name),
                   std::move(work), std::move(done));
}

std::unique_ptr<Job> projectJob(
    std::filesystem::path path, FoundMeshes found, std::function<void(OpenedProject)> done,
    std::function<void(const std::vector<std::filesystem::path>&)> missing) {
    const QString name = textOf(path.filename());
    auto work = [path = std::move(path), found = std::move(found)](Progress& progress) {
        return readMeshes(path, found, progress);
    };
    auto taken = [done = std::move(done), missing = std::move(missing)](ReadMeshes made) {
        made.lost.empty() ? done(std::move(made.opened)) : missing(made.lost);
    };
    return makeJob(QCoreApplication::translate("ProjectJob", "Reading %1").arg(name),
                   std::move(work), std::move(taken));
}

}  // namespace toile::app
