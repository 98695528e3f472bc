// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "core/garment/fabric.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

struct Piece;

/// Distance between a flat piece and a given flat panel after the best rigid motion, or the best
/// motion with a reflection if that fits better. Over all vertices, millimetres.
struct ReferenceFit {
    double rms = 0;
    double max = 0;
    bool mirrored = false;
};

/// @param flat, reference  #V x 2 each, vertex by vertex, at least one vertex. Pure; linear.
ReferenceFit fitToReference(const Points2& flat, const Points2& reference);

/// The given panel moved onto the flat piece by that motion: #V x 2, mm, in the flat piece's
/// coordinates. `fitToReference` gives the remaining distance. Pure; linear.
Points2 placedReference(const Points2& flat, const Points2& reference);

/// All figures of one flattened piece, named like the fields of the JSON report (docs/report.md).
/// Millimetres, square millimetres, radians. Empty if a figure would be infinite.
struct PieceQuality {
    double area3d = 0, area2d = 0;
    double perimeter3d = 0, perimeter2d = 0;
    double piTheta = 0, piL = 0, piE = 0, piA = 0;
    double maxBoundaryLengthError = 0;  ///< against 3D, even if other lengths are targeted
    double maxTargetLengthError = 0;    ///< against the target lengths
    std::optional<double> symmetricDirichlet;
    std::optional<double> quasiConformalMean, quasiConformalMax;
    std::optional<double> strainMin, strainMax, strainMeanAbs;
    std::optional<ReferenceFit> reference;  ///< set if the piece has a reference
    int flippedTriangles = 0;
    int outlineCrossings = 0;
};

/// Measures a flat piece. @param piece a disk  @param Q #V x 2, mm. Linear except for crossings.
PieceQuality measure(const Piece& piece, const Points2& Q);

/// Distortion per element, for overlays. Values are fractions (0.02 = 2 %) or radians.
struct DistortionFields {
    Eigen::VectorXd areaChange;   ///< per face: A2D/A3D - 1
    Eigen::VectorXd angleChange;  ///< per face: largest |corner angle 2D - 3D|, radians
    Eigen::VectorXd edgeStrain;   ///< per edge of piece.table.edges: L3D/L2D - 1
};

DistortionFields distortionFields(const Piece& piece, const Points2& Q);

/// Limits of a fabric along one direction, for comparison with cloth. Limits are kept above 0,
/// because rounding would exceed a limit of 0.
class StrainBounds {
public:
    /// Factor on the limit that keeps cloth exactly at its limit from exceeding it by rounding; the
    /// same as in surface.glsl.
    static constexpr double kSlack = 1.0005;

    explicit StrainBounds(const StrainLimits& stated)
        : least_(std::min(stated.least, -kMinStrainLimit)),
          most_(std::max(stated.most, kMinStrainLimit)) {}

    /// The limit on the side of this strain's sign.
    double limitFor(double strain) const { return strain < 0 ? least_ : most_; }
    /// Strain as a fraction of its limit.
    double severity(double strain) const { return strain / limitFor(strain); }
    bool isBeyond(double strain) const { return severity(strain) > kSlack; }

private:
    static constexpr double kMinStrainLimit = 1e-4;

    double least_, most_;
};

}  // namespace toile
