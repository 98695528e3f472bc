// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/jobs/job.h"
#include "core/pipeline/pipeline.h"

namespace toile {

class Document;
struct Scene;

/// Reads files as one garment and prepares what the 3D view shows of it before it is flat.
class ImportJob : public Job {
public:
    ImportJob(Document& document, std::vector<std::filesystem::path> files, LoadOptions options);

    QString title() const override;
    Result<void> process(Progress& progress) override;
    void finalize() override;

private:
    Document& document_;
    std::vector<std::filesystem::path> files_;
    LoadOptions options_;
    std::shared_ptr<const Garment> garment_;
    std::shared_ptr<const Scene> scene_;
};

}  // namespace toile
