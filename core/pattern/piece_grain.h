// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "core/flatten/base/piece_cloth.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/fabric.h"
#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/pattern.h"
#include "core/pattern/pole.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// Position of a grain line: along the middle of the largest slender box in its direction that fits
/// in the free cloth, up to 300 mm long; of equal boxes the one nearest to the middle of the piece.
/// It keeps a distance of about a twentieth of its length from all lines. Nothing if no line fits.
/// @param angle  of the line, radians  Cost: that of boxPole. Pure.
std::optional<Chord> grainLine(const FreeCloth& cloth, double angle);

/// The line with the two strokes of an arrow head at `to`, as a single open path for a pen, mm.
Points2 arrowPath(const Chord& line);

/// The direction of the warp on every piece, radians in flat coordinates, with "up" defined by the
/// rule. If two pieces mirror each other, the second gets the mirrored direction of the first. On a
/// piece that mirrors itself the grain runs exactly along its axis, the fold of its half pattern,
/// or at 90 degrees to it, whichever is nearer; a reference panel may also lie on its bias.
/// @param results   one per piece
/// @param symmetry  null: every piece is treated alone
/// @param fabrics   one per piece, for LeastStrain; an unset fabric counts as woven
/// @return nothing if a piece is not flat, or lies level, so that no direction is up
/// Cost: linear in the triangles. Pure.
std::vector<std::optional<double>> findGrains(const Garment& garment, const PieceResults& results,
                                              const Symmetry* symmetry, GrainRule rule,
                                              const std::vector<Fabric>& fabrics);

/// The cloth of every piece as an input of flattening: the direction of the warp on the garment,
/// before anything is flat, and the fabric with its stiffness. The direction is
/// - of a typed grain, the one that the known flat piece shows there;
/// - by Reference, up the reference panel, if the piece has one;
/// - else up, or along the tube if the piece is sewn to itself (`axisWarp`). LeastStrain needs a
///   solve and starts from there. Unknown if the piece lies level.
/// @param rule     empty: the warp is unknown unless it is typed
/// @param fabrics  one per piece, or empty: not stated
/// @param known    flat pieces, one per piece, or empty
/// @param typed    radians on `known`, one per piece, or empty
/// Cost: linear in the triangles. Pure.
PieceCloths pieceCloths(const Garment& garment, const std::optional<GrainRule>& rule,
                        const std::vector<Fabric>& fabrics, const PieceResults& known = {},
                        const std::vector<std::optional<double>>& typed = {});

/// For `PieceCloth::warp`: the axis of revolution of a limb, in a single row. The normals vary
/// least in this direction. It is exact on cylinders, and on cones of more than a quarter of a
/// turn. For a plane piece it is the longest direction.
Points3 axisWarp(const MeshArrays& mesh);
/// For `PieceCloth::warp`: per vertex the direction that a flat map shows at an angle.
/// @param flat  #V x 2, may be mirrored
Points3 warpThrough(const MeshArrays& mesh, const Points2& flat, double angle);

}  // namespace toile
