// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/settle.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/linalg/sparse_cholesky.h"
#include "core/sew/bending.h"
#include "core/sew/membrane.h"

namespace toile::sew {
namespace {

constexpr double kSufficientDecrease = 1e-4;
constexpr int kMaxHalvings = 12;
constexpr double kFirstCaution = 1;
constexpr double kLeastCaution = 1e-6;
constexpr double kMostCaution = 1e4;
constexpr double kBolder = 0.2;  // times the caution after a step that kept its promise
constexpr double kTimider = 10;  // and after one that had to be cut
constexpr double kKept = 0.5;    // of the promised fall
/// At caution 1, damping in parts of the membrane's stiffness against the largest bend that cloth
/// of this size can have: N/mm³.
constexpr double kDamping = 1e-4;
/// A fall below this part of the energy's terms is rounding.
constexpr double kRounding = 1e-14;

class Settling {
public:
    Settling(const Cloth& cloth, const WornSurface& surface, const SettleOptions& options)
        : options_(options),
          areas_(vertexAreas(cloth)),
          sewn_(sewnVertices(cloth)),
          membrane_(cloth, options.stiffness),
          bending_(cloth, options.stiffness.bending),
          contact_(surface, areas_, options.pressure, options.contactStiffness),
          H_(pairs(), static_cast<int>(cloth.X.rows())) {
        if (std::ranges::count(sewn_, 1) == 0) {
            std::ranges::fill(sewn_, 1);
        }
    }

    struct Point {
        Points3 X;
        std::vector<WornSurface::Place> places;
        double energy = 0;
        double scale = 0;  ///< of its terms, for what rounding makes of their sum
    };

    Point at(Points3 X) const {
        Point point{std::move(X), {}, 0, 0};
        point.places = contact_.placesOf(point.X);
        const double parts[] = {membrane_.energy(point.X), bending_.energy(point.X),
                                contact_.energy(point.places)};
        for (const double part : parts) {
            point.energy += part;
            point.scale += std::abs(part);
        }
        return point;
    }

    Points3 gradient(const Point& point) const {
        Points3 g = Points3::Zero(point.X.rows(), 3);
        membrane_.addGradient(point.X, g);
        bending_.addGradient(point.X, g);
        contact_.addGradient(point.places, g);
        return g;
    }

    /// The step that the quadratic model finds best.
    Result<Points3> step(const Point& point, const Points3& g, double caution) {
        H_.setZero();
        membrane_.addHessian(point.X, H_);
        bending_.addHessian(H_);
        contact_.addHessian(point.places, std::min(caution, 1.0), H_);
        for (Eigen::Index v = 0; v < areas_.size(); ++v) {
            H_.addToDiagonal(static_cast<int>(v), caution * kDamping * areas_[v]);
        }
        if (!isLaidOut_) {
            if (const auto done = factor_.analyse(H_.matrix()); !done) {
                return done.error();
            }
            isLaidOut_ = true;
        }
        if (const auto done = factor_.refactorise(H_.matrix()); !done) {
            return done.error();
        }
        const Eigen::MatrixXd right =
            -Eigen::Map<const Eigen::VectorXd>(g.data(), static_cast<Eigen::Index>(g.size()));
        const auto solved = factor_.solve(right);
        if (!solved) {
            return solved.error();
        }
        return Points3(Eigen::Map<const Points3>(solved->data(), g.rows(), 3));
    }

    /// Says of a result how far from rest it is.
    void judge(const Point& point, const Points3& g, SettledCloth& result) const {
        const Eigen::VectorXd rests = g.rowwise().norm();
        result.largestRest = rests.maxCoeff();
        result.restForce = rests.norm() / std::sqrt(static_cast<double>(rests.size()));
        Eigen::VectorXd sizes = options_.pressure * areas_;
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
        result.hasSettled = result.restForce <= options_.share * result.seamForce;
    }

private:
    std::vector<std::pair<int, int>> pairs() const {
        std::vector<std::pair<int, int>> all;
        membrane_.addPairs(all);
        bending_.addPairs(all);
        return all;
    }

    const SettleOptions& options_;
    Eigen::VectorXd areas_;
    std::vector<char> sewn_;
    Membrane membrane_;
    Bending bending_;
    Contact contact_;
    SpaceMatrix H_;
    linalg::SparseCholesky factor_;
    bool isLaidOut_ = false;
};

}  // namespace

Result<SettledCloth> settle(const Cloth& cloth, const Points3& start, const WornSurface& surface,
                            const SettleOptions& options, const Progress& progress) {
    Settling settling(cloth, surface, options);
    SettledCloth result;
    Settling::Point point = settling.at(start);
    if (!std::isfinite(point.energy)) {
        return Error{ErrorCode::NotFinite, {}, "the cloth's start"};
    }
    double caution = kFirstCaution;
    while (!progress.isCancelled()) {
        const Points3 g = settling.gradient(point);
        settling.judge(point, g, result);
        if (result.hasSettled || result.iterations >= options.maxIterations) {
            result.X = std::move(point.X);
            return result;
        }
        const auto P = settling.step(point, g, caution);
        if (!P) {
            return P.error();
        }
        ++result.iterations;
        const double slope = g.cwiseProduct(*P).sum();
        if (!std::isfinite(slope)) {
            return Error{ErrorCode::NotFinite, {}, "the cloth's step"};
        }
        double t = 1;
        bool hasMoved = false;
        for (int k = 0; k < kMaxHalvings && !hasMoved; ++k) {
            Settling::Point next = settling.at(point.X + t * *P);
            const double fall = point.energy - next.energy;
            // A fall that rounding hides is no reason to stay.
            const double hidden = kRounding * (point.scale + next.scale);
            hasMoved = fall >= -kSufficientDecrease * t * slope - hidden;
            if (hasMoved) {
                if (k == 0 && fall >= -kKept * slope / 2 - hidden) {
                    caution = std::max(kBolder * caution, kLeastCaution);
                } else if (k > 1) {
                    caution = std::min(kTimider * caution, kMostCaution);
                }
                point = std::move(next);
            }
            t /= 2;
        }
        if (!hasMoved) {
            if (caution >= kMostCaution) {
                result.X = std::move(point.X);
                return result;
            }
            caution = std::min(kTimider * caution, kMostCaution);
        }
        if (options.watch) {
            options.watch(point.X);
        }
        progress.step();
    }
    return Error{ErrorCode::Cancelled};
}

}  // namespace toile::sew
