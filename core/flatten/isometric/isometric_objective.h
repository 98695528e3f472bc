// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/flatten/isometric/dirichlet_energy.h"
#include "core/flatten/isometric/outline_barrier.h"
#include "core/flatten/isometric/outline_bending.h"

namespace toile {

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
    Points2 gradient(const Points2& Q, const Value& at) const;

    /// The Hessian, positive semidefinite. Contacts may change its pattern.
    struct Hessian {
        BlockMatrix& matrix;
        bool samePattern;  ///< as in the call before
    };

    Hessian hessian(const Points2& Q, const Value& at);

    /// Moves single interior vertices where that lowers the energy by more than a little
    /// (SymmetricDirichlet::relax).
    void relax(Points2& Q, int passes, const Progress& progress) const {
        energy_.relax(Q, onBoundary_, passes, progress);
    }

    /// How far along P, up to `limit`, no triangle loses its area and no contact comes to pass.
    double largestStep(const Points2& Q, const Points2& P, double limit) const;

private:
    bool layOut(const std::vector<OutlineBarrier::Contact>& contacts);

    const EdgeTable& table_;
    EdgeLoops loops_;
    int vertexCount_;
    std::vector<char> onBoundary_;  ///< by vertex
    SymmetricDirichlet energy_;
    OutlineBending bending_;
    std::vector<OutlineBarrier> barriers_;  ///< one per loop, where loops must stay simple
    std::optional<BlockMatrix> matrix_;
    std::vector<std::pair<int, int>> extra_;  ///< pairs in the pattern beyond the mesh's edges
    std::vector<int> edgeOf_;                 ///< number of each mesh edge in the pattern
};

}  // namespace toile
