// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/piece_quality.h"

#include <cmath>
#include <utility>

#include "core/garment/garment.h"
#include "core/geometry/placement.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// The placement of the reference on the flat piece, mirrored if that fits better.
std::pair<Placement, ReferenceFit> bestFit(const Points2& flat, const Points2& reference) {
    std::pair<Placement, ReferenceFit> best;
    for (const bool mirrored : {false, true}) {
        const Placement motion = geometry::fitMotion(reference, flat, mirrored);
        const Eigen::VectorXd distance = (motion.appliedToRows(reference) - flat).rowwise().norm();
        const ReferenceFit fit{
            std::sqrt(distance.squaredNorm() / static_cast<double>(distance.size())),
            distance.maxCoeff(), mirrored};
        if (!mirrored || fit.rms < best.second.rms) {
            best = {motion, fit};
        }
    }
    return best;
}

}  // namespace

ReferenceFit fitToReference(const Points2& flat, const Points2& reference) {
    return bestFit(flat, reference).second;
}

Points2 placedReference(const Points2& flat, const Points2& reference) {
    return bestFit(flat, reference).first.appliedToRows(reference);
}

PieceQuality measure(const Piece& piece, const Points2& Q) {
    const MeshArrays& mesh = piece.mesh;
    const Eigen::VectorXd outline3d = boundaryLengths3d(mesh.V, piece.boundary);
    const Eigen::VectorXd outline2d = boundaryLengths2d(Q, piece.boundary);
    const Eigen::VectorXd edges3d = edgeLengths3d(mesh.V, piece.table.edges);
    const Eigen::VectorXd edges2d = edgeLengths2d(Q, piece.table.edges);
    const Eigen::VectorXd areas3d = triangleAreas3d(mesh);
    const Eigen::VectorXd areas2d = triangleAreas2d(Q, mesh.F);
    const Eigen::MatrixX2d singular = singularValues(mesh, Q);

    PieceQuality quality;
    quality.area3d = areas3d.sum();
    quality.area2d = areas2d.sum();
    quality.perimeter3d = outline3d.sum();
    quality.perimeter2d = outline2d.sum();
    quality.piTheta =
        piTheta(boundaryAngles3d(mesh, piece.boundary), boundaryAngles2d(Q, piece.boundary));
    quality.piL = piL(outline3d, outline2d);
    quality.piE = piE(edges3d, edges2d);
    quality.piA = piA(areas3d, areas2d);
    quality.maxBoundaryLengthError = maxRelativeLengthError(outline3d, outline2d);
    quality.maxTargetLengthError = quality.maxBoundaryLengthError;
    quality.symmetricDirichlet = symmetricDirichlet(singular, areas3d, areas2d);
    const QuasiConformal conformal = quasiConformal(singular, areas3d);
    quality.quasiConformalMean = conformal.mean;
    quality.quasiConformalMax = conformal.max;
    const Eigen::VectorXd strain = edgeStrain(edges3d, edges2d);
    if (strain.allFinite()) {
        quality.strainMin = strain.minCoeff();
        quality.strainMax = strain.maxCoeff();
        quality.strainMeanAbs = strain.cwiseAbs().mean();
    }
    if (piece.reference) {
        quality.reference = fitToReference(Q, *piece.reference);
    }
    quality.flippedTriangles = flippedTriangles(areas2d, areas3d);
    quality.outlineCrossings = outlineCrossings(Q, piece.boundary);
    return quality;
}

DistortionFields distortionFields(const Piece& piece, const Points2& Q) {
    const MeshArrays& mesh = piece.mesh;
    DistortionFields fields;
    fields.areaChange = triangleAreas2d(Q, mesh.F).cwiseQuotient(triangleAreas3d(mesh)).array() - 1;
    fields.angleChange =
        (cornerAngles2d(Q, mesh.F) - cornerAngles3d(mesh)).cwiseAbs().rowwise().maxCoeff();
    fields.edgeStrain =
        edgeStrain(edgeLengths3d(mesh.V, piece.table.edges), edgeLengths2d(Q, piece.table.edges));
    return fields;
}

}  // namespace toile
