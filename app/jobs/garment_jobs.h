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

/// The jobs that make the document what it is. All take their snapshot when they are made; what
/// they are to call is called on the GUI thread. A document must outlive its job.

/// Reads files as they are on the disk now.
std::unique_ptr<Job> readingJob(std::vector<std::filesystem::path> paths,
                                std::function<void(ReadFiles)> done);

/// Reads files as one garment, with what the views show of it until it is flat.
std::unique_ptr<Job> importJob(std::vector<std::filesystem::path> paths, LoadOptions loading,
                               std::function<void(Derived)> done);

/// How far the present state is to be worked out; its garment and its scene always are.
struct RecomputeOrder {
    bool flatten = false;
    bool leaveOut = false;  ///< where not flattened: what is left out goes, and nothing else
    bool settle = false;    ///< where not flattened: with cold results in the place of warm ones

    bool operator==(const RecomputeOrder&) const = default;
};

/// Works out what follows from the document's state and is not there yet: garment, seams, flat
/// pieces, and what both views draw. What has not changed is not done again. A piece that fails
/// leaves the others alone. Requires an open garment.
/// @param onGarment  called on the worker as soon as there is another garment that is going to be
///                   flattened: what comes then is about that
std::unique_ptr<Job> recomputeJob(const Document& document, const RecomputeOrder& order,
                                  std::shared_ptr<GarmentFlattener> flattener,
                                  std::function<void(Derivation)> onGarment,
                                  std::function<void(Derivation)> done);

/// Parts of the flat cloth of some pieces that lie beyond the fabric, with the grain as it was and
/// as it was found; 0 where that was not asked.
struct GrainShares {
    double before = 0, after = 0;
};

/// Finds the grain of some flat pieces by a rule.
/// @param done  `found`: pieces for which there is none are left out. `outdated`: some was found
///              for a flattening or a fabric that is another now: left out too. `shares`: of
///              LeastStrain only
std::unique_ptr<Job> grainJob(
    const Document& document, GrainRule rule, const std::vector<int>& pieces,
    std::function<void(const PieceGrains& found, bool outdated, const GrainShares& shares)> done);

}  // namespace toile::app
