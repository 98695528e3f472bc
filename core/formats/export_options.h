// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

namespace toile {

/// The options of each format. The rows of format_options.h give the names used in settings, the
/// command line and dialogs.

/// See docs/exports.md for the contents of each.
enum class DxfProfile { Astm, Aama, Plain };

struct DxfOptions {
    DxfProfile profile = DxfProfile::Astm;
    LengthUnit unit = LengthUnit::Millimetre;
    bool ruleTable = false;     ///< an additional one-size .rul file
    bool controlPiece = false;  ///< the check square as a separate piece, in Astm and Aama

    bool operator==(const DxfOptions&) const = default;
};

/// The page layout of a PDF file.
enum class Paper { A4, Letter, Shared, A0, ArchD, ArchE, Roll610, Roll841, Roll914, Projector };

struct PdfOptions {
    Paper paper = Paper::A4;
    double overlap = 10;  ///< of neighbouring tiles, mm

    bool operator==(const PdfOptions&) const = default;
};

/// The target program of an SVG file.
enum class SvgPreset { Inkscape, Illustrator, Silhouette, Laser, Cricut };
enum class SvgGroups { Kind, Piece };

struct SvgOptions {
    SvgPreset preset = SvgPreset::Inkscape;
    SvgGroups groups = SvgGroups::Kind;
    bool textAsPaths = false;

    bool operator==(const SvgOptions&) const = default;
};

struct PltOptions {
    bool turned = false;  ///< by a quarter turn: x along the roll

    bool operator==(const PltOptions&) const = default;
};

struct PngOptions {
    double dpi = 150;

    bool operator==(const PngOptions&) const = default;
};

/// Options of the formats of 3D programs.
struct MeshOptions {
    bool isExact = false;    ///< the pattern with its solved outlines instead of the drawn ones
    bool eachPiece = false;  ///< OBJ: adds a file for each piece

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
