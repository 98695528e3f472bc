// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/settle.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/linalg/elimination_order.h"
#include "core/linalg/frontal_cholesky.h"
#include "core/sew/cloth_forces.h"

namespace toile::sew {
namespace {

constexpr double kSufficientDecrease = 1e-4;
constexpr int kMaxHalvings = 12;
constexpr double kFirstCaution = 1;
constexpr double kMinCaution = 1e-6;
constexpr double kMaxCaution = 1e4;
constexpr double kBolder = 0.2;  // factor on the caution after a step that kept its promise
constexpr double kTimider = 10;  // and after one that was cut
constexpr double kKept = 0.5;    // share of the predicted decrease
/// Smallest caution at the start of a stage, where less is held than before.
constexpr double kLetGoCaution = 0.01;
/// A decrease below this fraction of the energy's terms is rounding.
constexpr double kRounding = 1e-14;
/// N: a smaller residual force is rounding.
constexpr double kNoForce = 1e-12;
/// From this number of unknowns a longer search for an elimination order pays off.
constexpr int kDissected = 6000;
/// mm: a smaller step is useless.
constexpr double kNoMove = 1e-9;
/// Cloth this many times its size away from the design is in free fall.
constexpr double kFallen = 10;

// Pins are released in stages, and the surface hardens: steps in which vertices cross many of its
// edges are fine while it is soft, but must be cut when it is hard.
constexpr ClothHold kPinned{1, 0, 0};
constexpr ClothHold kHeldLoosely[] = {{1e-3, 0.1, 0.05}, {1e-4, 0.1, 0.05}, {1e-5, 0.1, 0.05}};
/// Pinned positions are rounded to 1 / kParts mm, so that the last digits of the start do not
/// matter.
constexpr double kParts = 65536;
constexpr ClothHold kLetGo{0, 0.3, 0.02};

std::vector<ClothHold> holdsOf(const SettleOptions& options) {
    std::vector<ClothHold> holds;
    if (options.heldFirst) {
        holds.push_back(kPinned);
        holds.insert(holds.end(), std::begin(kHeldLoosely), std::end(kHeldLoosely));
    }
    holds.push_back(kLetGo);
    holds.push_back({0, 1, options.share});
    return holds;
}

bool isAtRest(const SettledCloth& cloth, double share) {
    return cloth.restForce <= std::max(share * cloth.seamForce, kNoForce);
}

bool hasFallen(const Points3& X, const Points3& designed) {
    const auto size = (designed.colwise().maxCoeff() - designed.colwise().minCoeff()).norm();
    return (X.colwise().mean() - designed.colwise().mean()).norm() > kFallen * size;
}

class Settling {
public:
    Settling(const Cloth& cloth, const WornSurface& surface, const SettleOptions& options,
             const Progress& progress)
        : cloth_(cloth), forces_(cloth, surface, options, progress), factor_(options.threads) {}

    /// Iterates until the cloth is at rest as the hold requires, or no step helps.
    Result<void> settle(const ClothHold& hold, const SettleOptions& options,
                        const Progress& progress) {
        forces_.hold(hold);
        point_ = isTouching_ ? forces_.at(point_.X, point_) : forces_.at(result.X);
        isTouching_ = hold.contact > 0;
        caution_ = std::max(caution_, kLetGoCaution);
        while (!progress.isCancelled()) {
            const Points3 g = forces_.gradient(point_);
            forces_.judge(point_, g, result);
            if (isAtRest(result, hold.share) || result.iterations >= options.maxIterations ||
                hasFallen(point_.X, cloth_.X)) {
                keep();
                return {};
            }
            const auto P = step(g);
            if (!P) {
                return P.error();
            }
            ++result.iterations;
            const bool isStill = P->size() > 0 && P->cwiseAbs().maxCoeff() < kNoMove;
            if (isStill) {
                keep();
                return {};
            }
            if (P->size() == 0 || !take(*P, g)) {
                if (caution_ >= kMaxCaution) {
                    keep();
                    return {};
                }
                caution_ = std::min(kTimider * caution_, kMaxCaution);
            }
            if (options.watch) {
                options.watch(point_.X);
            }
            progress.step();
        }
        return Error{ErrorCode::Cancelled};
    }

