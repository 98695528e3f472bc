// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/arguments.h"

namespace toile::app {

// Options that several commands share: each function adds one or more sections of the help.

/// How files are read, divided and cut open: the commands and the window.
void describeReading(OptionArchive& at, Arguments& arguments);
/// The flattening method and its settings. @param isOne  false: the command has its own way to
/// choose methods
void describeMethod(OptionArchive& at, FlattenOptions& options, bool isOne = true);
/// How outlines are drawn, and what is added to them.
/// @param hasPreset  with `--pattern`; false: the command uses that name for a file
void describeLines(OptionArchive& at, LineSettings& lines, bool hasPreset = true);
/// Symmetric pieces by half. After `describeLines`, whose mirroring it may turn on.
void describeHalf(OptionArchive& at, Arguments& arguments);
/// The texts on all labels.
void describeLabels(OptionArchive& at, LineSettings& lines);
/// The options of file formats.
void describeExporting(OptionArchive& at, ExportOptions& options);
/// Everything about flattening and writing a garment, for one and for many.
void describeFlattening(OptionArchive& at, Arguments& arguments);

/// Of all methods, in the order of docs/methods.md.
Words methodNames();
/// "mm", "25.4mm". @return as `Option::read`
Option& describeUnit(OptionArchive& at, const char* names, std::optional<FileUnit>& unit,
                     const char* help);
/// One to `numbers.size()` numbers with commas between them, each within its range.
/// @return how many are typed, or a fault as `Option::read`
struct ReadNumbers {
    std::size_t count = 0;
    std::string fault{};
};
ReadNumbers readNumbers(const std::string& typed, std::span<const Range> ranges,
                        std::span<double> numbers);

}  // namespace toile::app
