// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/wording.h"
#include "core/marker/cloth_marker.h"
#include "core/nest/nest.h"

// For the sources of this folder only.
namespace toile::cloth {

/// What is laid of a piece: it, or its image.
struct LaidPiece {
    int piece = 0;  ///< index into Pattern::pieces
    bool isImage = false;
    int yield = 1;               ///< LaidCopy::yield of each
    std::vector<int> numbers{};  ///< CopyKey::number of each
    bool isKept = false;         ///< a single one, by a person
};

/// By which a copy of the piece is known: its id, or one that follows from what it is a facing of.
PieceId idOnCloth(const Pattern& pattern, int piece);

/// Of which material a piece is, empty: of the garment's own.
std::string materialOnCloth(const Pattern& pattern, const PatternPiece& piece);

/// By piece, images after their originals.
/// @param notes  what of folded cloth is left over
std::vector<LaidPiece> laidPieces(const Pattern& pattern, const std::string& material,
                                  const MarkerSettings& settings, std::vector<Wording>& notes);

/// The piece's line for the nest, an image as one; without the holes, in which nothing is laid.
geometry::Polygon lineOnCloth(const PatternPiece& piece, bool isImage);

/// The piece so that the warp runs along x, and as often turned as the rule allows.
NestItem itemOf(const PatternPiece& piece, bool isImage, const MarkerSettings& settings);

/// Where a copy lies, as the nest says it and as layouts do.
NestPlacement nestPlacementOf(const Placement& placement);
Placement placementOf(const NestPlacement& placement, bool isImage);

}  // namespace toile::cloth
