// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/isometric/isometric_objective.h"
#include "core/linalg/sparse_cholesky.h"

namespace toile::isometric {

/// Solves with the matrix of the isometric descent's augmented Lagrangian without a factorisation
/// of it: by conjugate gradients, preconditioned by two levels [Tat93]. A sweep of Gauss-Seidel
/// takes what is rough in the error, and a coarse piece (coarsening.h) with the matrix of its own
/// at the same place, factorised, what is smooth. The coarse piece has all boundary vertices: the
/// stiff lengths are exact in it. Takes a tenth of the memory of a factorisation of the whole. One
/// thread at a time; keeps references to what it is given.
class TwoLevelSolver {
public:
    /// What is left of the first guess's error in the norm of the matrix's energy.
    static constexpr double kAccuracy = 1e-2;

    /// @param mesh  a disk, holes aside  @param table  its edges
    /// @param lengths  of the loops' edges; all three kept by reference
    TwoLevelSolver(const MeshArrays& mesh, const EdgeTable& table, EdgeLoops loops,
                   const Eigen::VectorXd& lengths, bool keepOutlineSimple, const Progress& progress,
                   double accuracy = kAccuracy);
    ~TwoLevelSolver();

    /// Lays out the coarse level for a matrix of the fine one.
    /// @param K  of the fine level, `addLengths` at `point` done; used until the next call
    /// @param stiffness, regularisation  as given to `addLengths`
    /// Errors: FactorisationFailed (of the coarse matrix, or no coarse piece is to be had),
    /// OutOfMemory, Cancelled. Cost: a tenth of a factorisation of K.
    Result<void> renew(const linalg::BlockMatrix& K, const ModelPoint& point,
                       const Eigen::VectorXd& stiffness, double regularisation);

    /// x with K x = right but for that part of the first guess's error, in the norm of K's
    /// energy. Where the right side has changed a little since, a call that goes on from x takes
    /// off nine tenths of the new error at least.
    /// @param x  the first guess, then the solution
    /// @param first  energy of the first guess's error, about; 0 in the first call, which sets it
    /// @return false where it does not converge, or once cancelled. Cost: ten to twenty rounds of
    ///         some four products with K
    bool solve(const Points2& right, Points2& x, double& first);

    /// Rounds of conjugate gradients so far.
    int rounds() const { return rounds_; }

private:
    struct Coarse;

    /// The residual under the preconditioner; nothing where that fails, or once cancelled.
    std::optional<Points2> precondition(const Points2& residual);

    const MeshArrays& mesh_;
    const EdgeTable& table_;
    EdgeLoops loops_;
    const Eigen::VectorXd& lengths_;
    bool keepOutlineSimple_;
    const Progress& progress_;
    double accuracy_;
    const linalg::BlockMatrix* K_ = nullptr;
    std::unique_ptr<Coarse> coarse_;
    int rounds_ = 0;
};

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
    std::shared_ptr<const linalg::SparseCholesky> factor;  ///< of the augmented Lagrangian
    Points2 directions;         ///< of the boundary edges, where it was laid out
    Eigen::VectorXd stiffness;  ///< of the boundary edges
};

/// The steps of the isometric descent: minimises its quadratic model under the linearised length
/// conditions, by the augmented Lagrangian. The matrix of that has the sparsity of the mesh. Small
/// pieces factorise it; large ones solve with it by conjugate gradients (`TwoLevelSolver`), which
/// costs less as long as the steps are few, and far less memory. Both come to the same steps but
/// for a hundredth. One thread at a time; keeps references.
class KktSolver {
public:
    /// @param mesh  a disk, holes aside  @param lengths  of the edges that `constraints` keeps
    KktSolver(const MeshArrays& mesh, const EdgeTable& table, const Eigen::VectorXd& lengths,
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
    Result<void> factorise(const linalg::BlockMatrix& K);
    Result<void> solveOnce(const Points2& forces, Points2& P, double& first);

    const LengthConstraints& constraints_;
    const Progress& progress_;
    bool large_, huge_;
    std::optional<TwoLevelSolver> twoLevel_;            ///< nothing where K is factorised
    std::shared_ptr<const KktModel> adopted_;           ///< until the first model of its own
    std::shared_ptr<linalg::SparseCholesky> cholesky_;  ///< null until needed
    bool laidOut_ = false;                              ///< cholesky_ for this pattern
    bool factorised_ = false;                           ///< cholesky_ for the present model
    const linalg::BlockMatrix* K_ = nullptr;
    Points2 directions_;         ///< of the boundary edges, at the model's point
    Eigen::VectorXd stiffness_;  ///< of the boundary edges, at the model's point
};

}  // namespace toile::isometric
