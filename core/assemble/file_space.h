// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/assemble/seams_file.h"
#include "core/garment/garment.h"

namespace toile {

/// A garment's pieces are in millimetres, y up; the points of a seams file are in the axes of the
/// garment's first file, and in the unit that the seams file states, else that of the first file.
/// Without files both spaces are equal. Pure.

/// mm, y up. The inverse of `inFileSpace`, within rounding.
Eigen::Vector3d inPieceSpace(const Eigen::Vector3d& point, const SeamsFile& seams,
                             const Garment& garment);
Eigen::Vector3d inFileSpace(const Eigen::Vector3d& point, const SeamsFile& seams,
                            const Garment& garment);

/// The same for points in the unit of the first file.
std::vector<Eigen::Vector3d> inPieceSpace(std::vector<Eigen::Vector3d> points,
                                          const Garment& garment);
std::vector<Eigen::Vector3d> inFileSpace(std::vector<Eigen::Vector3d> points,
                                         const Garment& garment);

/// The cuts and joins with their points in the space of the pieces.
std::vector<UserCut> cutsInPieceSpace(const SeamsFile& seams, const Garment& garment);
std::vector<UserJoin> joinsInPieceSpace(const SeamsFile& seams, const Garment& garment);

}  // namespace toile
