// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/document/layout.h"
#include "app/jobs/job.h"
#include "core/flatten/piece_result.h"
#include "core/garment/fabric.h"

namespace toile {

/// Finds the grain that suits each of some pieces best.
class GrainJob : public Job {
public:
    /// @param found     pieces without a better direction are left out
    /// @param outdated  some was found for a flattening or a fabric that is another now: left out
    ///                  too
    using Done = std::function<void(const PieceGrains& found, bool outdated)>;

    /// Takes its snapshot here. `document` must outlive the job.
    /// @param pieces  flat ones
    /// @param done    called on the GUI thread
    GrainJob(const Document& document, std::vector<int> pieces, Done done);

    QString title() const override;
    Result<void> process(Progress& progress) override;
    void finalize() override;

private:
    const Document& document_;  ///< not for the worker
    std::vector<int> pieces_;
    PieceResults results_;  ///< of the pieces
    Fabric fabric_;
    PieceGrains found_;
    Done done_;
};

}  // namespace toile
