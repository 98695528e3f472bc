// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/flatten_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/document/document.h"
#include "app/render/scene_builder.h"

namespace toile {

FlattenJob::FlattenJob(Document& document)
    : document_(document),
      revision_(document.revision()),
      garment_(document.garment()),
      options_(document.options()) {
    Q_ASSERT(garment_);
}

QString FlattenJob::title() const {
    return QCoreApplication::translate("FlattenJob", "Flattening the pieces");
}

Result<void> FlattenJob::process(Progress& progress) {
    results_ = flattenGarment(*garment_, options_, progress);
    if (!progress.isCancelled()) {
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
