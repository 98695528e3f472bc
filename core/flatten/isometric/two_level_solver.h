// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/isometric/isometric_objective.h"

namespace toile {

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

    /// @param mesh  a disk, holes aside  @param lengths  of the loops' edges; both kept by
    /// reference
    TwoLevelSolver(const MeshArrays& mesh, EdgeLoops loops, const Eigen::VectorXd& lengths,
                   bool keepOutlineSimple, const Progress& progress, double accuracy = kAccuracy);
    ~TwoLevelSolver();

    /// Lays out the coarse level for a matrix of the fine one.
    /// @param K  of the fine level, `addLengths` at `point` done; used until the next call
    /// @param stiffness, regularisation  as given to `addLengths`
    /// Errors: FactorisationFailed (of the coarse matrix, or no coarse piece is to be had),
    /// OutOfMemory, Cancelled. Cost: a tenth of a factorisation of K.
    Result<void> renew(const BlockMatrix& K, const ModelPoint& point,
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
    EdgeLoops loops_;
    const Eigen::VectorXd& lengths_;
    bool keepOutlineSimple_;
    const Progress& progress_;
    double accuracy_;
    const BlockMatrix* K_ = nullptr;
    std::unique_ptr<Coarse> coarse_;
    int rounds_ = 0;
};

}  // namespace toile
