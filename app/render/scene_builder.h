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

/// Makes the buffers of both views. Pure; meant for a worker thread.
/// @param results  one per piece, or empty before the first flattening. Pieces without a flat
///                 result of their own are in 3D only
/// @param pattern  made of them: cutting lines, notches and internal lines; null: none is drawn
/// @param progress  started here and advanced piece by piece
/// Values of faces and edges are averaged at the vertices, weighted by area and length: at the
/// density of garment meshes this reads as a smooth map instead of noise.
/// After a cancel the scene is incomplete. Cost: linear.
/// @param before  its cloth is shared if it was made of the same pieces and results; may be null
std::shared_ptr<const Scene> buildScene(const Garment& garment, const PieceResults& results,
                                        Progress& progress, const Pattern* pattern = nullptr,
                                        const Scene* before = nullptr);

/// The flat piece in the results, where it is of that very piece; else null.
const FlatPiece* flatPieceOf(const Garment& garment, const PieceResults& results, int piece);

/// The lines of a scene whose pieces are there already (`buildScene`). Pure.

/// Both sides of every seam and free edge, in space and, where flat, in the pattern; their boxes.
/// @param results one per piece, or empty. Cost: linear in the outlines, for every seam.
void addSeamLines(const Garment& garment, const PieceResults& results, Scene& scene);

/// The outline of every piece that is a disk.
void addOutlines(const Garment& garment, const PieceResults& results, Scene& scene);

/// The edges of what was left out when files were read, some of them where they are very many.
/// Cost: linear in that.
void addLeftOut(const Garment& garment, Scene& scene);

/// Outline and holes of the reference panels, laid on the flat pieces that carry one.
void addReferenceLines(const Garment& garment, const PieceResults& results, Scene& scene);

/// The outlines as they were solved, of the pieces whose outline is drawn otherwise.
void addExactOutlines(const Garment& garment, const PieceResults& results, Scene& scene);

/// The lines that pieces with allowances are cut along, the boxes around them, and the notches.
void addCuttingLines(const Pattern& pattern, Scene& scene);

/// What lies within the cloth: internal lines and drill points, and in the pattern the marks of
/// darts where it has allowances.
void addInternalLines(const Garment& garment, const PieceResults& results, const Pattern& pattern,
                      Scene& scene);

/// The outlines of the file's pieces, each laid on the piece that it surely is. Pure; linear.
ReferenceLines referenceLines(const PatternMatch& match);

}  // namespace toile::app
