// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/reference/abf_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/text.h"
#include "core/flatten/base/flat_notes.h"
#include "core/flatten/conformal/conformal_energy.h"
#include "core/flatten/interior/interior.h"
#include "core/flatten/reference/reference_methods.h"
#include "core/garment/piece.h"
#include "core/linalg/sparse_cholesky.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

using std::numbers::pi;
using Matrix6x3 = Eigen::Matrix<double, 6, 3>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr int kMaxSteps = 30;
/// The iteration ends if constraints are violated by less than this, and no angle changes by more
/// than the second value; convergence is quadratic, so both are then far smaller. Radians.
constexpr double kViolation = 1e-10;
constexpr double kChange = 1e-6;
/// A step moves an angle at most this part of the way to 0 or pi.
constexpr double kWayToLimit = 0.8;
constexpr double kUnmet = 1e-6;  // radians: a larger violation is visible in the map
/// The diagonal Hessian stays above this part of the objective's own.
constexpr double kMinCurvature = 0.1;

/// The matrices of one Newton iteration are small per triangle: its three angles enter the sums
/// around its three vertices (rows 0 to 2) and their wheels (rows 3 to 5).
class AngleProblem {
public:
    AngleProblem(const MeshArrays& mesh, const std::vector<int>& boundary)
        : F_(mesh.F),
          unknown_(unknownsBut(boundary, static_cast<int>(mesh.V.rows()))),
          count_(static_cast<int>(unknown_.size() - boundary.size())) {
        target_ = cornerAngles3d(mesh);
        Eigen::VectorXd around = Eigen::VectorXd::Zero(mesh.V.rows());
        for (int f = 0; f < F_.rows(); ++f) {
            for (int k = 0; k < 3; ++k) {
                around[F_(f, k)] += target_(f, k);
            }
        }
        for (int f = 0; f < F_.rows(); ++f) {
            for (int k = 0; k < 3; ++k) {
                if (unknown_[F_(f, k)] >= 0) {
                    target_(f, k) *= 2 * pi / around[F_(f, k)];
                }
            }
        }
        // An angle of a needle next to a sharp tip may be scaled beyond a half turn.
        x_ = target_.cwiseMin(0.9 * pi);
        multipliers_ = Eigen::VectorXd::Zero(2 * Eigen::Index{count_});
    }

    const Eigen::MatrixX3d& angles() const { return x_; }

    /// Largest violation of any constraint.
    double violation() const {
        const Eigen::VectorXd vertices = vertexViolations();
        const double triangles = (x_.rowwise().sum().array() - pi).abs().maxCoeff();
        return vertices.size() == 0 ? triangles
                                    : std::max(triangles, vertices.cwiseAbs().maxCoeff());
    }

    /// One step; returns its largest change of an angle. NotFinite if the numbers overflow.
    Result<double> step(const Progress& progress) {
        const auto solved = solveMultipliers(progress);
        if (!solved) {
            return solved.error();
        }
        Eigen::MatrixX3d change(F_.rows(), 3);
        double length = 1;
        for (int f = 0; f < F_.rows(); ++f) {
            change.row(f) = changeOf(f, *solved);
            for (int k = 0; k < 3; ++k) {
                const double room = change(f, k) < 0 ? x_(f, k) : pi - x_(f, k);
                if (std::abs(change(f, k)) * length > kWayToLimit * room) {
                    length = kWayToLimit * room / std::abs(change(f, k));
                }
            }
        }
        if (!change.allFinite()) {
            return Error{ErrorCode::NotFinite, {}, "planar angles"};
        }
        x_ += length * change;
        multipliers_ += length * (*solved - multipliers_);
        return length * change.cwiseAbs().maxCoeff();
    }

private:
    /// Contribution of a triangle to the Newton system.
    struct Local {
        Eigen::Vector3d inverse;   ///< of the diagonal Hessian
        Eigen::Vector3d gradient;  ///< of the objective
        Matrix6x3 jacobian;        ///< rows of vertices on the boundary are zero
        double excess;             ///< angle sum minus pi
        std::array<int, 6> row;    ///< in the reduced system, or -1
    };

    Local local(int f) const {
        Local t{};
        t.jacobian.setZero();
        t.excess = x_.row(f).sum() - pi;
        for (int k = 0; k < 3; ++k) {
            const int u = unknown_[F_(f, k)];
            t.row[k] = u < 0 ? -1 : 2 * u;
            t.row[3 + k] = u < 0 ? -1 : 2 * u + 1;
        }
        for (int k = 0; k < 3; ++k) {
            // Seen from the next vertex the angle at corner k is the previous one, and vice versa.
            const int next = 3 + (k + 1) % 3;
            const int previous = 3 + (k + 2) % 3;
            const double sine = std::sin(x_(f, k));
            const double cotangent = std::cos(x_(f, k)) / sine;
            double bend = 0;
            if (t.row[k] >= 0) {
                t.jacobian(k, k) = 1;
            }
            if (t.row[next] >= 0) {
                t.jacobian(next, k) = -cotangent;
                bend += multipliers_[t.row[next]];
            }
            if (t.row[previous] >= 0) {
                t.jacobian(previous, k) = cotangent;
                bend -= multipliers_[t.row[previous]];
            }
            const double weight = 2 / (target_(f, k) * target_(f, k));
            t.gradient[k] = weight * (x_(f, k) - target_(f, k));
            t.inverse[k] = 1 / std::max(weight + bend / (sine * sine), kMinCurvature * weight);
        }
        return t;
    }

