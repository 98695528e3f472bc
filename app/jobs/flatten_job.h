// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/jobs/job.h"
#include "core/pipeline/pipeline.h"
#include "core/project/place_pieces.h"

namespace toile {

class Document;
class GarmentFlattener;
struct Scene;

/// Flattens every piece of the document's garment with its options, lays the pieces out and
/// prepares what both views draw. What has not changed since the last time is not solved again, and
/// every piece stays where it is on the sheet. A piece that fails leaves the others alone.
class FlattenJob : public Job {
public:
    /// Takes its snapshot here. Requires an open garment.
    explicit FlattenJob(Document& document);

    QString title() const override;
    std::optional<std::uint64_t> revision() const override { return revision_; }
    Result<void> process(Progress& progress) override;
    void finalize() override;

private:
    /// Pieces that are flat already keep their very positions.
    void keepWhatFits();

    Document& document_;
    std::uint64_t revision_;
    std::shared_ptr<const Garment> garment_;
    FlattenOptions options_;
    std::shared_ptr<GarmentFlattener> flattener_;
    PieceResults before_;  ///< of the same pieces, as far as there are any
    PieceResults results_;
    std::vector<std::optional<FlatMotion>> motions_;
    std::vector<Eigen::Vector2d> proposed_;  ///< offsets, per piece
    std::shared_ptr<const Scene> scene_;
};

}  // namespace toile
