// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/wording.h"
#include "core/mesh/mesh_arrays.h"
#include "core/prepare/layers.h"
#include "core/prepare/shell.h"

namespace toile {

/// Small fragments around a garment that do not belong to it.
struct Debris {
    std::vector<int> triangles;  ///< ascending
    int fragments = 0;
    double area = 0;  ///< mm2
};

/// Finds the fragments that cannot be pattern pieces: parts connected by edges, with less than a
/// thousandth of the area of the largest and less than a fifth of its size. Parts that the user may
/// want stay: a belt or a cuff is larger, belt loops and buttons come as several of a kind, and
/// fragments that are a large share of all cloth are pieces of it. In doubt a fragment is kept,
/// since the user can exclude it. The distance of a fragment does not matter: pieces of an exploded
/// view lie far apart, too.
/// @param mesh  mm; coinciding corners are welded
/// Cost: linear, except for sorting the fragments. Pure.
Debris findDebris(const MeshArrays& mesh);

/// The detected kind of a file, with its evidence.
struct Recognition {
    FileKind kind = FileKind::Sheet;
    Wording evidence{};            ///< for display; empty for plain sheets
    std::optional<Shell> shell{};  ///< if there are two surfaces; a Shell only if rims join them
    std::optional<Layers> layers{};
};

/// Detects the contents of a file from its shape alone. In doubt the result is a sheet. Coinciding
/// vertices must be merged before, because a soup cannot be distinguished from sheets here.
/// @param progress  if cancelled, the result is a sheet
/// Cost: those of `findShell` and `findLayers`. Pure.
Recognition recognise(const FileSurface& surface, const Progress& progress);

}  // namespace toile
