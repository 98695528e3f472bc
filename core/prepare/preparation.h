// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/wording.h"

namespace toile {

/// The possible contents of a file.
enum class FileKind {
    Sheet,   ///< a single surface without thickness: no preparation
    Shell,   ///< cloth with a thickness: two surfaces close together, joined by rims or not
    Scan,    ///< a measured surface: noise, holes, debris, uneven triangles
    Layers,  ///< sheets inside each other, like a lining in its shell
    Solid,   ///< a closed form to cover, like a cushion or a shoe
    Soup,    ///< triangles that share no vertices
};

inline constexpr Word<FileKind> kFileKindWords[] = {
    {FileKind::Sheet, "sheet"},   {FileKind::Shell, "shell"}, {FileKind::Scan, "scan"},
    {FileKind::Layers, "layers"}, {FileKind::Solid, "solid"}, {FileKind::Soup, "soup"},
};

/// The surface of a shell that becomes the sheet.
enum class ShellSurface { Outer, Inner, Middle };

inline constexpr Word<ShellSurface> kShellSurfaceWords[] = {
    {ShellSurface::Outer, "outer"},
    {ShellSurface::Inner, "inner"},
    {ShellSurface::Middle, "middle"},
};

/// Maximum of the lengths below, mm.
inline constexpr double kMaxPreparedLength = 10'000;

/// Steps of preparing a scan; lengths in mm, 0 disables a step.
struct ScanSteps {
    bool dropDebris = true;    ///< small fragments outside the garment
    double largestHole = 300;  ///< perimeter up to which holes are closed
    double smoothing = 1;      ///< how far noise may move a point, features kept
    double edgeLength = 0;     ///< of the new triangles

    bool operator==(const ScanSteps&) const = default;
};

/// The user's choices for reading files.
struct Preparation {
    std::optional<FileKind> as{};  ///< detected if empty
    ShellSurface surface = ShellSurface::Outer;
    ScanSteps scan{};
    /// Distance within which vertices of a soup are merged, mm; 0: a thousandth of the median edge.
    double weldDistance = 0;
    int onlyLayer = 0;      ///< the only layer to use, the outermost is 1; 0: all
    bool isHalf = false;    ///< half a garment: its mirror image is added
    bool isTurned = false;  ///< flip all faces, which swaps the right and wrong side of the cloth

    bool operator==(const Preparation&) const = default;
};

}  // namespace toile
