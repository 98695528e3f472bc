// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/wording.h"
#include "core/marker/cloth_marker.h"
#include "core/nest/nest.h"

// For the sources of this folder only.
namespace toile::cloth {

/// A piece to lay, or its image.
struct LaidPiece {
    int piece = 0;  ///< index into Pattern::pieces
    bool isImage = false;
    int yield = 1;               ///< LaidCopy::yield of each
    std::vector<int> numbers{};  ///< CopyKey::number of each
    bool isKept = false;         ///< a single copy placed by the user
};

/// The id of a copy's piece: its own, or one derived from the piece that it is a facing of.
PieceId idOnCloth(const Pattern& pattern, int piece);

/// The material of a piece; empty for the garment's own.
std::string materialOnCloth(const Pattern& pattern, const PatternPiece& piece);

/// By piece, images after their originals.
/// @param notes  gets pieces left over on folded cloth
std::vector<LaidPiece> laidPieces(const Pattern& pattern, const std::string& material,
                                  const MarkerSettings& settings, std::vector<Wording>& notes);

/// The nest uses separate piece coordinates, so that nested and drawn outlines have identical
/// points, bit by bit: first turned for pieces on the fold, which is horizontal there with the
/// cloth above it, then mirrored for images.
struct NestForm {
    double turn = 0;
    bool flip = false;

    Points2 of(const Points2& line) const;
    Eigen::Vector2d of(const Eigen::Vector2d& point) const;
    NestPlacement nestPlacement(const Placement& placement) const;
    Placement placement(const NestPlacement& placed) const;
};
NestForm nestFormOf(const PatternPiece& piece, bool isImage);

/// The piece with the warp along x, with all the angles that the rule allows; without holes,
/// because nothing is laid in them.
NestItem itemOf(const PatternPiece& piece, bool isImage, const MarkerSettings& settings);

inline constexpr double kGapRounding = 0.002;  ///< mm: growth of shapes with a gap by rounding

/// Smallest length and smallest width on the cloth, each at its best angle, mm.
Eigen::Vector2d leastSides(const NestItem& item);
/// Available width of the cloth without borders; a fold needs no border. mm.
double roomAcross(const NestItem& item, double width, const MarkerSettings& settings);
/// Available length of a sheet; a roll is endless.
double roomAlong(const MarkerSettings& settings);

/// The outline of a copy at its placement.
geometry::Polygon lineOf(const PatternPiece& piece, bool isImage, const Placement& placement);

}  // namespace toile::cloth
