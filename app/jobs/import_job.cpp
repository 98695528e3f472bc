// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/import_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/base/path_text.h"
#include "app/document/disposal.h"
#include "app/render/scene_builder.h"

namespace toile {

namespace {

/// Of the job's time, about, on garments of 10 000 to 100 000 triangles; the rest is the scene.
constexpr double kReadingShare = 0.97;

}  // namespace

ImportJob::ImportJob(std::vector<std::filesystem::path> files, LoadOptions options,
                     std::optional<DocumentState> before, Done done)
    : files_(std::move(files)),
      options_(std::move(options)),
      before_(std::move(before)),
      done_(std::move(done)) {}

QString ImportJob::title() const {
    const QString name = files_.empty() ? QString() : textOf(files_.front().filename());
    return QCoreApplication::translate("ImportJob", "Reading %1").arg(name);
}

Result<void> ImportJob::process(Progress& progress) {
    progress.setShare(0, kReadingShare);
    Result<Garment> garment = loadGarment(files_, options_, progress);
    if (!garment) {
        return garment.error();
    }
    garment_ = sharedForDisposal(std::make_unique<const Garment>(std::move(garment).value()));
    if (before_) {
        carried_ = carriedFrom(*before_->garment, before_->settings, before_->results, *garment_);
    }
    progress.setShare(kReadingShare, 1);
    scene_ = buildScene(*garment_, {}, progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, {}, {}};
    }
    return {};
}

void ImportJob::finalize() {
    done_(std::move(garment_), std::move(scene_), carried_);
}

}  // namespace toile
