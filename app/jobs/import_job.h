// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/document_state.h"
#include "app/jobs/job.h"
#include "core/pipeline/pipeline.h"
#include "core/project/carry_settings.h"

namespace toile {

/// Reads files as one garment and prepares what the 3D view shows of it before it is flat.
class ImportJob : public Job {
public:
    using Done = std::function<void(std::shared_ptr<const Garment>, std::shared_ptr<const Scene>,
                                    const std::vector<CarriedFrom>&)>;

    /// @param before  with the garment that this takes the place of; without one all its pieces are
    /// new
    /// @param done    called on the GUI thread with what was read, and what its pieces come from
    ImportJob(std::vector<std::filesystem::path> files, LoadOptions options,
              std::optional<DocumentState> before, Done done);

    QString title() const override;
    Result<void> process(Progress& progress) override;
    void finalize() override;

private:
    std::vector<std::filesystem::path> files_;
    LoadOptions options_;
    std::optional<DocumentState> before_;
    Done done_;
    std::shared_ptr<const Garment> garment_;
    std::shared_ptr<const Scene> scene_;
    std::vector<CarriedFrom> carried_;
};

}  // namespace toile
