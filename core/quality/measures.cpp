// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/measures.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/geometry/segment.h"
#include "core/mesh/cotangents.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {
namespace {

template <class Points>
Eigen::VectorXd loopLengths(const Points& P, const std::vector<int>& boundary) {
    const int n = static_cast<int>(boundary.size());
    Eigen::VectorXd lengths(n);
    for (int i = 0; i < n; ++i) {
        lengths[i] = (P.row(boundary[(i + 1) % n]) - P.row(boundary[i])).norm();
    }
    return lengths;
}

template <class Points>
Eigen::MatrixX3d cornerAngles(const Points& P, const Triangles& F) {
    Eigen::MatrixX3d angles(F.rows(), 3);
    for (int f = 0; f < F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const auto at = P.row(F(f, k));
            angles(f, k) = geometry::angleBetween(P.row(F(f, (k + 1) % 3)) - at,
                                                  P.row(F(f, (k + 2) % 3)) - at);
        }
    }
    return angles;
}

template <class Points>
Eigen::VectorXd lengthsOf(const Points& P, const Edges& edges) {
    Eigen::VectorXd lengths(edges.rows());
    for (int e = 0; e < edges.rows(); ++e) {
        lengths[e] = (P.row(edges(e, 1)) - P.row(edges(e, 0))).norm();
    }
    return lengths;
}

}  // namespace

Eigen::VectorXd boundaryAngles3d(const MeshArrays& mesh, const std::vector<int>& boundary) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.V.rows());
    std::vector<char> wanted(static_cast<std::size_t>(mesh.V.rows()), 0);
    for (const int v : boundary) {
        wanted[v] = 1;
    }
    for (int f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int v = mesh.F(f, k);
            if (wanted[v] != 0) {
                sum[v] +=
                    geometry::angleBetween(mesh.V.row(mesh.F(f, (k + 1) % 3)) - mesh.V.row(v),
                                           mesh.V.row(mesh.F(f, (k + 2) % 3)) - mesh.V.row(v));
            }
        }
    }
    Eigen::VectorXd angles(boundary.size());
    for (int i = 0; i < angles.size(); ++i) {
        angles[i] = sum[boundary[i]];
    }
    return angles;
}

Eigen::VectorXd boundaryAngles2d(const Points2& Q, const std::vector<int>& boundary) {
    const int n = static_cast<int>(boundary.size());
    Eigen::VectorXd angles(n);
    for (int i = 0; i < n; ++i) {
        const Eigen::RowVector2d at = Q.row(boundary[i]);
        const Eigen::RowVector2d forward = Q.row(boundary[(i + 1) % n]) - at;
        const Eigen::RowVector2d backward = Q.row(boundary[(i + n - 1) % n]) - at;
        const double angle = geometry::turnBetween(forward, backward);
        angles[i] = angle < 0 ? angle + 2 * std::numbers::pi : angle;
    }
    return angles;
}

Eigen::VectorXd boundaryLengths3d(const Points3& V, const std::vector<int>& boundary) {
    return loopLengths(V, boundary);
}

Eigen::VectorXd boundaryLengths2d(const Points2& Q, const std::vector<int>& boundary) {
    return loopLengths(Q, boundary);
}

Eigen::VectorXd edgeLengths3d(const Points3& V, const Edges& edges) {
    return lengthsOf(V, edges);
}

Eigen::VectorXd edgeLengths2d(const Points2& Q, const Edges& edges) {
    return lengthsOf(Q, edges);
}

Eigen::VectorXd triangleAreas3d(const MeshArrays& mesh) {
    Eigen::VectorXd areas(mesh.F.rows());
    for (int f = 0; f < mesh.F.rows(); ++f) {
        areas[f] = 0.5 * doubleAreaNormal(mesh, f).norm();
    }
    return areas;
}

Eigen::VectorXd triangleAreas2d(const Points2& Q, const Triangles& F) {
    Eigen::VectorXd areas(F.rows());
    for (int f = 0; f < F.rows(); ++f) {
        areas[f] =
            0.5 * geometry::cross(Q.row(F(f, 1)) - Q.row(F(f, 0)), Q.row(F(f, 2)) - Q.row(F(f, 0)));
    }
    return areas;
}

Eigen::MatrixX3d cornerAngles3d(const MeshArrays& mesh) {
    return cornerAngles(mesh.V, mesh.F);
}

Eigen::MatrixX3d cornerAngles2d(const Points2& Q, const Triangles& F) {
    return cornerAngles(Q, F);
}

Eigen::MatrixX2d singularValues(const MeshArrays& mesh, const Points2& Q) {
    Eigen::MatrixX2d values(mesh.F.rows(), 2);
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::Vector3d e1 = mesh.V.row(mesh.F(f, 1)) - mesh.V.row(mesh.F(f, 0));
        const Eigen::Vector3d e2 = mesh.V.row(mesh.F(f, 2)) - mesh.V.row(mesh.F(f, 0));
        const Eigen::Vector2d d1 = Q.row(mesh.F(f, 1)) - Q.row(mesh.F(f, 0));
        const Eigen::Vector2d d2 = Q.row(mesh.F(f, 2)) - Q.row(mesh.F(f, 0));
        // The triangle laid out in its own plane, e1 along x; then the map's two columns.
        const double x1 = e1.norm();
        const double x2 = e1.dot(e2) / x1;
        const double y2 = e1.cross(e2).norm() / x1;
        const Eigen::Vector2d u = d1 / x1;
        const Eigen::Vector2d v = (d2 - x2 * u) / y2;
        const double uu = u.squaredNorm();
        const double vv = v.squaredNorm();
        const double larger = std::sqrt((uu + vv + std::hypot(uu - vv, 2 * u.dot(v))) / 2);
        const double determinant = std::abs(geometry::cross(u, v));
        values(f, 0) = larger;
        values(f, 1) = larger > 0 ? determinant / larger : 0.0;
    }
    return values;
}

