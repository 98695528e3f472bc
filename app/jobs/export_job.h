// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/jobs/job.h"
#include "core/pipeline/pipeline.h"

namespace toile {

class Document;

/// Writes the flat pieces to one file; its ending chooses the format. What it takes is a snapshot:
/// edits may go on. Cancelled, it leaves the file as it was.
class ExportJob : public Job {
public:
    using Done = std::function<void(const std::filesystem::path&)>;

    /// @param done called on the GUI thread once the file is written
    ExportJob(const Document& document, std::filesystem::path path, Done done);

    QString title() const override;
    Result<void> process(Progress& progress) override;
    void finalize() override;

private:
    std::shared_ptr<const Garment> garment_;
    PieceResults results_;
    std::vector<PieceOnSheet> places_;
    DrawingWords words_;
    std::filesystem::path path_;
    Done done_;
};

}  // namespace toile
