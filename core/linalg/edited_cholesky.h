// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include "core/base/result.h"
#include "core/linalg/sparse_cholesky.h"

namespace toile {

/// How a symmetric matrix B differs from another, A: some unknowns are dropped, some entries have
/// other values, some unknowns are added. All lists are short.
struct MatrixEdit {
    struct Entry {
        int row, column;
        double value;
    };

    std::vector<int> dropped;       ///< unknowns of A that B does not have
    std::vector<Entry> changed;     ///< B - A between unknowns of A; each pair once, either way
    int addedCount = 0;             ///< unknowns of B that A does not have
    std::vector<Entry> coupled;     ///< entries of B; row: unknown of A, column: added unknown
    std::vector<Entry> amongAdded;  ///< entries of B between added unknowns; each pair once
};

/// Solves with an edited matrix by the factor of the old one, which stays as it is: the edit is a
/// bordered system (Schur complement, Woodbury's formula), whose border of k columns is carried
/// through L alone, and only where it is not zero: along the ways up the elimination tree. Since
/// every edit is taken against the one factor, a long row of edits heaps up no rounding.
/// Immutable: any number of threads may solve with it. Shares the factor.
class EditedCholesky {
public:
    /// @param factor  of A; `factorise` has succeeded and is not called again
    /// Errors: FactorisationFailed, where the border costs more than a good part of a new
    /// factorisation, or the factor is of a kind that cannot be shared. Cost: k columns along their
    /// ways, O(k^3), O(size).
    static Result<EditedCholesky> make(std::shared_ptr<const SparseCholesky> factor,
                                       const MatrixEdit& edit);

    /// B X = right for every column. Rows: the unknowns of A, then the added ones; those of dropped
    /// unknowns are not looked at, and zero in X. Not refined: where the edit is far from A in size
    /// the caller should look at the residual. Cost: a back-substitution.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

    /// W^T B^-1 W: what a further edit by the columns W needs.
    /// @param columns  of W; rows are numbered as in `solve`, none of a dropped unknown
    /// Errors: FactorisationFailed, as `make`. Cost: the columns along their ways.
    Result<Eigen::MatrixXd> squareOnInverse(const std::vector<MatrixEdit::Entry>& columns,
                                            int width) const;

    /// True where so many multiplications are far less than a factorisation takes.
    bool isCheap(double work) const;

    /// The most columns a border may have.
    static constexpr int kMostColumns = 1000;

private:
    EditedCholesky() = default;

    using Panel = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    /// z. @param g  U^T A^-1 b  @param addedRight  b of the added unknowns
    Eigen::MatrixXd borderUnknowns(const Eigen::MatrixXd& g,
                                   const Eigen::MatrixXd& addedRight) const;

    std::shared_ptr<const SparseCholesky> factor_;
    int oldSize_ = 0;
    int addedCount_ = 0;
    std::vector<int> dropped_;
    std::vector<int> touched_;                ///< unknowns of A whose entries changed
    std::vector<MatrixEdit::Entry> changed_;  ///< by index into `touched_`, both ways
    std::vector<int> column_;  ///< in the border: of touched, dropped, added, in turn
    std::vector<int> reach_;   ///< rows of L in which the border is not zero
    Panel border_;             ///< L^-1 of the border, on the reach
    Eigen::PartialPivLU<Eigen::MatrixXd> small_;
};

}  // namespace toile
