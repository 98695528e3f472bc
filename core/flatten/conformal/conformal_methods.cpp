// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/conformal/conformal_methods.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/QR>
#include <Eigen/SVD>

#include "core/base/progress.h"
#include "core/flatten/base/flat_notes.h"
#include "core/flatten/boundary/boundary_problem.h"
#include "core/flatten/conformal/conformal_energy.h"
#include "core/flatten/interior/conformal_interior.h"
#include "core/flatten/interior/directed_interior.h"
#include "core/flatten/interior/interior.h"
#include "core/garment/garment.h"
#include "core/geometry/shortest_paths.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// Of vertices equally far apart (symmetric pieces) take the first, independent of rounding.
constexpr double kClearlyFarther = 1 + 1e-9;
/// Each sweep only lengthens the pair; two or three suffice.
constexpr int kMaxSweeps = 8;

using DistancesFrom = std::function<Eigen::VectorXd(int vertex)>;

int farthest(const std::vector<int>& boundary, const Eigen::VectorXd& distance) {
    int best = boundary.front();
    for (const int v : boundary) {
        if (distance[v] > kClearlyFarther * distance[best]) {
            best = v;
        }
    }
    return best;
}

std::array<int, 2> farPair(const Piece& piece, const DistancesFrom& distancesFrom) {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (const int v : piece.boundary) {
        middle += piece.mesh.V.row(v) / static_cast<double>(piece.boundary.size());
    }
    int first = farthest(piece.boundary, (piece.mesh.V.rowwise() - middle).rowwise().norm());
    int second = first;
    double apart = 0;
    for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
        const Eigen::VectorXd distance = distancesFrom(first);
        const int next = farthest(piece.boundary, distance);
        if (!(distance[next] > kClearlyFarther * apart)) {
            break;
        }
        apart = distance[next];
        second = std::exchange(first, next);
    }
    return {first, second};
}

}  // namespace

std::array<int, 2> farPairInSpace(const Piece& piece) {
    return farPair(piece, [&](int v) -> Eigen::VectorXd {
        return (piece.mesh.V.rowwise() - piece.mesh.V.row(v)).rowwise().norm();
    });
}

std::array<int, 2> farPairAlongEdges(const Piece& piece) {
    const Eigen::VectorXd lengths = edgeLengths3d(piece.mesh.V, piece.table.edges);
    const std::vector<double> weights(lengths.begin(), lengths.end());
    return farPair(piece, [&](int v) -> Eigen::VectorXd {
        const auto forest = geometry::shortestForest(
            piece.table.edges, static_cast<int>(piece.mesh.V.rows()), weights, {{v}});
        return Eigen::Map<const Eigen::VectorXd>(forest.distance.data(), piece.mesh.V.rows());
    });
}

Result<FlatPiece> atTrueSize(const Piece& piece, const Points2& points, const Stopwatch& time) {
    const double scale = boundaryLengths3d(piece.mesh.V, piece.boundary).sum() /
                         boundaryLengths2d(points, piece.boundary).sum();
    FlatPiece flat;
    flat.Q = scale * points;
    if (!flat.Q.allFinite()) {
        return Error{ErrorCode::NotFinite, {}, "flat positions"};
    }
    flat.angleEnergy = angleEnergy(boundaryAngles3d(piece.mesh, piece.boundary),
                                   boundaryAngles2d(flat.Q, piece.boundary));
    flat.interiorSeconds = time.seconds();
    return flat;
}

Result<FlatPiece> flattenNatural(const Piece& piece, const FlattenOptions& options,
                                 const Progress& progress) {
    const Stopwatch time;
    const ConformalEnergy energy(piece.mesh);
    int iterations = 0;
    const auto points = options.freeBoundary == FreeBoundary::Spectral
                            ? solveSpectral(energy, piece.boundary, iterations, progress)
                            : solvePinned(energy, farPairInSpace(piece), 1, progress);
    if (!points) {
        return points.error();
    }
    auto flat = atTrueSize(piece, *points, time);
    if (flat) {
        flat->interiorIterations = iterations;
    }
    return flat;
}

Result<FlatPiece> flattenLscm(const Piece& piece, const FlattenOptions& /*options*/,
                              const Progress& progress) {
    const Stopwatch time;
    return solvePinned(ConformalEnergy(piece.mesh), farPairAlongEdges(piece), 1, progress)
        .andThen([&](const Points2& points) { return atTrueSize(piece, points, time); });
}