    /// Sum around each interior vertex minus 2 pi, and its wheel's logarithm, interleaved.
    Eigen::VectorXd vertexViolations() const {
        Eigen::VectorXd c = Eigen::VectorXd::Zero(2 * Eigen::Index{count_});
        for (Eigen::Index u = 0; u < count_; ++u) {
            c[2 * u] = -2 * pi;
        }
        for (int f = 0; f < F_.rows(); ++f) {
            for (int k = 0; k < 3; ++k) {
                const Eigen::Index u = unknown_[F_(f, k)];
                if (u >= 0) {
                    c[2 * u] += x_(f, k);
                    c[2 * u + 1] += std::log(std::sin(x_(f, (k + 1) % 3))) -
                                    std::log(std::sin(x_(f, (k + 2) % 3)));
                }
            }
        }
        return c;
    }

    Result<Eigen::VectorXd> solveMultipliers(const Progress& progress) {
        Eigen::VectorXd right = vertexViolations();
        if (count_ == 0) {
            return right;
        }
        linalg::SymmetricBuilder builder(2 * count_);
        builder.reserve(static_cast<std::size_t>(21 * F_.rows()));
        for (int f = 0; f < F_.rows(); ++f) {
            const Local t = local(f);
            const Eigen::Vector3d& p = t.inverse;
            const Eigen::Matrix3d within =
                Eigen::Matrix3d(p.asDiagonal()) - p * p.transpose() / p.sum();
            const Eigen::Matrix<double, 6, 6> block = t.jacobian * within * t.jacobian.transpose();
            const Vector6 known = t.jacobian * (within * t.gradient + p * (t.excess / p.sum()));
            for (int i = 0; i < 6; ++i) {
                if (t.row[i] < 0) {
                    continue;
                }
                right[t.row[i]] -= known[i];
                for (int j = 0; j <= i; ++j) {
                    if (t.row[j] >= 0) {
                        builder.add(t.row[i], t.row[j], block(i, j));
                    }
                }
            }
        }
        const linalg::SymmetricMatrix matrix = builder.build();
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        const auto factorised = cholesky_.factorise(matrix);
        if (!factorised) {
            return factorised.error();
        }
        const auto solved = cholesky_.solve(right);
        return solved ? Result<Eigen::VectorXd>(solved->col(0)) : solved.error();
    }

    Eigen::RowVector3d changeOf(int f, const Eigen::VectorXd& multipliers) const {
        const Local t = local(f);
        Vector6 mine = Vector6::Zero();
        for (int i = 0; i < 6; ++i) {
            mine[i] = t.row[i] < 0 ? 0 : multipliers[t.row[i]];
        }
        const Eigen::Vector3d force = t.gradient + t.jacobian.transpose() * mine;
        const double own = (t.excess - t.inverse.dot(force)) / t.inverse.sum();
        return -(t.inverse.array() * (force.array() + own)).matrix().transpose();
    }

    const Triangles& F_;
    std::vector<int> unknown_;  ///< number of each interior vertex, -1 on the boundary
    int count_;
    Eigen::MatrixX3d target_;
    Eigen::MatrixX3d x_;
    Eigen::VectorXd multipliers_;  ///< of the sums and the wheels, interleaved
    linalg::SparseCholesky cholesky_;
};

}  // namespace

Result<PlanarAngles> closestPlanarAngles(const MeshArrays& mesh, const std::vector<int>& boundary,
                                         const Progress& progress) {
    AngleProblem problem(mesh, boundary);
    PlanarAngles result;
    double change = pi;
    result.residual = problem.violation();
    while (result.iterations < kMaxSteps && (result.residual > kViolation || change > kChange)) {
        const auto stepped = problem.step(progress);
        if (!stepped) {
            return stepped.error();
        }
        change = *stepped;
        result.residual = problem.violation();
        ++result.iterations;
        progress.step();
    }
    result.angles = problem.angles();
    return result;
}

Result<FlatPiece> flattenAbf(const Piece& piece, const FlattenOptions& /*options*/,
                             const Progress& progress) {
    const Stopwatch time;
    const auto planar = closestPlanarAngles(piece.mesh, piece.boundary, progress);
    if (!planar) {
        return planar.error();
    }
    // A least squares conformal map meets consistent angles exactly; if the iteration did not
    // converge, it meets them approximately.
    const ConformalEnergy energy(piece.mesh.F, planar->angles,
                                 static_cast<int>(piece.mesh.V.rows()));
    const auto points = solvePinned(energy, farPairAlongEdges(piece), 1, progress);
    if (!points) {
        return points.error();
    }
    auto flat = atTrueSize(piece, *points, time);
    if (flat) {
        flat->interiorIterations = planar->iterations;
        if (planar->residual > kUnmet) {
            flat->notes.push_back(endedEarlyNote(
                piece, worded("the angles fit in the plane only to within %1 radians",
                              {shortest(planar->residual)})));
        }
    }
    return flat;
}

}  // namespace toile
