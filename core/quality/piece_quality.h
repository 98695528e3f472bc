// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/mesh_arrays.h"
#include "core/quality/reference_fit.h"

namespace toile {

struct Piece;

/// All figures of one flattened piece; the fields of the JSON report (docs/report.md) by the same
/// names. Millimetres, square millimetres, radians. Empty where a figure would be infinite.
struct PieceQuality {
    double area3d = 0, area2d = 0;
    double perimeter3d = 0, perimeter2d = 0;
    double piTheta = 0, piL = 0, piE = 0, piA = 0;
    double maxBoundaryLengthError = 0;
    std::optional<double> symmetricDirichlet;
    std::optional<double> quasiConformalMean, quasiConformalMax;
    std::optional<double> strainMin, strainMax, strainMeanAbs;
    std::optional<ReferenceFit> reference;  ///< there where the piece carries one
    int flippedTriangles = 0;
    int outlineCrossings = 0;
};

/// Measures a flat piece. @param piece a disk  @param Q #V x 2, mm. Cost: linear but for crossings.
PieceQuality measure(const Piece& piece, const Points2& Q);

/// Distortion per element, for overlays. Values are fractions (0.02 = 2 %) or radians.
struct DistortionFields {
    Eigen::VectorXd areaChange;   ///< per face: A2D/A3D - 1
    Eigen::VectorXd angleChange;  ///< per face: largest |corner angle 2D - 3D|, radians
    Eigen::VectorXd edgeStrain;   ///< per edge of piece.table.edges: L3D/L2D - 1
    Eigen::VectorXd faceStrain;   ///< per face: of its three edges' strains the one largest in size
};

DistortionFields distortionFields(const Piece& piece, const Points2& Q);

}  // namespace toile
