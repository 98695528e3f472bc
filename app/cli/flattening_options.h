// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/cli/typed_options.h"

namespace CLI {  // NOLINT(readability-identifier-naming): its own
class App;
}  // namespace CLI

namespace toile::app {

/// Of all methods, in the order of docs/methods.md.
std::vector<std::string> methodNames();

/// By which method, and how it goes about it, each option for the methods that have the choice: the
/// commands and the window alike. @param isOne  by one of them; else whoever adds it says which
void addMethodOptions(CLI::App& command, StatedOptions& stated, bool isOne = true);
/// How outlines are drawn.
void addLineOptions(CLI::App& command, StatedOptions& stated);
/// What is added to the outlines.
/// @param hasPreset  with `--pattern`; else that word is free for a file
void addPatternOptions(CLI::App& command, StatedOptions& stated, bool hasPreset = true);
/// What stands on all labels.
void addLabelOptions(CLI::App& command, StatedOptions& stated);
/// What can be chosen of the files to write.
void addExporting(CLI::App& command, TypedOptions& typed);
/// How a garment is flattened and written, for one garment and for many: all of these and how files
/// are read.
void addFlattening(CLI::App& command, TypedOptions& typed, Arguments& arguments);

}  // namespace toile::app
