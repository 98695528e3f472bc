// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"

namespace toile {
struct Symmetry;
}  // namespace toile

namespace toile::app {

/// Edits of internal lines, one function each; other settings stay. Points are in the coordinates
/// of the pieces, mm. All pure.

using ClothPoints = std::vector<Eigen::Vector3d>;

/// Adds a line through these points, one or more, at the end of the list.
LineSettings withInternalLine(LineSettings lines, const Garment& garment, std::string name,
                              ClothPoints points, bool closed);
/// An index past the lines changes nothing.
LineSettings withoutInternalLine(LineSettings lines, std::size_t index);
/// Moves one of its points; indices past the end change nothing.
LineSettings withInternalPointMoved(LineSettings lines, const Garment& garment, std::size_t index,
                                    std::size_t point, const Eigen::Vector3d& to);

/// The mirror image of a line on the counterpart of its piece, or on its other half
/// (`mirroredCut`); none if it has none, or if it is the line itself.
std::optional<ClothPoints> mirroredInternalLine(const Garment& garment, const PieceResults& results,
                                                const Symmetry& symmetry, const ClothPoints& points,
                                                bool closed);

/// The line that was drawn as the mirror image of another: it has as many points, none farther than
/// kSameImage from the image. None if there is none.
std::optional<std::size_t> imageOfInternalLine(const LineSettings& lines, const Garment& garment,
                                               const PieceResults& results,
                                               const Symmetry& symmetry, std::size_t index);
inline constexpr double kSameImage = 2;  ///< mm

/// Makes one line the mirror image of another, if that has one.
LineSettings withInternalLineAsImage(LineSettings lines, const Garment& garment,
                                     const PieceResults& results, const Symmetry& symmetry,
                                     std::size_t of, std::size_t image);

}  // namespace toile::app
