// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/render/scene.h"
#include "core/pipeline/pipeline.h"

namespace toile {

/// The lines of a scene whose pieces are there already (`buildScene`). Pure.

/// Both sides of every seam and free edge, in space and, where flat, in the pattern; their boxes.
/// @param results one per piece, or empty. Cost: linear in the outlines, for every seam.
void addSeamLines(const Garment& garment, const PieceResults& results, Scene& scene);

/// The outline of every piece that is a disk.
void addOutlines(const Garment& garment, const PieceResults& results, Scene& scene);

/// Outline and holes of the designer's panels, laid on the flat pieces that carry one.
void addDesignerLines(const Garment& garment, const PieceResults& results, Scene& scene);

}  // namespace toile
