// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace toile::app {

/// The words after the program's name, with those who ask for help as they ask of other programs
/// led to it: `help` is `--help`, and `help flatten` is `flatten --help`.
std::vector<std::string> wordsAfterProgram(int argc, const char* const* argv);

/// What is said of a first word that is no option, no command and no garment that could be opened,
/// by its ending or as there is such a file; with the command that is probably meant. Empty where
/// it is one. Without a full stop. Cost: at most one look at the disk.
std::string unknownFirstWord(const std::vector<std::string>& words,
                             const std::vector<std::string>& commands);

}  // namespace toile::app