    /// Starts from its X.
    SettledCloth result;

private:
    void keep() {
        result.X = point_.X;
        if (!isTouching_) {
            result.X = (kParts * result.X).array().round() / kParts;
        }
    }

    /// The optimal step of the quadratic model; an error if the model has no minimum.
    Result<Points3> step(const Points3& g) {
        const linalg::SymmetricMatrix& H = forces_.hessian(point_, caution_);
        if (layout_ != forces_.layout()) {
            const std::vector<int> order =
                H.size >= kDissected ? linalg::dissectedOrder(H, 3) : std::vector<int>{};
            if (const auto done = factor_.analyse(H, order); !done) {
                return done.error();
            }
            layout_ = forces_.layout();
        }
        if (const auto done = factor_.refactorise(H); !done) {
            if (done.error().code == ErrorCode::FactorisationFailed && caution_ < kMaxCaution) {
                return Points3(0, 3);
            }
            return done.error();
        }
        const Eigen::VectorXd right =
            -Eigen::Map<const Eigen::VectorXd>(g.data(), static_cast<Eigen::Index>(g.size()));
        const auto solved = factor_.solve(right);
        if (!solved) {
            return solved.error();
        }
        if (!solved->allFinite()) {
            return Error{ErrorCode::NotFinite, {}, "the cloth's step"};
        }
        return Points3(Eigen::Map<const Points3>(solved->data(), g.rows(), 3));
    }

    /// Moves along a step while the energy decreases. @return whether it moved
    bool take(const Points3& P, const Points3& g) {
        const double slope = g.cwiseProduct(P).sum();
        double t = forces_.freeWay(point_, P);
        for (int k = 0; k < kMaxHalvings; ++k, t /= 2) {
            ClothForces::Point next = forces_.at(point_.X + t * P, point_);
            const double fall = point_.energy - next.energy;
            // Accept a step whose decrease is hidden by rounding.
            const double hidden = kRounding * (point_.scale + next.scale);
            if (fall >= -kSufficientDecrease * t * slope - hidden) {
                if (k == 0 && fall >= -kKept * t * slope / 2 - hidden) {
                    caution_ = std::max(kBolder * caution_, kMinCaution);
                } else if (k > 1) {
                    caution_ = std::min(kTimider * caution_, kMaxCaution);
                }
                point_ = std::move(next);
                return true;
            }
        }
        return false;
    }

    const Cloth& cloth_;
    ClothForces forces_;
    ClothForces::Point point_;
    linalg::FrontalCholesky factor_;
    double caution_ = kFirstCaution;
    int layout_ = -1;          ///< of the matrix, for which the factor is laid out
    bool isTouching_ = false;  ///< the point records the surface sheet of each vertex
};

}  // namespace

Result<SettledCloth> settle(const Cloth& cloth, const Points3& start, const WornSurface& surface,
                            const SettleOptions& options, const Progress& progress) {
    if (cloth.F.rows() == 0) {
        return Error{ErrorCode::NoGeometry, {}, "the cloth has no triangles"};
    }
    if (!start.allFinite() || !cloth.X.allFinite()) {
        return Error{ErrorCode::NotFinite, {}, "the cloth's start"};
    }
    Settling settling(cloth, surface, options, progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    settling.result.X = start;
    for (const ClothHold& hold : holdsOf(options)) {
        if (const auto done = settling.settle(hold, options, progress); !done) {
            return done.error();
        }
    }
    settling.result.hasSettled = isAtRest(settling.result, options.share);
    return std::move(settling.result);
}

}  // namespace toile::sew
