// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/export/export_source.h"
#include "core/export/format_options.h"
#include "core/export/read_back.h"

namespace toile {

/// The one table of what Toile writes: the command line's help, the dialogs, docs/exports.md and
/// the tests are made from it.

/// A file of an export: the one asked for, or one beside it.
struct ExportedFile {
    /// What takes the place of the ending: empty of the one asked for; ".rul", "-front.obj".
    std::string beside{};
    std::string bytes{};
};

using ExportedFiles = std::vector<ExportedFile>;  ///< the one asked for first

enum class FormatId { Svg, Dxf, Pdf, Plt, Png, Obj, Usd, Glb, GarmentCode, Html, Csv, Report };

struct Format {
    FormatId id;
    const char* name;                      ///< "DXF drawing", English, to be translated
    const char* use;                       ///< what for, in a few words, likewise
    std::span<const char* const> endings;  ///< lower case, with the dot; the first is the usual one
    /// What it can carry.
    bool layers = false, trueScale = false, curves = false, pages = false;
    /// Errors: what cannot be written, for example what no page can hold. Null: needs the window's
    /// libraries, and this build has none (`provideWriter`).
    Result<ExportedFiles> (*write)(const ExportSource&) = nullptr;
    /// Reads the files again by code of its own and compares them with what they were made from.
    /// Errors: NotReadBack. Null: the file is not read when it is written. (Readers of PDF, HPGL,
    /// USD and GLB files are among the tests: tests/core/readers.)
    Result<ReadBack> (*readBack)(const ExportedFiles&, const ExportSource&) = nullptr;
};

/// In the order of dialogs and help.
std::span<const Format> formats();
const Format& formatOf(FormatId id);

/// The longest ending of a format that a file's name ends in, in any case; empty where none does.
std::string_view endingOf(const std::filesystem::path& path);

/// By that ending; null where there is none.
const Format* formatOf(const std::filesystem::path& path);

/// Gives a format the writer that the core has not. Not thread-safe: once, before anything is
/// written.
void provideWriter(FormatId id, Result<ExportedFiles> (*write)(const ExportSource&));

/// ".svg, .dxf or .json": the usual endings of what this build writes.
std::string writtenEndings();

}  // namespace toile
