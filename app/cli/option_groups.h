// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "app/cli/arguments.h"

namespace CLI {  // NOLINT(readability-identifier-naming): its own
class App;
class Option;
}  // namespace CLI

namespace toile::app {

/// What the options of commands are about, noted where they are added. What is not is for a
/// terminal.
using OptionGroups = std::map<const CLI::Option*, OptionGroup>;

/// Notes it of all that has been added to a command since this was last said.
void areAbout(OptionGroup group, const CLI::App& command, OptionGroups& groups);

/// Why an option has no place where others are asked for.
std::string outOfPlace(const std::string& option, unsigned group);

/// The same of the first option that was typed and is not taken; empty: all are. Files to read are
/// for whoever knows how many there are to be.
/// @param taken  of `OptionGroup`
std::string wordNotTaken(const CLI::App& app, const OptionGroups& groups, unsigned taken);

}  // namespace toile::app
