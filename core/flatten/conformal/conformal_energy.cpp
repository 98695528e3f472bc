// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/conformal/conformal_energy.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include <Eigen/Geometry>

#include "core/flatten/interior/interior.h"

namespace toile {
namespace {

using Complex = std::complex<double>;

/// Refinements after the first solution. Each gains as many digits as the factorisation has; the
/// last one is reached when the correction no longer shrinks.
constexpr int kMaxRefinements = 12;
/// A correction below this part of the solution is rounding.
constexpr double kNegligible = 1e-15;

/// Row of a triangle in its own plane, given the second and third corner relative to the first.
/// Scaled so that 2 sqrt(A) = 1, which makes the opposite edges the row itself.
Eigen::RowVector3cd rowOf(Complex second, Complex third) {
    const double doubleArea = std::imag(std::conj(second) * third);
    const double scale = 1 / std::sqrt(2 * doubleArea);
    return Eigen::RowVector3cd(third - second, -third, second) * scale;
}

}  // namespace

ConformalEnergy::ConformalEnergy(const MeshArrays& mesh)
    : F_(mesh.F), rows_(mesh.F.rows(), 3), vertexCount_(static_cast<int>(mesh.V.rows())) {
    for (int f = 0; f < F_.rows(); ++f) {
        const Eigen::Vector3d a = mesh.V.row(F_(f, 1)) - mesh.V.row(F_(f, 0));
        const Eigen::Vector3d b = mesh.V.row(F_(f, 2)) - mesh.V.row(F_(f, 0));
        const double length = a.norm();
        rows_.row(f) = rowOf(length, Complex(a.dot(b), a.cross(b).norm()) / length);
    }
}

ConformalEnergy::ConformalEnergy(const Triangles& F, const Eigen::MatrixX3d& angles,
                                 int vertexCount)
    : F_(F), rows_(F.rows(), 3), vertexCount_(vertexCount) {
    for (int f = 0; f < F_.rows(); ++f) {
        // Sides are proportional to the sines of the opposite angles.
        const Complex second = std::sin(angles(f, 2));
        const Complex third = std::polar(std::sin(angles(f, 1)), angles(f, 0));
        rows_.row(f) = rowOf(second, third);
    }
}

Eigen::VectorXcd ConformalEnergy::residual(const Eigen::VectorXcd& z) const {
    Eigen::VectorXcd result(F_.rows());
    for (int f = 0; f < F_.rows(); ++f) {
        // A row sums to zero: use differences first, because the triangle's position costs digits.
        const Complex origin = z[F_(f, 0)];
        result[f] = rows_(f, 1) * (z[F_(f, 1)] - origin) + rows_(f, 2) * (z[F_(f, 2)] - origin);
    }
    return result;
}

Eigen::VectorXcd ConformalEnergy::adjoint(const Eigen::VectorXcd& r) const {
    Eigen::VectorXcd result = Eigen::VectorXcd::Zero(vertexCount_);
    for (int f = 0; f < F_.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            result[F_(f, k)] += std::conj(rows_(f, k)) * r[f];
        }
    }
    return result;
}

void ConformalEnergy::addTo(linalg::SymmetricBuilder& builder,
                            const std::vector<int>& unknown) const {
    for (int f = 0; f < F_.rows(); ++f) {
        for (int j = 0; j < 3; ++j) {
            const int v = unknown[F_(f, j)];
            if (v < 0) {
                continue;
            }
            const double square = std::norm(rows_(f, j));
            builder.add(2 * v, 2 * v, square);
            builder.add(2 * v + 1, 2 * v + 1, square);
            for (int k = j + 1; k < 3; ++k) {
                const int w = unknown[F_(f, k)];
                if (w < 0) {
                    continue;
                }
                const Complex entry = std::conj(rows_(f, j)) * rows_(f, k);
                builder.add(2 * v, 2 * w, entry.real());
                builder.add(2 * v, 2 * w + 1, -entry.imag());
                builder.add(2 * v + 1, 2 * w, entry.imag());
                builder.add(2 * v + 1, 2 * w + 1, entry.real());
            }
        }
    }
}

Result<Eigen::VectorXcd> solveFree(const linalg::SparseCholesky& cholesky,
                                   const std::vector<int>& unknown, const Eigen::VectorXcd& right) {
    const auto count = std::ranges::count_if(unknown, [](int u) { return u >= 0; });
    Eigen::VectorXd split(2 * count);
    for (Eigen::Index v = 0; v < right.size(); ++v) {
        if (const Eigen::Index u = unknown[v]; u >= 0) {
            split.segment<2>(2 * u) << right[v].real(), right[v].imag();
        }
    }
    const auto solved = cholesky.solve(split);
    if (!solved) {
        return solved.error();
    }
    Eigen::VectorXcd z = Eigen::VectorXcd::Zero(right.size());
    for (Eigen::Index v = 0; v < z.size(); ++v) {
        if (const Eigen::Index u = unknown[v]; u >= 0) {
            z[v] = {(*solved)(2 * u, 0), (*solved)(2 * u + 1, 0)};
        }
    }
    return z;
}

Result<Points2> solvePinned(const ConformalEnergy& energy, std::array<int, 2> pins, double distance,
                            const Progress& progress) {
    const int vertexCount = energy.vertexCount();
    const int count = vertexCount - static_cast<int>(pins.size());
    const std::vector<int> unknown = unknownsBut(pins, vertexCount);
    linalg::SymmetricBuilder builder(2 * count);
    energy.addTo(builder, unknown);
    const linalg::SymmetricMatrix matrix = builder.build();
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    linalg::SparseCholesky cholesky;
    const auto factorised = cholesky.factorise(matrix);
    if (!factorised) {
        return factorised.error();
    }
    // Starts with all free vertices at the first pin; every step solves for the remaining error:
    // the first solves the normal equations, the others restore precision.
    Eigen::VectorXcd z = Eigen::VectorXcd::Zero(vertexCount);
    z[pins[1]] = distance;
    double last = std::numeric_limits<double>::infinity();
    for (int step = 0; step <= kMaxRefinements && count > 0; ++step) {
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        const auto change = solveFree(cholesky, unknown, -energy.adjoint(energy.residual(z)));
        if (!change) {
            return change.error();
        }
        const double size =
            std::max(change->real().cwiseAbs().maxCoeff(), change->imag().cwiseAbs().maxCoeff());
        if (!std::isfinite(size)) {
            return Error{ErrorCode::NotFinite, {}, "flat positions"};
        }
        if (step > 0 && size >= 0.5 * last) {
            break;  // nothing more to gain
        }
        z += *change;
        if (size <= kNegligible * z.cwiseAbs().maxCoeff()) {
            break;
        }
        last = step == 0 ? last : size;
    }
    Points2 Q(vertexCount, 2);
    Q << z.real(), z.imag();
    return Q;
}

}  // namespace toile
