// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "app/document/shown_proof.h"
#include "app/jobs/job.h"

namespace toile::app {

class Document;

/// Where the work leaves what it has reached, for the window to fetch.
struct ProofTray {
    std::mutex mutex;
    std::shared_ptr<const ShownProof> sewing;  ///< null: fetched already
};

/// Sews the document's pattern back together, as it is now, and measures it.
/// @param tray  may be null
/// @param done  not called where that cannot be, or is cancelled
std::unique_ptr<Job> proofJob(const Document& document, const ProofPlan& plan,
                              std::shared_ptr<ProofTray> tray,
                              std::function<void(std::shared_ptr<const ShownProof>)> done);

/// Shows a proof of the document's pattern as it is now, where it has been found elsewhere: for
/// pictures. The document has a scene.
void showProof(Document& document, std::shared_ptr<const Proof> proof);

}  // namespace toile::app
