// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/sew/bending.h"
#include "core/sew/contact.h"
#include "core/sew/membrane.h"
#include "core/sew/self_contact.h"
#include "core/sew/settle.h"

namespace toile::sew {

/// What holds cloth besides itself, for a while.
struct ClothHold {
    double pin = 0;       ///< of springs to `Cloth::X`, N/mm³: per area of cloth
    double contact = 1;   ///< times the surface's stiffness; 0: no surface
    double share = 1e-3;  ///< it is over at this rest of force, as in `SettleOptions`
};

/// Everything that acts on sewn cloth, and its second derivative. Keeps references to all it is
/// given. N, mm.
class ClothForces {
public:
    /// Cancelled: ends soon, and is of no use.
    ClothForces(const Cloth& cloth, const WornSurface& surface, const SettleOptions& options,
                const Progress& progress = {});

    struct Point {
        Points3 X;
        std::vector<WornSurface::Place> places{};
        std::vector<SelfContact::Touch> touches{};  ///< of cloth with cloth
        double energy = 0;
        double scale = 0;  ///< of its terms, for what rounding makes of their sum
    };

    /// Of the points that are looked at from here on.
    void hold(const ClothHold& hold);
    Point at(Points3 X) const;
    /// As it is after a step from another point, on whose sheet of the surface it stays.
    Point at(Points3 X, const Point& before) const;
    Points3 gradient(const Point& point) const;
    /// A positive definite matrix near the second derivative.
    /// @param caution  how much dearer steps are made than they are
    const linalg::SymmetricMatrix& hessian(const Point& point, double caution);
    /// Grows with each new pattern of the matrix that `hessian` gives: where cloth has come to
    /// touch itself elsewhere.
    int layout() const { return layout_; }
    /// The part of a step from a point that can be gone, in (0, 1].
    double freeWay(const Point& point, const Points3& step) const;
    /// Says of a result how far from rest it is; not whether it has settled.
    void judge(const Point& point, const Points3& g, SettledCloth& result) const;

private:
    void weigh(Point& point) const;
    bool touchesItself() const { return self_ && hold_.contact > 0; }
    double selfStiffness() const { return hold_.contact * options_.contactStiffness; }
    void layOut(const Point& point);
    std::vector<std::pair<int, int>> pairs() const;
    ContactForces contactForces() const;

    const Cloth& cloth_;
    const SettleOptions& options_;
    Eigen::VectorXd areas_;
    Eigen::VectorXd weights_;  ///< of the vertices, N
    std::vector<char> sewn_;
    Membrane membrane_;
    Bending bending_;
    ClothHold hold_;
    Contact contact_;
    std::optional<SelfContact> self_;
    std::vector<std::pair<int, int>> touching_;  ///< ascending: that the pattern has for it
    int layout_ = 0;
    SpaceMatrix bentH_;  ///< of bending alone, which is the same everywhere
    SpaceMatrix H_;
};

}  // namespace toile::sew
