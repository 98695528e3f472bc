// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/document/view_state.h"
#include "app/render/scene_renderer.h"
#include "core/toile/pipeline.h"

namespace toile::app {

class Document;

/// A part of a stretch of outline that is sewn, and what it is sewn to.
struct SewnPart {
    int seam = -1;       ///< index into Garment::seams
    bool whole = false;  ///< all of the seam
    SeamSide here, there;
};

/// What a stretch of outline is sewn to; nothing where it is free. Cost: linear in the seams and
/// in the outlines of the pieces. Pure.
/// @param run  of kind Run, within the garment
std::vector<SewnPart> sewnParts(const Garment& garment, const Feature& run);

/// The seam that a stretch is the whole of, and nothing besides; none where there is none.
std::optional<int> seamOfRun(const Garment& garment, const Feature& run);

/// How long a stretch and what is sewn to it are, mm.
struct RunLengths {
    double sewn = 0;     ///< of the stretch, as far as it is sewn
    double partner = 0;  ///< of what that is sewn to
    double free = 0;     ///< of the stretch, as far as it is not
    bool flat = false;   ///< measured in the pattern; else, where a piece is not flat, as worn
};

RunLengths runLengths(const Garment& garment, const PieceResults& results, const Feature& run);

/// What is to be highlighted of what is marked: the stretch or vertex, and all that is sewn to it,
/// by whole edges.
std::vector<Feature> markedFeatures(const Document& document);

/// The pattern sewn back together, or on its way there; null where that is not of the pattern and
/// the scene as they are now.
std::shared_ptr<const SewnCloth> sewnOf(const Document& document);

/// All that the views show of the document.
SceneContent contentOf(const Document& document);

}  // namespace toile::app
