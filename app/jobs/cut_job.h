// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "app/document/document_state.h"
#include "app/jobs/job.h"
#include "core/pipeline/pipeline.h"
#include "core/project/carry_settings.h"

namespace toile {

/// Cuts and sews a garment anew, without reading it again, and prepares what the views show of it
/// until the pieces that have changed are flat; the others stay as they are.
class CutJob : public Job {
public:
    using Done = std::function<void(std::shared_ptr<const Garment>, std::shared_ptr<const Scene>,
                                    const std::vector<CarriedFrom>&)>;

    /// @param before  with an open garment; the results of pieces that stay are shown
    /// @param done    called on the GUI thread with the new garment, and what its pieces come from
    CutJob(DocumentState before, LoadOptions options, Done done);

    QString title() const override;
    Result<void> process(Progress& progress) override;
    void finalize() override;

private:
    DocumentState before_;
    LoadOptions options_;
    Done done_;
    std::shared_ptr<const Garment> cut_;
    std::shared_ptr<const Scene> scene_;
    std::vector<CarriedFrom> carried_;
};

/// The results of those pieces of a garment that were in another; null for the others.
PieceResults carriedResults(const PieceResults& results, const Garment& after);

}  // namespace toile
