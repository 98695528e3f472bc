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

/// External supports of the cloth during one stage.
struct ClothHold {
    double pin = 0;       ///< stiffness of springs to `Cloth::X`, N/mm³: per area of cloth
    double contact = 1;   ///< factor on the surface's stiffness; 0: no surface
    double share = 1e-3;  ///< the stage ends at this residual force, as in `SettleOptions`
};

/// All forces on sewn cloth, and their derivative. Keeps references to its arguments. N, mm.
class ClothForces {
public:
    /// After a cancel it returns soon and is unusable.
    ClothForces(const Cloth& cloth, const WornSurface& surface, const SettleOptions& options,
                const Progress& progress = {});

    struct Point {
        Points3 X;
        std::vector<WornSurface::Place> places{};
        std::vector<SelfContact::Touch> touches{};  ///< of cloth with cloth
        double energy = 0;
        double scale = 0;  ///< sum of its terms' sizes, to estimate rounding
    };

    /// Sets the hold for all following points.
    void hold(const ClothHold& hold);
    Point at(Points3 X) const;
    /// The point after a step from `before`; vertices stay on their sheets of the surface.
    Point at(Points3 X, const Point& before) const;
    Points3 gradient(const Point& point) const;
    /// A positive definite matrix near the second derivative.
    /// @param caution  factor on the damping of steps
    const linalg::SymmetricMatrix& hessian(const Point& point, double caution);
    /// Incremented with each new sparsity pattern of the `hessian` matrix, when cloth touches
    /// itself at other places.
    int layout() const { return layout_; }
    /// The fraction of a step from a point that is free of collisions, in (0, 1].
    double freeWay(const Point& point, const Points3& step) const;
    /// Writes the residual forces to a result, but not whether it has settled.
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
    std::vector<std::pair<int, int>> touching_;  ///< ascending: pairs in the sparsity pattern
    int layout_ = 0;
    SpaceMatrix bentH_;  ///< of bending alone, which is constant
    SpaceMatrix H_;
};

}  // namespace toile::sew
