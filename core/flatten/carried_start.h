// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

struct FlatteningMemory;
struct Piece;

/// A start for the isometric descent from the flat positions of an earlier version: they are
/// carried over vertex by vertex, the outline is moved to the new lengths, and the interior follows
/// harmonically, which mends what moving the outline alone would fold.
/// @param memory  with the positions; its factor is used, and replaced where it does not suit
/// @return positions without flipped triangles and with exact boundary lengths; nothing where that
///         does not come out, where they are strained much more than before the edit, or cancelled
/// Cost: a factor's edit, two back-substitutions, some linear passes.
std::optional<Points2> carriedStart(const Piece& piece, FlatteningMemory& memory,
                                    const Progress& progress);

}  // namespace toile
