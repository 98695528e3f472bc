// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/document_state.h"
#include "app/document/layout.h"
#include "app/jobs/job.h"
#include "core/pipeline/pipeline.h"
#include "core/project/carry_settings.h"

namespace toile {

class Document;

/// The jobs that make the document what it is. All take their snapshot when they are made; what
/// they are to call is called on the GUI thread. A document must outlive its job.

/// A garment that was read or cut, and what the views show of it until it is flat.
struct MadeGarment {
    std::shared_ptr<const Garment> garment;
    std::shared_ptr<const Scene> scene;
    std::vector<CarriedFrom> carried;  ///< what its pieces come from
};

/// Reads files as one garment.
/// @param before  with the garment that this takes the place of; without one all its pieces are new
std::unique_ptr<Job> importJob(std::vector<std::filesystem::path> files, LoadOptions options,
                               std::optional<DocumentState> before,
                               std::function<void(MadeGarment)> done);

/// Cuts and sews a garment anew, without reading it again. Pieces that stay are shown as they are.
/// @param before  with an open garment
std::unique_ptr<Job> cutJob(DocumentState before, LoadOptions options,
                            std::function<void(MadeGarment)> done);

/// The results of those pieces of a garment that were in another; null for the others.
PieceResults carriedResults(const PieceResults& results, const Garment& after);

/// Flattens every piece of the document's garment with its options, lays the pieces out and
/// prepares what both views draw. What has not changed since the last time is not solved again, and
/// every piece stays where it is on the sheet. A piece that fails leaves the others alone. Requires
/// an open garment.
std::unique_ptr<Job> flattenJob(Document& document);

/// Makes the scene of the document's present state again. Requires an open garment.
std::unique_ptr<Job> sceneJob(Document& document);

/// Finds the grain that suits each of some flat pieces best.
/// @param done  `found`: pieces without a better direction are left out. `outdated`: some was found
///              for a flattening or a fabric that is another now: left out too
std::unique_ptr<Job> grainJob(const Document& document, const std::vector<int>& pieces,
                              std::function<void(const PieceGrains& found, bool outdated)> done);

}  // namespace toile
