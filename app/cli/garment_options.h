// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/arguments.h"

namespace toile::app {

// Options shared by several commands: each function adds one or more sections to the help.

/// How files are read, divided and cut open: the commands and the window.
void describeReading(OptionArchive& at, Arguments& arguments);
/// The flattening method and its settings. @param isOne  false: the command selects methods by its
/// own options
void describeMethod(OptionArchive& at, FlattenOptions& options, bool isOne = true);
/// Options for drawing outlines and adding to them.
/// @param hasPreset  whether to add `--pattern`; false: the command uses that name for a file
void describeLines(OptionArchive& at, LineSettings& lines, bool hasPreset = true);
/// Symmetric pieces by half. After `describeLines`, whose mirroring it may turn on.
void describeHalf(OptionArchive& at, Arguments& arguments);
/// The texts on all labels.
void describeLabels(OptionArchive& at, LineSettings& lines);
/// The options of file formats.
void describeExporting(OptionArchive& at, ExportOptions& options);
/// Everything for flattening and writing garments.
void describeFlattening(OptionArchive& at, Arguments& arguments);

/// The names of all methods, in the order of docs/methods.md.
Words methodNames();
/// "mm", "25.4mm". @return as `Option::read`
Option& describeUnit(OptionArchive& at, const char* names, std::optional<FileUnit>& unit,
                     const char* help);
/// Result of parsing 1 to `numbers.size()` comma-separated numbers, each checked against its range.
/// @return the number of values, or a fault as `Option::read`
struct ReadNumbers {
    std::size_t count = 0;
    std::string fault{};
};
ReadNumbers readNumbers(const std::string& typed, std::span<const Range> ranges,
                        std::span<double> numbers);

}  // namespace toile::app
