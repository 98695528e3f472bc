// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "app/document/layout.h"
#include "app/jobs/derivation.h"
#include "app/jobs/job.h"
#include "core/pattern/piece_grain.h"

namespace toile {
class GarmentFlattener;
}  // namespace toile

namespace toile::app {

class Document;

/// Jobs that read and derive the document. Each takes its snapshot when it is made. Callbacks run
/// on the GUI thread. A document must outlive its job.

/// Reads files from the disk.
std::unique_ptr<Job> readingJob(std::vector<std::filesystem::path> paths,
                                std::function<void(ReadFiles)> done);

/// Reads files as one garment, and makes the scene that shows it until it is flat.
std::unique_ptr<Job> importJob(std::vector<std::filesystem::path> paths, LoadOptions loading,
                               std::function<void(Derived)> done);

/// How much of the present state to derive besides its garment and scene.
struct RecomputeOrder {
    bool flatten = false;
    bool leaveOut = false;  ///< if not flattening: only remove pieces that are left out
    bool settle = false;    ///< if not flattening: replace warm results by cold ones

    bool operator==(const RecomputeOrder&) const = default;
};

/// Derives the missing results for the document's state: garment, seams, flat pieces, and the
/// content of both views. Unchanged parts are kept. A piece that fails does not affect the others.
/// Requires an open garment.
/// @param onGarment  called on the worker when another garment is made that will be flattened next
std::unique_ptr<Job> recomputeJob(const Document& document, const RecomputeOrder& order,
                                  std::shared_ptr<GarmentFlattener> flattener,
                                  std::function<void(Derivation)> onGarment,
                                  std::function<void(Derivation)> done);

/// Shares of the flat cloth of some pieces that are beyond the limits of the fabric, with the grain
/// as it was and as it was found; 0 if not computed.
struct GrainShares {
    double before = 0, after = 0;
};

/// Finds the grain of some flat pieces by a rule.
/// @param done  `found`: without pieces that have no such grain. `outdated`: some grain was omitted
///              because its flattening or fabric has changed since. `shares`: for LeastStrain only
std::unique_ptr<Job> grainJob(
    const Document& document, GrainRule rule, const std::vector<int>& pieces,
    std::function<void(const PieceGrains& found, bool outdated, const GrainShares& shares)> done);

}  // namespace toile::app
