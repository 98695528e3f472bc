// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/compare_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/render/scene_builder.h"

namespace toile {

namespace {

/// Of the job's time, about.
constexpr double kComparingShare = 0.8;

}  // namespace

CompareJob::CompareJob(Order order, Done done)
    : order_(std::move(order)), results_(order_.known), done_(std::move(done)) {}

QString CompareJob::title() const {
    return QCoreApplication::translate("CompareJob", "Comparing methods");
}

void CompareJob::flattenMissing(Progress& progress) {
    std::vector<int> needed = sewnTo(*order_.garment, order_.piece);
    needed.push_back(order_.piece);
    std::erase_if(
        needed, [this](int piece) { return results_[static_cast<std::size_t>(piece)] != nullptr; });
    Garment part;  // flattening looks at the pieces alone
    for (const int piece : needed) {
        part.pieces.push_back(order_.garment->pieces[static_cast<std::size_t>(piece)]);
    }
    PieceResults found = flattenGarment(part, order_.options, progress);
    for (std::size_t i = 0; i < needed.size(); ++i) {
        results_[static_cast<std::size_t>(needed[i])] = std::move(found[i]);
    }
}

Result<void> CompareJob::process(Progress& progress) {
    progress.setShare(0, kComparingShare);
    flattenMissing(progress);
    if (!progress.isCancelled()) {
        progress.setShare(kComparingShare, 1);
        made_.result = results_[static_cast<std::size_t>(order_.piece)];
        made_.figures = comparedPiece(*order_.garment, results_, order_.piece);
        if (made_.result->flat) {
            Garment alone;
            alone.pieces = {made_.result->piece};
            made_.scene = buildScene(alone, {made_.result}, progress);
        }
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, {}, {}};
    }
    return {};
}

void CompareJob::finalize() {
    done_(std::move(made_), results_);
}

}  // namespace toile
