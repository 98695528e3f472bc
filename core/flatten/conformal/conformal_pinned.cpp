// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <complex>
#include <limits>

#include "core/flatten/conformal/conformal_energy.h"

namespace toile {
namespace {

/// Refinements after the first solution. Each gains the digits the factorisation has; the last one
/// is where the correction no longer shrinks.
constexpr int kMaxRefinements = 12;
/// A correction below this part of the solution is rounding.
constexpr double kNegligible = 1e-15;

}  // namespace

Result<Points2> solvePinned(const ConformalEnergy& energy, std::array<int, 2> pins, double distance,
                            const Progress& progress) {
    const int vertexCount = energy.vertexCount();
    std::vector<int> unknown(static_cast<std::size_t>(vertexCount), 0);
    unknown[pins[0]] = unknown[pins[1]] = -1;
    int count = 0;
    for (int& u : unknown) {
        u = u < 0 ? -1 : count++;
    }
    SymmetricBuilder builder(2 * count);
    energy.addTo(builder, unknown);
    const SymmetricMatrix matrix = builder.build();
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    SparseCholesky cholesky;
    const auto factorised = cholesky.factorise(matrix);
    if (!factorised) {
        return factorised.error();
    }
    // From "all free vertices at the first pin", every step solves for what is missing: the first
    // finds the solution as the normal equations see it, the others mend it.
    Eigen::VectorXcd z = Eigen::VectorXcd::Zero(vertexCount);
    z[pins[1]] = distance;
    double last = std::numeric_limits<double>::infinity();
    for (int step = 0; step <= kMaxRefinements && count > 0; ++step) {
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        const Eigen::VectorXcd gradient = energy.adjoint(energy.residual(z));
        Eigen::VectorXd right(2 * count);
        for (int v = 0; v < vertexCount; ++v) {
            if (const Eigen::Index u = unknown[v]; u >= 0) {
                right[2 * u] = -gradient[v].real();
                right[2 * u + 1] = -gradient[v].imag();
            }
        }
        const auto change = cholesky.solve(right);
        if (!change) {
            return change.error();
        }
        const double size = change->cwiseAbs().maxCoeff();
        if (!std::isfinite(size)) {
            return Error{ErrorCode::NotFinite, {}, "flat positions"};
        }
        if (step > 0 && size >= 0.5 * last) {
            break;  // nothing more to gain
        }
        for (int v = 0; v < vertexCount; ++v) {
            if (const Eigen::Index u = unknown[v]; u >= 0) {
                z[v] += std::complex<double>((*change)(2 * u, 0), (*change)(2 * u + 1, 0));
            }
        }
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
