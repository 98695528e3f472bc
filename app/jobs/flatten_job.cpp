// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/flatten_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/document/document.h"
#include "app/render/scene_builder.h"
#include "core/pipeline/garment_flattener.h"

namespace toile {

namespace {

/// Of the job's time, about, on garments of 10 000 to 100 000 triangles; the rest is laying out and
/// the scene.
constexpr double kFlatteningShare = 0.5;

}  // namespace

FlattenJob::FlattenJob(Document& document)
    : document_(document),
      revision_(document.revision()),
      garment_(document.garment()),
      options_(document.options()),
      flattener_(document.flattener()) {
    Q_ASSERT(garment_);
}

QString FlattenJob::title() const {
    return QCoreApplication::translate("FlattenJob", "Flattening the pieces");
}

Result<void> FlattenJob::process(Progress& progress) {
    progress.setShare(0, kFlatteningShare);
    results_ = flattener_->flatten(*garment_, options_, progress);
    if (!progress.isCancelled()) {
        progress.setShare(kFlatteningShare, 1);
        const LaidOutPattern pattern = layOut(*garment_, results_);
        scene_ = buildScene(*garment_, results_, pattern.offsets, progress);
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, {}, {}};
    }
    return {};
}

void FlattenJob::finalize() {
    document_.setResults(std::move(results_), std::move(scene_));
}

}  // namespace toile