namespace {

/// With the angles of the surface.
BoundaryProblem boundaryProblemOf(const Piece& piece, const OutlineTargets& targets) {
    return {outlineLengths(piece, targets), boundaryAngles3d(piece.mesh, piece.boundary)};
}

/// Solves the boundary problem and places the interior in the outline.
/// @param interior  made here if it is needed and missing
Result<FlatPiece> solveAndFill(const Piece& piece, const FlattenOptions& options,
                               const BoundaryProblem& problem,
                               std::optional<ConformalInterior> interior,
                               const Progress& progress) {
    const Stopwatch boundaryTime;
    const auto boundary = solveBoundary(problem, options.boundarySolver, progress);
    if (!boundary) {
        return boundary.error();
    }
    FlatPiece flat;
    flat.boundarySolver = boundary->solver;
    flat.boundaryIterations = boundary->iterations;
    flat.closureGap = boundary->closureGap;
    flat.angleEnergy = boundary->energy;
    flat.boundarySeconds = boundaryTime.seconds();

    const Stopwatch interiorTime;
    const bool isConformal = options.authalic == 0;
    if (isConformal && !interior) {
        auto made = ConformalInterior::make(piece, progress);
        if (!made) {
            return made.error();
        }
        interior = std::move(*made);
    }
    auto points = isConformal ? interior->place(boundary->points, progress)
                              : fillInteriorMixed(piece.mesh, piece.table, piece.boundary,
                                                  boundary->points, options.authalic, progress);
    if (!points) {
        return points.error();
    }
    flat.Q = std::move(*points);
    flat.delaunayFlips = isConformal ? interior->delaunayFlips() : 0;
    flat.interiorSeconds = interiorTime.seconds();
    return flat;
}

}  // namespace

Result<FlatPiece> flattenWang2005(const Piece& piece, const FlattenOptions& options,
                                  const Progress& progress, const OutlineTargets& targets) {
    return solveAndFill(piece, options, boundaryProblemOf(piece, targets), std::nullopt, progress);
}

Result<FlatPiece> flattenCurvature(const Piece& piece, const FlattenOptions& options,
                                   const Progress& progress, const OutlineTargets& targets) {
    const Stopwatch time;
    auto interior = ConformalInterior::make(piece, progress);
    if (!interior) {
        return interior.error();
    }
    // The logarithm u of the scale of a conformal flat metric with the same boundary lengths: L u =
    // -K inside, u = 0 on the boundary, K the angle defects to 2 pi around vertices. Its flux
    // through the boundary is the change of each boundary angle due to the interior curvature.
    const Eigen::VectorXd defects = 2 * std::numbers::pi - vertexAngles3d(piece.mesh).array();
    auto u = interior->solve(-defects, progress);
    if (!u) {
        return u.error();
    }
    const Eigen::MatrixXd flux = interior->apply(*u);
    progress.step();
    const double factorising = time.seconds();

    BoundaryProblem problem = boundaryProblemOf(piece, targets);
    problem.angles -= flux(piece.boundary, 0);
    auto flat = solveAndFill(piece, options, problem, std::move(*interior), progress);
    if (flat) {
        flat->interiorSeconds += factorising;
        if (auto note = anglesNote(piece, problem.angles)) {
            flat->notes.push_back(std::move(*note));
        }
    }
    return flat;
}

namespace {

constexpr int kMaxPowerSteps = 200;
/// The iteration ends if a step moves the boundary by less than this part of its size.
constexpr double kConverged = 1e-13;
/// After orthogonalisation, a direction shorter than this part of its earlier length is rounding.
constexpr double kDependent = 1e-10;
/// Multiple of B added to M^H M, whose diagonal is about one, to make it definite. Far below the
/// eigenvalues of pieces like a belt (squares in a row: 100 / n^4), else steps would gain little.
constexpr double kFirstShift = 1e-13;
constexpr double kShiftGrowth = 100;
constexpr int kShifts = 4;

/// The operators of the iteration: B, the constants, and solves with M^H M + shift B.
class SpectralProblem {
public:
    SpectralProblem(const ConformalEnergy& energy, const std::vector<int>& boundary)
        : energy_(energy), boundary_(boundary), unknown_(unknownsBut({}, energy.vertexCount())) {}

    /// With the smallest shift for which the rounded matrix stays definite.
    Result<void> factorise(const Progress& progress) {
        Result<void> done = Error{ErrorCode::FactorisationFailed};
        double shift = kFirstShift;
        for (int attempt = 0; attempt < kShifts; ++attempt, shift *= kShiftGrowth) {
            if (progress.isCancelled()) {
                return Error{ErrorCode::Cancelled};
            }
            linalg::SymmetricBuilder builder(2 * energy_.vertexCount());
            energy_.addTo(builder, unknown_);
            for (const int v : boundary_) {
                builder.add(2 * v, 2 * v, shift);
                builder.add(2 * v + 1, 2 * v + 1, shift);
            }
            done = cholesky_.factorise(builder.build());
            if (done || done.error().code != ErrorCode::FactorisationFailed) {
                break;
            }
        }
        return done;
    }

