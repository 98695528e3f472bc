// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/units.h"
#include "core/prove/proof.h"

namespace toile::app {

/// What was typed for `toile prove`, beside the pattern's file.
struct ProveArguments {
    std::optional<FileUnit> patternUnit{};  ///< of the pattern's file
    bool isReference = false;               ///< the designer's panels in its place
    std::filesystem::path body{};           ///< what the cloth is worn on
    std::optional<FileUnit> bodyUnit{};
    double scale = 1;  ///< of the pattern
    double sewn = 1;   ///< of pictures: the garment from as designed, 0, to as sewn, 1
    int rounds = 0;    ///< in which the pattern is improved; 0: it is not
    ProofSettings settings{};
    std::filesystem::path report{};
};

}  // namespace toile::app
