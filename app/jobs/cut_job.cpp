// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/cut_job.h"

#include <QCoreApplication>
#include <algorithm>
#include <unordered_map>
#include <utility>

#include "app/document/disposal.h"
#include "app/render/scene_builder.h"

namespace toile {
namespace {

/// Of the job's time, about; the rest is the scene.
constexpr double kCuttingShare = 0.8;

}  // namespace

PieceResults carriedResults(const PieceResults& results, const Garment& after) {
    std::unordered_map<const Piece*, std::shared_ptr<const PieceResult>> known;
    for (const auto& result : results) {
        if (result) {
            known.emplace(result->piece.get(), result);
        }
    }
    PieceResults carried;
    for (const auto& piece : after.pieces) {
        const auto found = known.find(piece.get());
        carried.push_back(found == known.end() ? nullptr : found->second);
    }
    return carried;
}

CutJob::CutJob(DocumentState before, LoadOptions options, Done done)
    : before_(std::move(before)), options_(std::move(options)), done_(std::move(done)) {}

QString CutJob::title() const {
    return QCoreApplication::translate("CutJob", "Cutting the pieces");
}

Result<void> CutJob::process(Progress& progress) {
    progress.setShare(0, kCuttingShare);
    Result<Garment> garment = cutGarment(*before_.garment, options_, progress);
    if (!garment) {
        return garment.error();
    }
    cut_ = sharedForDisposal(std::make_unique<const Garment>(std::move(garment).value()));
    carried_ = carriedFrom(*before_.garment, before_.settings, before_.results, *cut_);
    progress.setShare(kCuttingShare, 1);
    scene_ = buildScene(*cut_, carriedResults(before_.results, *cut_), progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, {}, {}};
    }
    return {};
}

void CutJob::finalize() {
    done_(std::move(cut_), std::move(scene_), carried_);
}

}  // namespace toile
