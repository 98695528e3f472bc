// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/typed_options.h"

namespace CLI {  // NOLINT(readability-identifier-naming): its own
class App;
}  // namespace CLI

namespace toile::app {

// Each adds a command with its options, in the order in which its help lists them.

// making_commands.cpp
void addFlatten(CLI::App& app, TypedOptions& typed, Arguments& arguments);
void addBatch(CLI::App& app, TypedOptions& typed, Arguments& arguments);
void addMarker(CLI::App& app, TypedOptions& typed, Arguments& arguments);
void addRender(CLI::App& app, TypedOptions& typed, Arguments& arguments);
void addServe(CLI::App& app, Arguments& arguments);

// checking_commands.cpp
void addCompare(CLI::App& app, TypedOptions& typed, Arguments& arguments);
void addCheck(CLI::App& app, Arguments& arguments);
void addWalk(CLI::App& app, Arguments& arguments);
void addProve(CLI::App& app, TypedOptions& typed, Arguments& arguments);
void addInfo(CLI::App& app, TypedOptions& typed, Arguments& arguments);

/// A command, with the files that each of them takes.
CLI::App& addCommand(CLI::App& app, Arguments& arguments, Arguments::Command command,
                     const std::string& word, const std::string& help);
/// From when on the exit status is that of a failure.
void addFailOn(CLI::App& command, Arguments& arguments);
/// What the garment is cut from.
void addFabric(CLI::App& command, Arguments& arguments, const std::string& help);

}  // namespace toile::app
