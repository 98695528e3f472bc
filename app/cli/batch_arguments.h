// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace toile::app {

/// What was typed for `toile batch`.
struct BatchArguments {
    std::filesystem::path list{};                     ///< a garment a line; "-": standard input
    std::filesystem::path folder{};                   ///< where everything goes
    std::vector<std::string> formats{"json", "svg"};  ///< endings without their dot
    double limitSeconds = 600;                        ///< of the clock, for a garment; 0: none
    int memoryMib = 0;                                ///< for a garment; 0: as there is
    int threads = 1;                                  ///< that one garment may use
    /// How garments are read and flattened: the options of flatten, each with its value, in the
    /// order of the help. The same options typed in another order are the same words.
    std::vector<std::string> words{};
};

}  // namespace toile::app
