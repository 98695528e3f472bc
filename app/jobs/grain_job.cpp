// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/grain_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/document/document.h"
#include "core/quality/best_grain.h"

namespace toile {

GrainJob::GrainJob(const Document& document, std::vector<int> pieces, Done done)
    : document_(document),
      pieces_(std::move(pieces)),
      fabric_(document.fabric()),
      done_(std::move(done)) {
    for (const int piece : pieces_) {
        results_.push_back(document.results()[static_cast<std::size_t>(piece)]);
    }
}

QString GrainJob::title() const {
    return QCoreApplication::translate("GrainJob", "Looking for the best grain");
}

Result<void> GrainJob::process(Progress& progress) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled, {}, {}};
        }
        const PieceResult& result = *results_[i];
        if (const auto grain = bestGrain(result.piece->mesh, result.flat->Q, fabric_)) {
            found_[pieces_[i]] = *grain;
        }
        progress.report(static_cast<double>(i + 1) / static_cast<double>(pieces_.size()));
    }
    return {};
}

void GrainJob::finalize() {
    bool outdated = false;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        // The grain is a direction in the flat coordinates it was found in.
        const bool same =
            document_.result(pieces_[i]) == results_[i].get() && document_.fabric() == fabric_;
        outdated = (!same && found_.erase(pieces_[i]) > 0) || outdated;
    }
    done_(found_, outdated);
}

}  // namespace toile
