// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <vector>

#include "core/mesh/cotangents.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// Below this a product is scaled up, by its inverse: a power of two, so that nothing is rounded.
constexpr double kSmall = 0x1p-300;

/// A sum of angles between 0 and pi, as a product of complex numbers that point in their
/// directions: one arc tangent at the end instead of one for each.
class AngleSum {
public:
    /// @param x, y  in the direction of the angle, y >= 0, at most about 1 in size
    void add(double x, double y) {
        const double before = y_;
        y_ = x_ * y + y_ * x;
        x_ = x_ * x - before * y;
        turns_ += before < 0 && y_ >= 0 ? 1 : 0;  // no angle is large enough to pass by below
        if (std::abs(x_) + std::abs(y_) < kSmall) {
            x_ /= kSmall;
            y_ /= kSmall;
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
