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

/// What a person decides of internal lines, one edit each; the rest of the settings stays. Points
/// are as the pieces are, mm. All pure.

using ClothPoints = std::vector<Eigen::Vector3d>;

/// With a line through these points, one or more, at the end of the list.
LineSettings withInternalLine(LineSettings lines, const Garment& garment, std::string name,
                              ClothPoints points, bool closed);
/// An index past the lines changes nothing.
LineSettings withoutInternalLine(LineSettings lines, std::size_t index);
/// With one of its points at another place; indices past the end change nothing.
LineSettings withInternalPointMoved(LineSettings lines, const Garment& garment, std::size_t index,
                                    std::size_t point, const Eigen::Vector3d& to);

/// The mirror image of a line on the counterpart of its piece, or on its other half
/// (`mirroredCut`); none where there is none, or where it is the line itself.
std::optional<ClothPoints> mirroredInternalLine(const Garment& garment, const PieceResults& results,
                                                const Symmetry& symmetry, const ClothPoints& points,
                                                bool closed);

/// The line that was drawn as the mirror image of another: with as many points, none farther than
/// kSameImage from that. None where there is none.
std::optional<std::size_t> imageOfInternalLine(const LineSettings& lines, const Garment& garment,
                                               const PieceResults& results,
                                               const Symmetry& symmetry, std::size_t index);
inline constexpr double kSameImage = 2;  ///< mm

/// With one line as the mirror image of another, where that has one.
LineSettings withInternalLineAsImage(LineSettings lines, const Garment& garment,
                                     const PieceResults& results, const Symmetry& symmetry,
                                     std::size_t of, std::size_t image);

}  // namespace toile::app
