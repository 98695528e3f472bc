// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace toile::app {

/// What was typed for `toile marker`.
struct MarkerArguments {
    std::optional<int> rounds;      ///< after so many it ends
    std::optional<double> seconds;  ///< after the round in which so much time has passed
    std::uint64_t seed = 1;
    double gap = 0, border = 0;  ///< mm
    int threads = 0;             ///< 0: as the machine has
};

}  // namespace toile::app
