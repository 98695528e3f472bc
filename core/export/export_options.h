// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

namespace toile {

/// What can be chosen of each format. Typed, remembered and shown by the names of their rows in
/// format_options.h.

/// docs/exports.md says what each holds.
enum class DxfProfile { Astm, Aama, Plain };

struct DxfOptions {
    DxfProfile profile = DxfProfile::Astm;
    LengthUnit unit = LengthUnit::Millimetre;
    bool ruleTable = false;     ///< a one-size .rul beside the file
    bool controlPiece = false;  ///< the check square as a piece of its own, in Astm and Aama

    bool operator==(const DxfOptions&) const = default;
};

/// What a PDF file is to be laid out for.
enum class Paper { A4, Letter, Shared, A0, ArchD, ArchE, Roll610, Roll841, Roll914, Projector };

struct PdfOptions {
    Paper paper = Paper::A4;
    double overlap = 10;  ///< of neighbouring tiles, mm

    bool operator==(const PdfOptions&) const = default;
};

/// For whom an SVG file is.
enum class SvgPreset { Inkscape, Illustrator, Silhouette, Laser, Cricut };
enum class SvgGroups { Kind, Piece };

struct SvgOptions {
    SvgPreset preset = SvgPreset::Inkscape;
    SvgGroups groups = SvgGroups::Kind;
    bool textAsPaths = false;

    bool operator==(const SvgOptions&) const = default;
};

struct PltOptions {
    bool turned = false;  ///< by a quarter: x along the roll

    bool operator==(const PltOptions&) const = default;
};

struct PngOptions {
    double dpi = 150;

    bool operator==(const PngOptions&) const = default;
};

/// Of the formats of 3D programs.
struct MeshOptions {
    bool isExact = false;    ///< the pattern with its outlines as they were solved, not as drawn
    bool eachPiece = false;  ///< OBJ: a file for each piece beside that of the garment

    bool operator==(const MeshOptions&) const = default;
};

struct ExportOptions {
    DxfOptions dxf{};
    PdfOptions pdf{};
    SvgOptions svg{};
    PltOptions plt{};
    PngOptions png{};
    MeshOptions mesh{};

    bool operator==(const ExportOptions&) const = default;
};

}  // namespace toile
