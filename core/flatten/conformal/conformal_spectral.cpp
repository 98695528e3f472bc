// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <Eigen/QR>
#include <Eigen/SVD>

#include "core/flatten/conformal/conformal_energy.h"
#include "core/flatten/interior/interior.h"

namespace toile {
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
