// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/flatten/base/flat_notes.h"
#include "core/flatten/boundary/boundary_problem.h"
#include "core/flatten/conformal/conformal_methods.h"
#include "core/flatten/interior/authalic.h"
#include "core/flatten/interior/conformal_interior.h"
#include "core/garment/garment.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// 2 pi minus the sum of the triangle angles at each vertex; on the boundary of no meaning.
Eigen::VectorXd angleDefects(const MeshArrays& mesh) {
    return 2 * std::numbers::pi - vertexAngles3d(mesh).array();
}

}  // namespace

Result<FlatPiece> flattenCurvature(const Piece& piece, const FlattenOptions& options,
                                   const Progress& progress) {
    const Stopwatch interiorTime;
    const MeshArrays& mesh = piece.mesh;
    auto interior = ConformalInterior::make(piece, progress);
    if (!interior) {
        return interior.error();
    }
    // The logarithm u of the scale of a conformal flat metric that keeps the boundary's lengths:
    // L u = -K inside, u = 0 on the boundary. Its flux through the boundary is what the interior
    // curvature takes from each boundary angle.
    auto u = interior->solve(-angleDefects(mesh), progress);
    if (!u) {
        return u.error();
    }
    const Eigen::MatrixXd flux = interior->apply(*u);
    progress.step();
    const double factorising = interiorTime.seconds();

    const Stopwatch boundaryTime;
    BoundaryProblem problem{boundaryLengths3d(mesh.V, piece.boundary),
                            boundaryAngles3d(mesh, piece.boundary)};
    for (std::size_t i = 0; i < piece.boundary.size(); ++i) {
        problem.angles[static_cast<Eigen::Index>(i)] -= flux(piece.boundary[i], 0);
    }
    const auto boundary = solveBoundary(problem, options.boundarySolver, progress);
    if (!boundary) {
        return boundary.error();
    }
    FlatPiece flat;
    if (auto note = anglesNote(piece, problem.angles)) {
        flat.notes.push_back(std::move(*note));
    }
    flat.boundarySolver = boundary->solver;
    flat.boundaryIterations = boundary->iterations;
    flat.closureGap = boundary->closureGap;
    flat.angleEnergy = boundary->energy;
    flat.boundarySeconds = boundaryTime.seconds();

    const Stopwatch extendTime;
    auto points = options.authalic != 0
                      ? fillInteriorMixed(mesh, piece.table, piece.boundary, boundary->points,
                                          options.authalic, progress)
                      : interior->place(boundary->points, progress);
    if (!points) {
        return points.error();
    }
    flat.Q = std::move(*points);
    flat.delaunayFlips = options.authalic != 0 ? 0 : interior->delaunayFlips();
    flat.interiorSeconds = factorising + extendTime.seconds();
    return flat;
}

}  // namespace toile
