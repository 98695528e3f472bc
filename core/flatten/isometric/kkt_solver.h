// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/isometric/isometric_objective.h"
#include "core/flatten/isometric/two_level_solver.h"
#include "core/linalg/sparse_cholesky.h"

namespace toile {

/// How a piece is solved, by its number of vertices.
struct KktSizes {
    int large = 40000;  ///< from here on by conjugate gradients, as long as these are cheaper
    int huge = 300000;  ///< from here on throughout: a factor would fill the memory
    double accuracy = TwoLevelSolver::kAccuracy;  ///< of conjugate gradients
};

/// A quadratic model of the isometric descent, factorised: what a descent leaves behind for that of
/// a piece with the same triangles and nearly the same shape, whose first steps it serves as well
/// as its own last ones. Immutable: any number of threads may solve with it.
struct KktModel {
    std::shared_ptr<const SparseCholesky> factor;  ///< of the augmented Lagrangian
    Points2 directions;                            ///< of the boundary edges, where it was laid out
    Eigen::VectorXd stiffness;                     ///< of the boundary edges
};

/// The steps of the isometric descent: minimises its quadratic model under the linearised length
/// conditions, by the augmented Lagrangian. The matrix of that has the sparsity of the mesh. Small
/// pieces factorise it; large ones solve with it by conjugate gradients (two_level_solver.h), which
/// costs less as long as the steps are few, and far less memory. Both come to the same steps but
/// for a hundredth. One thread at a time; keeps references.
class KktSolver {
public:
    /// @param mesh  a disk, holes aside  @param lengths  of the edges that `constraints` keeps
    KktSolver(const MeshArrays& mesh, const Eigen::VectorXd& lengths,
              const LengthConstraints& constraints, bool keepOutlineSimple, const KktSizes& sizes,
              const Progress& progress);

    /// Takes over a model that was laid out for the same triangles, for the steps to come.
    void adopt(std::shared_ptr<const KktModel> model) { adopted_ = std::move(model); }
    /// The present model, for others to take over; null where there is none, or the piece is large.
    /// What comes later does not change it.
    std::shared_ptr<const KktModel> share() const;

    /// Lays out the model at a point, for the steps to come.
    /// Errors: FactorisationFailed, OutOfMemory, Cancelled.
    Result<void> renew(IsometricObjective& objective, const ModelPoint& point);

    /// Solves  H P + A^T y = right,  A P = -c.
    /// @param y  first guess of the multipliers, then their value
    /// Errors: NotFinite, FactorisationFailed, OutOfMemory, Cancelled.
    Result<Points2> solve(const Points2& right, const Eigen::VectorXd& c, Eigen::VectorXd& y);

    /// What `renew` costs, in solutions.
    double renewingCost() const;

private:
    Result<void> layOut(const ModelPoint& point, double regularisation);
    Result<void> factorise(const BlockMatrix& K);
    Result<void> solveOnce(const Points2& forces, Points2& P, double& first);

    const LengthConstraints& constraints_;
    const Progress& progress_;
    bool large_, huge_;
    std::optional<TwoLevelSolver> twoLevel_;    ///< nothing where K is factorised
    std::shared_ptr<const KktModel> adopted_;   ///< until the first model of its own
    std::shared_ptr<SparseCholesky> cholesky_;  ///< null until needed
    bool laidOut_ = false;                      ///< cholesky_ for this pattern
    bool factorised_ = false;                   ///< cholesky_ for the present model
    const BlockMatrix* K_ = nullptr;
    Points2 directions_;         ///< of the boundary edges, at the model's point
    Eigen::VectorXd stiffness_;  ///< of the boundary edges, at the model's point
};

}  // namespace toile
