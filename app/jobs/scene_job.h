// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/document/document_state.h"
#include "app/jobs/job.h"

namespace toile {

class Document;

/// Makes the scene of the document's present state again.
class SceneJob : public Job {
public:
    /// Takes its snapshot here. Requires an open garment.
    explicit SceneJob(Document& document);

    QString title() const override;
    Result<void> process(Progress& progress) override;
    void finalize() override;

private:
    Document& document_;
    std::shared_ptr<const Garment> garment_;
    PieceResults results_;
    std::shared_ptr<const Scene> scene_;
};

}  // namespace toile
