// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/arguments.h"

namespace toile::app {

// For who speaks to the command line without a terminal: `toile serve`, `toile batch`, Python.

/// What it makes of a command, files and the words of options; a Message where it refuses them. A
/// file that begins with a dash is no option.
/// @param taken  of `OptionGroup`, what may be said here
Arguments typedWords(const char* command, const std::vector<std::string>& files,
                     const std::vector<std::string>& words, unsigned taken);

/// One of its sentences without what is for a terminal: "toile: " before it, "; see toile flatten
/// --help." behind.
std::string withoutSpeaker(std::string_view sentence);

}  // namespace toile::app
