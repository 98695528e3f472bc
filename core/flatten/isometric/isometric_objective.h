// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/flatten/boundary/length_constraints.h"
#include "core/flatten/isometric/flat_energy.h"
#include "core/flatten/isometric/outline_terms.h"

namespace toile::isometric {

/// The objective of the isometric descent: the energy of the triangles, a little stiffness of
/// the outline, and the barrier if the outline must stay simple. Linear cost per call. One thread
/// at a time: the Hessian is filled in place.
class IsometricObjective {
public:
    /// @param mesh, table  stored by reference  @param lengths  of the loops' edges
    IsometricObjective(const MeshArrays& mesh, const EdgeTable& table, EdgeLoops loops,
                       const Eigen::VectorXd& lengths, bool keepOutlineSimple,
                       const EnergyModel& model = {});

    /// The objective at a point, with the contacts found there.
    struct Value {
        double total = 0;  ///< infinite if a triangle has no area
        std::vector<OutlineBarrier::Contact> contacts;
    };

    Value evaluate(const Points2& Q) const;
    /// The energy of the triangles alone.
    double distortion(const Points2& Q) const { return energy_->energy(Q); }
    /// Zero at the vertices of a held outline.
    Points2 gradient(const Points2& Q, const Value& at) const;

    /// The Hessian, positive semidefinite; a held outline is practically rigid. Contacts may change
    /// its pattern.
    struct Hessian {
        linalg::BlockMatrix& matrix;
        bool samePattern;  ///< as in the call before
    };

    Hessian hessian(const Points2& Q, const Value& at);

    /// Moves single interior vertices if that lowers the energy noticeably
    /// (FlatEnergy::relax).
    void relax(Points2& Q, int passes, const Progress& progress) const {
        energy_->relax(Q, loops_.vertices(), passes, progress);
    }

    /// The largest step along P, up to `limit`, before a triangle loses its area or sides touch.
    double largestStep(const Points2& Q, const Points2& P, double limit) const;

private:
    bool layOut(const std::vector<OutlineBarrier::Contact>& contacts);

    const EdgeTable& table_;
    EdgeLoops loops_;
    int vertexCount_;
    std::unique_ptr<FlatEnergy> energy_;
    OutlineBending bending_;
    std::vector<OutlineBarrier> barriers_;  ///< one per loop if loops must stay simple
    std::optional<linalg::BlockMatrix> matrix_;
    std::vector<std::pair<int, int>> extra_;  ///< pairs in the pattern beyond the mesh's edges
    std::vector<int> edgeOf_;                 ///< number of each mesh edge in the pattern
};

/// The point of a quadratic model of the isometric descent. Refers to data of the caller.
struct ModelPoint {
    const Points2& Q;
    const IsometricObjective::Value& at;  ///< the objective there
    const Eigen::VectorXd& multipliers;   ///< of the boundary lengths
};

/// Stiffness of the length of each boundary edge in the augmented Lagrangian: about ten thousand
/// times that of the objective there, so that each back-substitution lowers the violation of the
/// linearised lengths by about that factor. @param hessian  of the objective, one vertex held
Eigen::VectorXd lengthStiffness(const linalg::BlockMatrix& hessian, const EdgeLoops& loops);

/// Holds a vertex by a spring as stiff as the vertex itself. Translations cost nothing; this
/// removes their freedom and no other.
void addSpring(linalg::BlockMatrix& hessian, int v);

/// Turns the Hessian of the objective, one vertex held, into the matrix of the augmented
/// Lagrangian: adds the boundary lengths with their stiffness, and a share of the diagonal.
/// @param regularisation  that share; needed because rotations are nearly free
void addLengths(linalg::BlockMatrix& hessian, const LengthConstraints& constraints,
                const ModelPoint& point, const Eigen::VectorXd& stiffness, double regularisation);

}  // namespace toile::isometric
