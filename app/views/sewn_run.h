// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/document/view_state.h"
#include "app/render/scene_renderer.h"
#include "core/toile/pipeline.h"

namespace toile::app {

class Document;

/// A sewn part of a stretch of outline, and its partner.
struct SewnPart {
    int seam = -1;       ///< index into Garment::seams
    bool whole = false;  ///< covers the whole seam
    SeamSide here, there;
};

/// The seams along a stretch of outline; empty if it is free. Cost: linear in the seams and in the
/// outlines of the pieces. Pure.
/// @param run  of kind Run, in the garment
std::vector<SewnPart> sewnParts(const Garment& garment, const Feature& run);

/// The seam that covers exactly this stretch, if any.
std::optional<int> seamOfRun(const Garment& garment, const Feature& run);

/// Lengths of a stretch and of its partners, mm.
struct RunLengths {
    double sewn = 0;     ///< sewn length of the stretch
    double partner = 0;  ///< length of its partners
    double free = 0;     ///< free length of the stretch
    bool flat = false;   ///< measured in the pattern; in 3D if a piece is not flat
};

RunLengths runLengths(const Garment& garment, const PieceResults& results, const Feature& run);

/// The features to highlight for the mark: the stretch or vertex, and its partners, in whole edges.
std::vector<Feature> markedFeatures(const Document& document);

/// The pattern sewn back together, or in progress; null if it does not match the current pattern
/// and scene.
std::shared_ptr<const SewnCloth> sewnOf(const Document& document);

SceneContent contentOf(const Document& document);

}  // namespace toile::app
