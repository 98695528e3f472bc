// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/units.h"
#include "core/prove/proof_settings.h"

namespace toile::app {

/// What was typed for `toile prove`, beside the pattern's file.
struct ProveArguments {
    std::optional<FileUnit> patternUnit{};  ///< of the pattern's file
    ProofPlan typed{};                      ///< as far as it was typed: see `proofPlanOf`
    /// What of it was typed: each takes it over into what a project says.
    std::vector<void (*)(const ProofPlan& typed, ProofPlan& plan)> stated{};
    double scale = 1;  ///< of the pattern
    double sewn = 1;   ///< of pictures: the garment from as designed, 0, to as sewn, 1
    int rounds = 0;    ///< in which the pattern is improved; 0: it is not
    std::filesystem::path report{};
};

/// What is typed for `ProofPlan::body` where it is none, whatever a project says.
inline constexpr const char* kNoBody = "none";

}  // namespace toile::app
