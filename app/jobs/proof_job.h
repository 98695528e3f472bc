// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "app/base/worker.h"
#include "app/document/shown_proof.h"
#include "app/jobs/job.h"

namespace toile::app {

class Document;

/// Sews the document's pattern back together as it is now, and measures it.
/// @param mailbox  gets the cloth while it is sewn; may be null
/// @param done  not called if that is impossible or cancelled
std::unique_ptr<Job> proofJob(const Document& document, const ProofPlan& plan,
                              std::shared_ptr<Mailbox<ShownProof>> mailbox,
                              std::function<void(std::shared_ptr<const ShownProof>)> done);

/// Shows a proof of the present pattern that was made elsewhere: for pictures. Requires a scene.
void showProof(Document& document, std::shared_ptr<const Proof> proof);

}  // namespace toile::app
