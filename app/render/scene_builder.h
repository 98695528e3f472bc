// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/render/scene.h"
#include "core/toile/pipeline.h"

namespace toile {
struct Pattern;
struct PatternMatch;
}  // namespace toile

namespace toile::app {

/// Builds the buffers of both views. Pure; meant for a worker thread.
/// @param results  one per piece, or empty before the first flattening. Pieces that are
///                 not flat appear in 3D only
/// @param pattern  source of cutting lines, notches and internal lines; null: omitted
/// @param progress  started here and advanced piece by piece
/// Values of faces and edges are averaged at the vertices, weighted by area and length. At typical
/// mesh densities this gives a smooth map instead of noise. If cancelled, the scene is incomplete.
/// Cost: linear.
/// @param before  its cloth is shared if it has the same pieces and results; may be null
std::shared_ptr<const Scene> buildScene(const Garment& garment, const PieceResults& results,
                                        Progress& progress, const Pattern* pattern = nullptr,
                                        const Scene* before = nullptr);

/// The flat piece in the results if it belongs to the current piece; else null.
const FlatPiece* flatPieceOf(const Garment& garment, const PieceResults& results, int piece);

/// Functions that add lines to a scene with existing pieces (`buildScene`). Pure.

/// Adds both sides of every seam and free edge, in 3D and, if flat, in the pattern.
/// @param results one per piece, or empty. Cost: per seam, linear in the outlines.
void addSeamLines(const Garment& garment, const PieceResults& results, Scene& scene);

/// Adds the outline of every piece that is a disk.
void addOutlines(const Garment& garment, const PieceResults& results, Scene& scene);

/// Adds the edges of parts omitted when files were read; a sample if there are very many. Cost:
/// linear in them.
void addLeftOut(const Garment& garment, Scene& scene);

/// Adds outline and holes of the reference panels, fitted to the flat pieces that carry one.
void addReferenceLines(const Garment& garment, const PieceResults& results, Scene& scene);

/// Adds the solved outlines of pieces whose drawn outline differs.
void addExactOutlines(const Garment& garment, const PieceResults& results, Scene& scene);

/// Adds cutting lines of pieces with allowances, their boxes, and the notches.
void addCuttingLines(const Pattern& pattern, Scene& scene);

/// Adds internal lines and drill points and, in a pattern with allowances, the marks of darts.
void addInternalLines(const Garment& garment, const PieceResults& results, const Pattern& pattern,
                      Scene& scene);

/// The outlines of the file's pieces, fitted to their certain matches. Pure; linear.
ReferenceLines referenceLines(const PatternMatch& match);

}  // namespace toile::app
