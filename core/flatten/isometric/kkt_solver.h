// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/boundary/length_constraints.h"
#include "core/flatten/isometric/flat_energy.h"
#include "core/flatten/isometric/outline_terms.h"
#include "core/linalg/sparse_cholesky.h"

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

/// Solves with the matrix of the isometric descent's augmented Lagrangian without factorising it:
/// conjugate gradients, preconditioned by two levels [Tat93]. A Gauss-Seidel sweep removes the
/// rough part of the error; the factorised matrix of a coarse piece (coarsening.h) at the same
/// point removes the smooth part. The coarse piece has all boundary vertices, so the stiff lengths
/// are exact in it. Needs a tenth of the memory of a full factorisation. One thread at a time;
/// stores references to its arguments.
class TwoLevelSolver {
public:
    /// Remaining share of the first guess's error, in the matrix's energy norm.
    static constexpr double kAccuracy = 1e-2;

    /// @param mesh  a disk, may have holes  @param table  its edges
    /// @param lengths  of the loops' edges; all three stored by reference
    TwoLevelSolver(const MeshArrays& mesh, const EdgeTable& table, EdgeLoops loops,
                   const Eigen::VectorXd& lengths, bool keepOutlineSimple, const Progress& progress,
                   double accuracy = kAccuracy);
    ~TwoLevelSolver();

    /// Sets up the coarse level for a matrix of the fine one.
    /// @param K  of the fine level, after `addLengths` at `point`; used until the next call
    /// @param stiffness, regularisation  as given to `addLengths`
    /// Errors: FactorisationFailed (of the coarse matrix, or no coarse piece can be made),
    /// OutOfMemory, Cancelled. Cost: a tenth of a factorisation of K.
    Result<void> renew(const linalg::BlockMatrix& K, const ModelPoint& point,
                       const Eigen::VectorXd& stiffness, double regularisation);

    /// Solves K x = right to `accuracy` times the first guess's error, in K's energy norm. If the
    /// right side has changed a little since, a call that continues from x removes at least nine
    /// tenths of the new error.
    /// @param x  the first guess, then the solution
    /// @param first  energy of the first guess's error, about; 0 in the first call, which sets it
    /// @return false if it does not converge, or once cancelled. Cost: ten to twenty rounds of
    /// about four products with K
    bool solve(const Points2& right, Points2& x, double& first);

    /// Rounds of conjugate gradients so far.
    int rounds() const { return rounds_; }

private:
    struct Coarse;

    /// The preconditioned residual; nothing if that fails, or once cancelled.
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

/// Selects the solver of a piece by its number of vertices.
struct KktSizes {
    int large = 40000;  ///< from here on conjugate gradients, while they are cheaper
    int huge = 300000;  ///< from here on always: a factor would fill the memory
    double accuracy = TwoLevelSolver::kAccuracy;  ///< of conjugate gradients
};

/// A factorised quadratic model of the isometric descent, for the next descent of a piece with the
/// same triangles and nearly the same shape. It suits that descent's first steps as well as the
/// last steps of its own. Immutable: any number of threads may solve with it.
struct KktModel {
    std::shared_ptr<const linalg::SparseCholesky> factor;  ///< of the augmented Lagrangian
    Points2 directions;         ///< of the boundary edges, at the model's point
    Eigen::VectorXd stiffness;  ///< of the boundary edges
};

/// The steps of the isometric descent: minimises its quadratic model under the linearised length
/// conditions by the augmented Lagrangian, whose matrix has the sparsity of the mesh. Small pieces
/// factorise it. Large ones use conjugate gradients (`TwoLevelSolver`), which cost less if the
/// steps are few, and need far less memory. Both give the same steps within a hundredth. One thread
/// at a time; stores references.
class KktSolver {
public:
    /// @param mesh  a disk, may have holes  @param lengths  of the edges that `constraints` keeps
    KktSolver(const MeshArrays& mesh, const EdgeTable& table, const Eigen::VectorXd& lengths,
              const LengthConstraints& constraints, bool keepOutlineSimple, const KktSizes& sizes,
              const Progress& progress);

    /// Uses a model made for the same triangles for the next steps.
    void adopt(std::shared_ptr<const KktModel> model) { adopted_ = std::move(model); }
    /// The present model, for use by others; null if there is none, or the piece is large. Later
    /// calls do not change it.
    std::shared_ptr<const KktModel> share() const;

    /// Sets up the model at a point for the next steps.
    /// Errors: FactorisationFailed, OutOfMemory, Cancelled.
    Result<void> renew(IsometricObjective& objective, const ModelPoint& point);

    /// Solves  H P + A^T y = right,  A P = -c.
    /// @param y  first guess of the multipliers, then their value
    /// Errors: NotFinite, FactorisationFailed, OutOfMemory, Cancelled.
    Result<Points2> solve(const Points2& right, const Eigen::VectorXd& c, Eigen::VectorXd& y);

    /// Cost of `renew`, in solutions.
    double renewingCost() const;

private:
    Result<void> layOut(const ModelPoint& point, double regularisation);
    Result<void> factorise(const linalg::BlockMatrix& K);
    Result<void> solveOnce(const Points2& forces, Points2& P, double& first);

    const LengthConstraints& constraints_;
    const Progress& progress_;
    bool large_, huge_;
    std::optional<TwoLevelSolver> twoLevel_;            ///< nothing if K is factorised
    std::shared_ptr<const KktModel> adopted_;           ///< until the first model of its own
    std::shared_ptr<linalg::SparseCholesky> cholesky_;  ///< null until needed
    bool laidOut_ = false;                              ///< cholesky_ is set up for this pattern
    bool factorised_ = false;                           ///< cholesky_ holds the present model
    const linalg::BlockMatrix* K_ = nullptr;
    Points2 directions_;         ///< of the boundary edges, at the model's point
    Eigen::VectorXd stiffness_;  ///< of the boundary edges, at the model's point
};

}  // namespace toile::isometric
