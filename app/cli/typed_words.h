// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/arguments.h"

namespace toile::app {

// For who speaks to the command line without a terminal: `toile serve`, `toile batch`, Python.

/// The code of what it refuses.
inline constexpr const char* kWrongUsage = "wrong-usage";

/// What it makes of a command, files and the words of options; a Message where it refuses them. A
/// file that begins with a dash is no option.
Arguments typedWords(const char* command, const std::vector<std::string>& files,
                     const std::vector<std::string>& words);

/// What of `flatten` is for who types it in a terminal, and would do nothing elsewhere: its files
/// to write, what it prints, its exit status. The first that was typed; null: none.
/// @param isWriting  files to write are in place
const char* wordOutOfPlace(const Arguments& typed, bool isWriting = false);
/// The sentence that refuses it.
std::string outOfPlaceSentence(std::string_view word);

/// One of its sentences without what is for a terminal: "toile: " before it, "; see toile --help."
/// behind.
std::string withoutSpeaker(std::string_view sentence);

}  // namespace toile::app