    Result<Eigen::VectorXcd> solve(const Eigen::VectorXcd& right) const {
        return solveFree(cholesky_, unknown_, right);
    }

    Eigen::VectorXcd timesB(const Eigen::VectorXcd& z) const {
        Eigen::VectorXcd result = Eigen::VectorXcd::Zero(z.size());
        for (const int v : boundary_) {
            result[v] = z[v];
        }
        return result;
    }

    /// Moves the boundary's mean to the origin: orthogonal to the constants, the kernel of M.
    void deflate(Eigen::VectorXcd& z) const {
        std::complex<double> sum = 0;
        for (const int v : boundary_) {
            sum += z[v];
        }
        z.array() -= sum / static_cast<double>(boundary_.size());
    }

    /// Orthonormal basis in B; drops dependent directions.
    std::vector<Eigen::VectorXcd> orthonormal(std::vector<Eigen::VectorXcd> directions) const {
        std::vector<Eigen::VectorXcd> basis;
        for (Eigen::VectorXcd& d : directions) {
            deflate(d);
            const double before = d.norm();
            for (int pass = 0; pass < 2; ++pass) {
                for (const Eigen::VectorXcd& b : basis) {
                    d -= b * timesB(b).dot(d);
                }
            }
            const double size = timesB(d).norm();
            if (size > kDependent * before && size > 0) {
                basis.push_back(d / size);
            }
        }
        return basis;
    }

private:
    const ConformalEnergy& energy_;
    const std::vector<int>& boundary_;
    std::vector<int> unknown_;  ///< all vertices
    linalg::SparseCholesky cholesky_;
};

/// The combination of a non-empty B-orthonormal basis with the smallest |M z|, from the singular
/// values of M times the basis: a Gram matrix would lose half the digits.
Eigen::VectorXcd leastCombination(const ConformalEnergy& energy,
                                  const std::vector<Eigen::VectorXcd>& basis) {
    const auto count = static_cast<Eigen::Index>(basis.size());
    Eigen::MatrixXcd images(energy.residual(basis[0]).size(), count);
    for (Eigen::Index k = 0; k < count; ++k) {
        images.col(k) = energy.residual(basis[k]);
    }
    const Eigen::HouseholderQR<Eigen::MatrixXcd> qr(images);
    const Eigen::Index rows = std::min(count, images.rows());
    const Eigen::MatrixXcd R =
        qr.matrixQR().topRows(rows).triangularView<Eigen::Upper>().toDenseMatrix();
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(R, Eigen::ComputeFullV);
    return svd.matrixV().col(count - 1);
}

}  // namespace

Result<Points2> solveSpectral(const ConformalEnergy& energy, const std::vector<int>& boundary,
                              int& iterations, const Progress& progress) {
    SpectralProblem problem(energy, boundary);
    const auto factorised = problem.factorise(progress);
    if (!factorised) {
        return factorised.error();
    }
    // Any start works that is not orthogonal to the solution: the boundary on a circle.
    Eigen::VectorXcd z = Eigen::VectorXcd::Zero(energy.vertexCount());
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        z[boundary[i]] = std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(i) /
                                             static_cast<double>(boundary.size()));
    }
    auto first = problem.solve(problem.timesB(z));
    if (!first) {
        return first.error();
    }
    std::vector<Eigen::VectorXcd> basis = problem.orthonormal({std::move(*first)});
    Eigen::VectorXcd last = Eigen::VectorXcd::Zero(z.size());
    double change = 1;
    for (iterations = 1; iterations < kMaxPowerSteps && change > kConverged && !basis.empty();
         ++iterations) {
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        z = basis[0];
        // This solve gives the difference of the next step of the inverse iteration from z, so that
        // its relative error affects only the small correction.
        const Eigen::VectorXcd Mz = energy.residual(z);
        const Eigen::VectorXcd right = energy.adjoint(Mz) - Mz.squaredNorm() * problem.timesB(z);
        auto correction = problem.solve(right);
        if (!correction) {
            return correction.error();
        }
        basis = problem.orthonormal({z, std::move(*correction), last});
        if (basis.empty()) {  // no longer finite
            break;
        }
        const Eigen::VectorXcd c = leastCombination(energy, basis);
        last.setZero();
        for (Eigen::Index k = 1; k < c.size(); ++k) {
            last += c[k] * basis[k];
        }
        change = problem.timesB(last).norm();
        basis = problem.orthonormal({Eigen::VectorXcd(c[0] * basis[0] + last)});
    }
    if (basis.empty() || !basis[0].allFinite()) {
        return Error{ErrorCode::NotFinite, {}, "flat positions"};
    }
    Points2 Q(energy.vertexCount(), 2);
    Q << basis[0].real(), basis[0].imag();
    return Q;
}

}  // namespace toile
