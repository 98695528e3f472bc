// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

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

inline constexpr int kFileKinds = 6;

/// Which surface of a shell becomes the sheet.
enum class ShellSurface { Outer, Inner, Middle };

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

    bool operator==(const Preparation&) const = default;
};

}  // namespace toile
