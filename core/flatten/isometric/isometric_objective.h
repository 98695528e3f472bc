// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/flatten/boundary/length_constraints.h"
#include "core/flatten/isometric/dirichlet_energy.h"
#include "core/flatten/isometric/outline_terms.h"

namespace toile::isometric {

/// What the isometric descent makes small: the symmetric Dirichlet energy, a little stiffness of
/// the outline, and, where the outline must stay simple, the barrier. Linear cost per call. One
/// thread at a time: the Hessian is filled in place.
class IsometricObjective {
public:
    /// @param mesh, table  kept by reference  @param lengths  of the loops' edges
    IsometricObjective(const MeshArrays& mesh, const EdgeTable& table, EdgeLoops loops,
                       const Eigen::VectorXd& lengths, bool keepOutlineSimple);

    /// The objective at a point, with the contacts found there.
    struct Value {
        double total = 0;  ///< infinite where a triangle has no area
        std::vector<OutlineBarrier::Contact> contacts;
    };

    Value evaluate(const Points2& Q) const;
    /// The symmetric Dirichlet energy alone.
    double distortion(const Points2& Q) const { return energy_.energy(Q); }
    /// Zero at the vertices of an outline that is held.
    Points2 gradient(const Points2& Q, const Value& at) const;

    /// The Hessian, positive semidefinite; an outline that is held is stiff beyond measure.
    /// Contacts may change its pattern.
    struct Hessian {
        linalg::BlockMatrix& matrix;
        bool samePattern;  ///< as in the call before
    };

    Hessian hessian(const Points2& Q, const Value& at);

    /// Moves single interior vertices where that lowers the energy by more than a little
    /// (SymmetricDirichlet::relax).
    void relax(Points2& Q, int passes, const Progress& progress) const {
        energy_.relax(Q, loops_.vertices(), passes, progress);
    }

    /// How far along P, up to `limit`, no triangle loses its area and no contact comes to pass.
    double largestStep(const Points2& Q, const Points2& P, double limit) const;

private:
    bool layOut(const std::vector<OutlineBarrier::Contact>& contacts);

    const EdgeTable& table_;
    EdgeLoops loops_;
    int vertexCount_;
    SymmetricDirichlet energy_;
    OutlineBending bending_;
    std::vector<OutlineBarrier> barriers_;  ///< one per loop, where loops must stay simple
    std::optional<linalg::BlockMatrix> matrix_;
    std::vector<std::pair<int, int>> extra_;  ///< pairs in the pattern beyond the mesh's edges
    std::vector<int> edgeOf_;                 ///< number of each mesh edge in the pattern
};

/// Where a quadratic model of the isometric descent is laid out. Refers to what is the caller's.
struct ModelPoint {
    const Points2& Q;
    const IsometricObjective::Value& at;  ///< the objective there
    const Eigen::VectorXd& multipliers;   ///< of the boundary lengths
};

/// How stiff the augmented Lagrangian makes the length of each boundary edge: some ten thousand
/// times what the objective does there, so that each back-substitution lowers the violation of the
/// linearised lengths by about that factor. @param hessian  of the objective, one vertex held
Eigen::VectorXd lengthStiffness(const linalg::BlockMatrix& hessian, const EdgeLoops& loops);

/// Holds a vertex by a spring as stiff as it is itself: translations cost nothing, and this takes
/// their freedom and no other.
void addSpring(linalg::BlockMatrix& hessian, int v);

/// Makes the Hessian of the objective, one vertex held, the matrix of the augmented Lagrangian:
/// adds the boundary lengths with their stiffness, and a part of the diagonal.
/// @param regularisation  that part: rotations are nearly free
void addLengths(linalg::BlockMatrix& hessian, const LengthConstraints& constraints,
                const ModelPoint& point, const Eigen::VectorXd& stiffness, double regularisation);

}  // namespace toile::isometric
