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

/// The nest has pieces in coordinates of their own, so that what it lays and what is drawn of it
/// have the same points to the last bit: turned where they lie on the fold, which is level there
/// with the cloth above it, and then mirrored, where they are images.
struct NestForm {
    double turn = 0;
    bool flip = false;

    Points2 of(const Points2& line) const;
    Eigen::Vector2d of(const Eigen::Vector2d& point) const;
    NestPlacement nestPlacement(const Placement& placement) const;
    Placement placement(const NestPlacement& placed) const;
};
NestForm nestFormOf(const PatternPiece& piece, bool isImage);

/// The piece so that the warp runs along x, and as often turned as the rule allows; without the
/// holes, in which nothing is laid.
NestItem itemOf(const PatternPiece& piece, bool isImage, const MarkerSettings& settings);

inline constexpr double kGapRounding = 0.002;  ///< mm: by which shapes with a gap may grow

/// How long and how wide it is on the cloth, each at the best of its angles, mm.
Eigen::Vector2d leastSides(const NestItem& item);
/// What it has of the cloth's width, borders aside; none is kept from a fold. mm.
double roomAcross(const NestItem& item, double width, const MarkerSettings& settings);
/// And of a sheet's length; a roll has no end.
double roomAlong(const MarkerSettings& settings);

/// The line that a copy takes up, as it lies.
geometry::Polygon lineOf(const PatternPiece& piece, bool isImage, const Placement& placement);

}  // namespace toile::cloth
