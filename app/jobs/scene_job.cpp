// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/scene_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/document/document.h"
#include "app/render/scene_builder.h"

namespace toile {

SceneJob::SceneJob(Document& document)
    : document_(document), garment_(document.garment()), results_(document.results()) {
    Q_ASSERT(garment_);
}

QString SceneJob::title() const {
    return QCoreApplication::translate("SceneJob", "Drawing the pieces");
}

Result<void> SceneJob::process(Progress& progress) {
    scene_ = buildScene(*garment_, results_, progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, {}, {}};
    }
    return {};
}

void SceneJob::finalize() {
    if (document_.garment() == garment_ && document_.results() == results_) {
        document_.setScene(std::move(scene_));
    }
}

}  // namespace toile
