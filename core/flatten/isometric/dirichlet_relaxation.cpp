// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <Eigen/LU>

#include "core/flatten/isometric/dirichlet_energy.h"
#include "core/geometry/buckets.h"

namespace toile::isometric {
namespace {

/// A move must promise to lower the energy of a vertex's triangles by this share.
constexpr double kWorthWhile = 0.02;
constexpr int kMovesPerVisit = 3;
constexpr int kMaxVertexHalvings = 8;
/// Newton's step is too short for squeezed triangles, so longer steps are tried.
constexpr double kVertexStretch = 1.7;
constexpr int kMaxStretches = 3;
/// Vertices between two checks for cancellation: some milliseconds.
constexpr int kVerticesPerLook = 1 << 12;

}  // namespace

double SymmetricDirichlet::starEnergy(const Points2& Q, std::span<const int> star) const {
    double sum = 0;
    for (const int f : star) {
        const Eigen::Matrix2d J = jacobian(Q, f);
        const double D = J.determinant();
        if (!(D > 0)) {
            return std::numeric_limits<double>::infinity();
        }
        sum += 0.25 * shapes_[f].area * J.squaredNorm() * (1 + 1 / (D * D));
    }
    return sum;
}

SymmetricDirichlet::VertexModel SymmetricDirichlet::vertexModel(const Points2& Q,
                                                                std::span<const int> star,
                                                                int v) const {
    VertexModel model;
    for (const int f : star) {
        const Shape& shape = shapes_[f];
        const int corner = mesh_.F(f, 0) == v ? 0 : mesh_.F(f, 1) == v ? 1 : 2;
        const Eigen::Vector2d b(shape.b[corner][0], shape.b[corner][1]);
        const Eigen::Matrix2d J = jacobian(Q, f);
        const double I = J.squaredNorm();
        const double D = J.determinant();
        const double over2 = 1 / (D * D);
        const double over3 = over2 / D;
        // How I / 2 and D change with the vertex; the second derivative of D is zero.
        const Eigen::Vector2d i = J * b;
        const Eigen::Vector2d d(J(1, 1) * b[0] - J(1, 0) * b[1], J(0, 0) * b[1] - J(0, 1) * b[0]);
        const double part = 0.25 * shape.area;
        model.energy += part * I * (1 + over2);
        model.gradient += part * (2 * (1 + over2) * i - 2 * I * over3 * d);
        model.stiffness += part * (2 * (1 + over2) * b.squaredNorm() * Eigen::Matrix2d::Identity() -
                                   4 * over3 * (i * d.transpose() + d * i.transpose()) +
                                   6 * I * over2 * over2 * d * d.transpose());
    }
    return model;
}

/// One Newton step of a vertex, shortened or stretched to lower the energy. False if no step lowers
/// the energy, or hardly any.
bool SymmetricDirichlet::relaxVertex(Points2& Q, std::span<const int> star, int v) const {
    const VertexModel model = vertexModel(Q, star, v);
    const Eigen::RowVector2d from = Q.row(v);
    const Eigen::RowVector2d step = (-model.stiffness.inverse() * model.gradient).transpose();
    if (!(-0.5 * step.dot(model.gradient) > kWorthWhile * model.energy)) {
        return false;
    }
    double t = 1;
    double reached = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kMaxVertexHalvings; ++k, t *= 0.5) {
        Q.row(v) = from + t * step;
        reached = starEnergy(Q, star);
        if (reached < model.energy) {
            break;
        }
    }
    if (!(reached < model.energy)) {
        Q.row(v) = from;
        return false;
    }
    for (int k = 0; k < kMaxStretches && t >= 1; ++k) {
        const Eigen::RowVector2d kept = Q.row(v);
        t *= kVertexStretch;
        Q.row(v) = from + t * step;
        const double further = starEnergy(Q, star);
        if (!(further < reached)) {
            Q.row(v) = kept;
            break;
        }
        reached = further;
    }
    return true;
}

void SymmetricDirichlet::relax(Points2& Q, const std::vector<int>& held, int passes,
                               const Progress& progress) const {
    const auto count = static_cast<int>(Q.rows());
    const geometry::Buckets<> stars(count, [this](auto add) {
        for (int k = 0; k < static_cast<int>(mesh_.F.size()); ++k) {
            add(mesh_.F.data()[k], k / 3);
        }
    });
    std::vector<char> isHeld(static_cast<std::size_t>(count), 0);
    for (const int v : held) {
        isHeld[v] = 1;
    }
    std::vector<char> waits(isHeld.size(), 1);
    bool any = true;
    for (int pass = 0; pass < passes && any; ++pass) {
        any = false;
        for (int v = 0; v < count; ++v) {
            if (v % kVerticesPerLook == 0 && progress.isCancelled()) {
                return;
            }
            if (isHeld[v] != 0 || waits[v] == 0) {
                continue;
            }
            waits[v] = 0;
            bool moved = false;
            for (int k = 0; k < kMovesPerVisit && relaxVertex(Q, stars[v], v); ++k) {
                moved = true;
            }
            if (!moved) {
                continue;
            }
            any = true;
            for (const int f : stars[v]) {
                for (int corner = 0; corner < 3; ++corner) {
                    waits[mesh_.F(f, corner)] = 1;
                }
            }
        }
    }
}

}  // namespace toile::isometric
