// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/formats/export_source.h"
#include "core/formats/format_options.h"
#include "core/formats/read_back.h"

namespace toile {

/// The table of all output formats. The command line's help, the dialogs, docs/exports.md and the
/// tests are made from it.

/// A file of an export: the requested file, or an additional one.
struct ExportedFile {
    /// Replaces the ending: empty for the requested file; ".rul", "-front.obj".
    std::string beside{};
    std::string bytes{};
};

using ExportedFiles = std::vector<ExportedFile>;  ///< the requested one first

enum class FormatId { Svg, Dxf, Pdf, Plt, Png, Obj, Usd, Glb, GarmentCode, Html, Csv, Report };

struct Format {
    FormatId id;
    const char* name;                      ///< "DXF drawing", English, to be translated
    const char* use;                       ///< its purpose in a few words, likewise
    std::span<const char* const> endings;  ///< lower case, with the dot; the first is the usual one
    /// The features of the format.
    bool layers = false, trueScale = false, curves = false, pages = false;
    /// Errors: content that the format cannot hold, for example too large for a page. Null: needs
    /// the window's libraries, which this build lacks (`provideWriter`).
    Result<ExportedFiles> (*write)(const ExportSource&) = nullptr;
    /// Reads the files with independent code and compares them with their source. Errors:
    /// NotReadBack. Null: the file is not read back. (Readers of PDF, HPGL, USD and GLB files are
    /// among the tests: tests/core/readers.)
    Result<ReadBack> (*readBack)(const ExportedFiles&, const ExportSource&) = nullptr;
};

/// In the order of dialogs and help.
std::span<const Format> formats();
const Format& formatOf(FormatId id);

/// The longest ending of a format that matches a file's name, in any case; empty if none does.
std::string_view endingOf(const std::filesystem::path& path);

/// The format of that ending; null if there is none.
const Format* formatOf(const std::filesystem::path& path);

/// Provides the writer of a format that the core lacks. Not thread-safe: call it once, before any
/// export.
void provideWriter(FormatId id, Result<ExportedFiles> (*write)(const ExportSource&));

/// ".svg, .dxf or .json": the usual endings of the formats of this build.
std::string writtenEndings();

}  // namespace toile
