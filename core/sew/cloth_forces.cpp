// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/cloth_forces.h"

#include <algorithm>
#include <cmath>

namespace toile::sew {
namespace {

/// Damping at caution 1, as a fraction of the membrane's stiffness against the largest bend of
/// cloth of this size: N/mm³.
constexpr double kDamping = 1e-4;

/// Cloth closer than this multiple of its thickness may soon touch.
constexpr double kNearlyTouching = 3;

constexpr double kGramsPerArea = 1e-9;  // g/m² m/s² in N/mm²

/// Gravity on the vertices, N.
Eigen::VectorXd weightsOf(const Cloth& cloth, const SettleOptions& options) {
    const Eigen::VectorXd areas = restAreas(cloth);
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(cloth.X.rows());
    for (Eigen::Index f = 0; f < cloth.F.rows(); ++f) {
        const double load = kGramsPerArea * options.gravity *
                            stiffnessOf(options.stiffness, cloth.pieceOf[f]).weight;
        for (int k = 0; k < 3; ++k) {
            weights[cloth.F(f, k)] += load * areas[f] / 3;
        }
    }
    return weights;
}

}  // namespace

ClothForces::ClothForces(const Cloth& cloth, const WornSurface& surface,
                         const SettleOptions& options, const Progress& progress)
    : cloth_(cloth),
      options_(options),
      areas_(vertexAreas(cloth)),
      weights_(weightsOf(cloth, options)),
      sewn_(sewnVertices(cloth)),
      membrane_(cloth, options.stiffness),
      bending_(cloth, options.stiffness),
      contact_(surface, areas_, contactForces(), options.threads),
      bentH_(pairs(), static_cast<int>(cloth.X.rows())),
      H_(bentH_) {
    bending_.addHessian(bentH_);
    if (options.touchesItself) {
        self_.emplace(cloth, options.thickness, options.threads, progress);
    }
    if (std::ranges::count(sewn_, 1) == 0) {
        std::ranges::fill(sewn_, 1);
    }
}

ContactForces ClothForces::contactForces() const {
    const double whole = areas_.sum();
    return {options_.pressure, (hold_.contact > 0 ? hold_.contact : 1) * options_.contactStiffness,
            whole > 0 ? weights_.cwiseAbs().sum() / whole : 0};
}

void ClothForces::hold(const ClothHold& hold) {
    hold_ = hold;
    contact_.set(contactForces());
}

ClothForces::Point ClothForces::at(Points3 X) const {
    Point point{.X = std::move(X)};
    point.places = contact_.placesOf(point.X);
    weigh(point);
    return point;
}

ClothForces::Point ClothForces::at(Points3 X, const Point& before) const {
    Point point{.X = std::move(X)};
    point.places =
        hold_.contact > 0 ? contact_.placesOf(point.X, before.X, before.places) : before.places;
    weigh(point);
    return point;
}

void ClothForces::weigh(Point& point) const {
    if (touchesItself()) {
        point.touches = self_->touchesAt(point.X, self_->thickness());
    }
    const Points3 moved = point.X - cloth_.X;
    const double parts[] = {
        membrane_.energy(point.X),
        bending_.energy(point.X),
        hold_.contact > 0 ? contact_.energy(point.places) : 0,
        touchesItself() ? self_->energy(point.touches, selfStiffness()) : 0,
        hold_.pin / 2 * areas_.dot(moved.rowwise().squaredNorm()),
        weights_.dot(moved.col(1)),
    };
    for (const double part : parts) {
        point.energy += part;
        point.scale += std::abs(part);
    }
}

Points3 ClothForces::gradient(const Point& point) const {
    Points3 g = hold_.pin * (areas_.asDiagonal() * (point.X - cloth_.X));
    g.col(1) += weights_;
    membrane_.addGradient(point.X, g);
    bending_.addGradient(point.X, g);
    if (hold_.contact > 0) {
        contact_.addGradient(point.places, g);
    }
    if (touchesItself()) {
        self_->addGradient(point.touches, selfStiffness(), g);
    }
    return g;
}

const linalg::SymmetricMatrix& ClothForces::hessian(const Point& point, double caution) {
    if (touchesItself()) {
        layOut(point);
    }
    H_ = bentH_;
    membrane_.addHessian(point.X, H_, options_.threads);
    if (hold_.contact > 0) {
        contact_.addHessian(point.places, std::min(caution, 1.0), H_);
    }
    if (touchesItself()) {
        self_->addHessian(point.touches, selfStiffness(), H_);
    }
    for (Eigen::Index v = 0; v < areas_.size(); ++v) {
        H_.addToDiagonal(static_cast<int>(v), (hold_.pin + caution * kDamping) * areas_[v]);
    }
    return H_.matrix();
}

void ClothForces::judge(const Point& point, const Points3& g, SettledCloth& result) const {
    const Eigen::VectorXd rests = g.rowwise().norm();
    result.largestRest = rests.maxCoeff();
    result.restForce = rests.norm() / std::sqrt(static_cast<double>(rests.size()));
    Eigen::VectorXd sizes = std::abs(options_.pressure) * areas_ + weights_.cwiseAbs();
    membrane_.addForceSizes(point.X, sizes);
    double sum = 0;
    int count = 0;
    for (Eigen::Index v = 0; v < sizes.size(); ++v) {
        if (sewn_[v] != 0) {
            sum += sizes[v] * sizes[v];
            ++count;
        }
    }
    result.seamForce = std::sqrt(sum / count);
}

double ClothForces::freeWay(const Point& point, const Points3& step) const {
    return touchesItself() ? self_->freeWay(point.X, step) : 1;
}

void ClothForces::layOut(const Point& point) {
    std::vector<std::pair<int, int>> now;
    self_->addPairs(point.touches, now);
    const auto isKnown = [this](const auto& pair) {
        return std::ranges::binary_search(touching_, pair);
    };
    if (std::ranges::all_of(now, isKnown)) {
        return;
    }
    // Includes pairs that may touch soon, so that the pattern stays valid for some steps.
    touching_.clear();
    self_->addPairs(self_->touchesAt(point.X, kNearlyTouching * self_->thickness()), touching_);
    std::ranges::sort(touching_);
    std::vector<std::pair<int, int>> all = pairs();
    all.insert(all.end(), touching_.begin(), touching_.end());
    bentH_ = SpaceMatrix(std::move(all), static_cast<int>(cloth_.X.rows()));
    bending_.addHessian(bentH_);
    ++layout_;
}

std::vector<std::pair<int, int>> ClothForces::pairs() const {
    std::vector<std::pair<int, int>> all;
    membrane_.addPairs(all);
    bending_.addPairs(all);
    return all;
}

}  // namespace toile::sew
