// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/flat_energy.h"

#include <limits>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

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

FlatEnergy::FlatEnergy(const MeshArrays& mesh, const EdgeTable& table)
    : mesh_(mesh), table_(table), shapes_(static_cast<std::size_t>(mesh.F.rows())) {
    double whole = 0;
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::Vector3d a = mesh.V.row(mesh.F(f, 1)) - mesh.V.row(mesh.F(f, 0));
        const Eigen::Vector3d b = mesh.V.row(mesh.F(f, 2)) - mesh.V.row(mesh.F(f, 0));
        // The triangle laid into the plane: corners (0, 0), (x1, 0), (x2, y2).
        const double x1 = a.norm();
        const double x2 = a.dot(b) / x1;
        const double y2 = a.cross(b).norm() / x1;
        Shape& shape = shapes_[f];
        shape.area = 0.5 * x1 * y2;
        shape.b[0][0] = -1 / x1;
        shape.b[0][1] = (x2 / x1 - 1) / y2;
        shape.b[1][0] = 1 / x1;
        shape.b[1][1] = -x2 / (x1 * y2);
        shape.b[2][0] = 0;
        shape.b[2][1] = 1 / y2;
        whole += shape.area;
    }
    for (Shape& shape : shapes_) {
        shape.area /= whole;
    }
}

EnergyModel EnergyModel::onVertices(const std::vector<int>& kept) const {
    EnergyModel fewer = *this;
    if (cloth && cloth->warp.rows() > 1) {
        auto part = std::make_shared<PieceCloth>(*cloth);
        part->warp = Points3::Zero(static_cast<Eigen::Index>(kept.size()), 3);
        for (Eigen::Index v = 0; v < part->warp.rows(); ++v) {
            if (kept[v] < cloth->warp.rows()) {
                part->warp.row(v) = cloth->warp.row(kept[v]);
            }
        }
        fewer.cloth = std::move(part);
    }
    return fewer;
}

double FlatEnergy::largestStep(const Points2& Q, const Points2& P, double limit) const {
    double most = limit;
    for (int f = 0; f < mesh_.F.rows(); ++f) {
        const Eigen::RowVector2d e1 = Q.row(mesh_.F(f, 1)) - Q.row(mesh_.F(f, 0));
        const Eigen::RowVector2d e2 = Q.row(mesh_.F(f, 2)) - Q.row(mesh_.F(f, 0));
        const Eigen::RowVector2d d1 = P.row(mesh_.F(f, 1)) - P.row(mesh_.F(f, 0));
        const Eigen::RowVector2d d2 = P.row(mesh_.F(f, 2)) - P.row(mesh_.F(f, 0));
        // Twice the area along the step: c + b t + a t^2, c > 0. Find its smallest positive root.
        const double a = d1.x() * d2.y() - d1.y() * d2.x();
        const double b = e1.x() * d2.y() - e1.y() * d2.x() + d1.x() * e2.y() - d1.y() * e2.x();
        const double c = e1.x() * e2.y() - e1.y() * e2.x();
        if (a * most * most + b * most + c > 0 && !(b < 0 && a > 0)) {
            continue;  // no root ahead: concave or rising all the way
        }
        for (const double root : quadraticRoots(a, b, c)) {
            if (root > 0 && root < most) {
                most = root;
            }
        }
    }
    return most;
}

/// One Newton step of a vertex, shortened or stretched to lower the energy. False if no step lowers
/// the energy, or hardly any.
bool FlatEnergy::relaxVertex(Points2& Q, std::span<const int> star, int v) const {
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

void FlatEnergy::relax(Points2& Q, const std::vector<int>& held, int passes,
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
