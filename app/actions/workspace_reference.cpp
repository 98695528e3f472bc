// SPDX-License-Identifier: GPL-3.0-or-later
// The pattern that the pieces are compared with.
#include <utility>

#include "app/actions/workspace.h"
#include "app/jobs/file_jobs.h"

namespace toile::app {

void Workspace::openReference(const std::filesystem::path& path) {
    if (!document_.garment() || opening_.isActive()) {
        return;
    }
    startReading(referenceJob(path, [this](ReferenceFile read) {
        reading_ = 0;
        DocumentState next = document_.state();
        next.reference = std::move(read);
        document_.setView(&ViewState::referencePanels, true);  // who opens it wants to see it
        document_.edit(tr("Reference pattern"), std::move(next));
        follow();
    }));
}

void Workspace::closeReference() {
    DocumentState next = document_.state();
    next.reference = {};
    document_.edit(tr("No reference pattern"), std::move(next));
}

}  // namespace toile::app
