// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/project_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/base/path_text.h"
#include "app/document/disposal.h"
#include "app/render/scene_builder.h"
#include "core/base/content_hash.h"
#include "core/base/file.h"
#include "core/project/project_file.h"

namespace toile {
namespace {

/// Of the job's time, about; the rest is the scene.
constexpr double kProjectReadingShare = 0.97;

/// What will be saved to, as it is on the disk now.
KnownFile knownOf(const std::filesystem::path& path, std::uint64_t hash, const Project& project) {
    if (!project.recoveryOf) {
        return {path, hash};
    }
    const auto bytes = readFile(*project.recoveryOf);
    return {*project.recoveryOf, bytes ? std::optional(contentHash(*bytes)) : std::nullopt};
}

}  // namespace

ProjectJob::ProjectJob(std::filesystem::path path, Found found, Done done, Missing missing)
    : path_(std::move(path)),
      found_(std::move(found)),
      done_(std::move(done)),
      missing_(std::move(missing)) {}

QString ProjectJob::title() const {
    return QCoreApplication::translate("ProjectJob", "Reading %1").arg(textOf(path_.filename()));
}

Result<void> ProjectJob::process(Progress& progress) {
    Result<ReadProject> read = readProject(path_);
    if (!read) {
        return read.error();
    }
    Project& project = opened_.project = std::move(read->project);
    opened_.notes = std::move(read->notes);
    opened_.known = knownOf(path_, read->hash, project);
    for (MeshReference& file : project.files) {
        if (const auto found = found_.find(file.path); found != found_.end()) {
            file.path = found->second;
        }
    }
    lost_ = locateMeshes(project);
    if (!lost_.empty()) {
        return {};
    }
    std::vector<std::filesystem::path> paths;
    for (const MeshReference& file : project.files) {
        paths.push_back(file.path);
    }
    progress.setShare(0, kProjectReadingShare);
    Result<Garment> garment = loadGarment(paths, project.loading, progress);
    if (!garment) {
        return garment.error();
    }
    const Problems differences = differencesTo(project, *garment);
    opened_.notes.insert(opened_.notes.end(), differences.begin(), differences.end());
    opened_.garment =
        sharedForDisposal(std::make_unique<const Garment>(std::move(garment).value()));
    progress.setShare(kProjectReadingShare, 1);
    opened_.scene = buildScene(*opened_.garment, {}, progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, {}, {}};
    }
    return {};
}

void ProjectJob::finalize() {
    lost_.empty() ? done_(std::move(opened_)) : missing_(lost_);
}

}  // namespace toile
