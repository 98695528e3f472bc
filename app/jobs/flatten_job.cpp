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
      flattener_(document.state().letGo ? std::make_shared<GarmentFlattener>()
                                        : document.flattener()),
      before_(document.results()) {
    Q_ASSERT(garment_);
}

QString FlattenJob::title() const {
    return QCoreApplication::translate("FlattenJob", "Flattening the pieces");
}

Result<void> FlattenJob::process(Progress& progress) {
    progress.setShare(0, kFlatteningShare);
    results_ = flattener_->flatten(*garment_, options_, progress);
    keepWhatFits();
    if (!progress.isCancelled()) {
        progress.setShare(kFlatteningShare, 1);
        motions_ = flatMotions(before_, results_);
        proposed_ = layOut(*garment_, results_).offsets;
        scene_ = buildScene(*garment_, results_, progress);
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, {}, {}};
    }
    return {};
}

void FlattenJob::keepWhatFits() {
    // After steps back and forth the flattener comes from another version of the garment: what it
    // finds is as good, but not the same to the last bit.
    for (std::size_t i = 0; i < results_.size() && i < before_.size(); ++i) {
        const PieceResult* known = before_[i].get();
        if (known && known->flat && known->piece == garment_->pieces[i] &&
            known->options == options_) {
            results_[i] = before_[i];
        }
    }
}

void FlattenJob::finalize() {
    // Places that were given meanwhile are kept.
    std::vector<PieceSettings> settings =
        placedSettings(document_.settings(), results_, motions_, proposed_);
    document_.setResults(std::move(results_), std::move(scene_), std::move(settings));
}

}  // namespace toile
