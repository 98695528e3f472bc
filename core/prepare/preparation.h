// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/words.h"

namespace toile {

/// What a file may hold.
enum class FileKind {
    Sheet,   ///< cloth as one surface without thickness: nothing to be done
    Shell,   ///< cloth with a thickness: two surfaces a little apart, joined by rims or not
    Scan,    ///< a measured surface: noise, holes, debris, uneven triangles
    Layers,  ///< sheets one inside the other, as a lining in its shell
    Solid,   ///< a form that is to be covered, as a cushion or a shoe
    Soup,    ///< triangles that share no vertices
};

inline constexpr Word<FileKind> kFileKindWords[] = {
    {FileKind::Sheet, "sheet"},   {FileKind::Shell, "shell"}, {FileKind::Scan, "scan"},
    {FileKind::Layers, "layers"}, {FileKind::Solid, "solid"}, {FileKind::Soup, "soup"},
};

/// Which surface of a shell becomes the sheet.
enum class ShellSurface { Outer, Inner, Middle };

inline constexpr Word<ShellSurface> kShellSurfaceWords[] = {
    {ShellSurface::Outer, "outer"},
    {ShellSurface::Inner, "inner"},
    {ShellSurface::Middle, "middle"},
};

/// Of the lengths below, the greatest that may be said, mm.
inline constexpr double kMaxPreparedLength = 10'000;

/// What is done with a scan; lengths in mm, 0: not done.
struct ScanSteps {
    bool dropDebris = true;    ///< fragments that are small and no part of the garment
    double largestHole = 300;  ///< perimeter up to which holes are closed
    double smoothing = 1;      ///< how far noise may move a point, features kept
    double edgeLength = 0;     ///< of the triangles that it is made anew of

    bool operator==(const ScanSteps&) const = default;
};

/// What a person has said of how files are to be read.
struct Preparation {
    std::optional<FileKind> as{};  ///< recognised where not said
    ShellSurface surface = ShellSurface::Outer;
    ScanSteps scan{};
    /// Within which vertices of a soup become one, mm; 0: a thousandth of the median edge.
    double weldDistance = 0;
    int onlyLayer = 0;      ///< of layers, which alone is taken, from the outermost, 1; 0: all
    bool isHalf = false;    ///< half a garment: its mirror image is added
    bool isTurned = false;  ///< turn all faces: the other side of the cloth is the right one

    bool operator==(const Preparation&) const = default;
};

}  // namespace toile