double piL(const Eigen::VectorXd& lengths3d, const Eigen::VectorXd& lengths2d) {
    return (lengths2d - lengths3d).cwiseAbs().mean();
}

double piTheta(const Eigen::VectorXd& alpha, const Eigen::VectorXd& theta) {
    const double turn = 2 * std::numbers::pi;
    return (theta - alpha)
        .unaryExpr([turn](double difference) { return std::abs(std::remainder(difference, turn)); })
        .mean();
}

double angleEnergy(const Eigen::VectorXd& alpha, const Eigen::VectorXd& theta) {
    double sum = 0;
    for (Eigen::Index i = 0; i < alpha.size(); ++i) {
        const double difference = std::remainder(theta[i] - alpha[i], 2 * std::numbers::pi);
        sum += difference * difference;
    }
    return 0.5 * sum;
}

double piE(const Eigen::VectorXd& lengths3d, const Eigen::VectorXd& lengths2d) {
    return (lengths2d / lengths2d.sum() - lengths3d / lengths3d.sum()).cwiseAbs().sum();
}

double piA(const Eigen::VectorXd& areas3d, const Eigen::VectorXd& areas2d) {
    const Eigen::VectorXd unsignedAreas = areas2d.cwiseAbs();
    return (unsignedAreas / unsignedAreas.sum() - areas3d / areas3d.sum()).cwiseAbs().sum();
}

double maxRelativeLengthError(const Eigen::VectorXd& lengths3d, const Eigen::VectorXd& lengths2d) {
    return (lengths2d.cwiseQuotient(lengths3d).array() - 1).abs().maxCoeff();
}

std::optional<double> symmetricDirichlet(const Eigen::MatrixX2d& singular,
                                         const Eigen::VectorXd& areas3d,
                                         const Eigen::VectorXd& areas2d) {
    if (flippedTriangles(areas2d, areas3d) > 0) {
        return std::nullopt;
    }
    const auto squares = singular.array().square();
    const double energy =
        (areas3d.array() * (squares + squares.inverse()).rowwise().sum()).sum() / areas3d.sum() / 4;
    return std::isfinite(energy) ? std::optional(energy) : std::nullopt;
}

QuasiConformal quasiConformal(const Eigen::MatrixX2d& singular, const Eigen::VectorXd& areas3d) {
    const Eigen::ArrayXd ratio = singular.col(0).array() / singular.col(1).array();
    if (!ratio.isFinite().all()) {
        return {};
    }
    return {(areas3d.array() * ratio).sum() / areas3d.sum(), ratio.maxCoeff()};
}

Eigen::VectorXd edgeStrain(const Eigen::VectorXd& lengths3d, const Eigen::VectorXd& lengths2d) {
    return lengths3d.cwiseQuotient(lengths2d).array() - 1;
}

int flippedTriangles(const Eigen::VectorXd& areas2d, const Eigen::VectorXd& areas3d) {
    return static_cast<int>((areas2d.array() <= kCollapsedShare * areas3d.array()).count());
}

Eigen::Index worstFlipped(const Eigen::VectorXd& areas2d, const Eigen::VectorXd& areas3d) {
    Eigen::Index worst = 0;
    (areas2d - kCollapsedShare * areas3d).minCoeff(&worst);
    return worst;
}

namespace {

/// Smaller products are scaled up by its inverse: a power of two, so that nothing is rounded.
constexpr double kTinyVector = 0x1p-300;

/// A sum of angles between 0 and pi, as a product of complex numbers that point in their
/// directions: one arc tangent at the end instead of one for each.
class AngleSum {
public:
    /// @param x, y  in the direction of the angle, y >= 0, at most about 1 in size
    void add(double x, double y) {
        const double before = y_;
        y_ = x_ * y + y_ * x;
        x_ = x_ * x - before * y;
        turns_ += before < 0 && y_ >= 0 ? 1 : 0;  // no angle is large enough to skip this
        if (std::abs(x_) + std::abs(y_) < kTinyVector) {
            x_ /= kTinyVector;
            y_ /= kTinyVector;
        }
    }

    double value() const {
        const double angle = std::atan2(y_ + 0.0, x_);  // -0 + 0 is 0
        return angle + 2 * std::numbers::pi * (turns_ + (angle < 0 ? 1 : 0));
    }

private:
    double x_ = 1;
    double y_ = 0;
    int turns_ = 0;
};

}  // namespace

Eigen::VectorXd vertexAngles3d(const MeshArrays& mesh) {
    std::vector<AngleSum> sums(static_cast<std::size_t>(mesh.V.rows()));
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const CornerProducts corners = cornerProducts(mesh, f);
        const double scale = 1 / (corners.at[0] + corners.at[1] + corners.at[2]);
        for (int k = 0; k < 3; ++k) {
            sums[mesh.F(f, k)].add(scale * corners.at[k], scale * corners.doubledArea);
        }
    }
    Eigen::VectorXd angles(mesh.V.rows());
    for (int v = 0; v < angles.size(); ++v) {
        angles[v] = sums[v].value();
    }
    return angles;
}

}  // namespace toile
