// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/linalg/cholmod_state.h"
#include "core/linalg/dense_cholesky.h"
#include "core/linalg/elimination_order.h"
#include "core/linalg/factor_view.h"

// For the sources of this folder only, as it shows CHOLMOD.
namespace toile {

/// The Cholesky factor of a large matrix in two halves that are factorised side by side, where
/// there are two threads, and their separator. Each half is factorised by CHOLMOD together with its
/// rows of the separator, eliminated last. The block G of the factor in those rows and columns is
/// what the half leaves to the separator: G G^T = A_SS - A_Sh A_hh^-1 A_hS. The sum of both is
/// dense, and is factorised by LAPACK. Each half is a principal part of the matrix, so nothing is
/// refused that CHOLMOD would factorise whole, and rounding is the same in kind.
/// The halves are the matrix's own: the same bytes on one thread and on two. Thread-safety: as
/// SparseCholesky; any number may read it through `FactorView`.
class DividedFactor {
public:
    /// True where the halves are large and about even, and the separator is short. Else going over
    /// the separator twice, and starting threads, takes too much of what the second core gains.
    static bool isWorthIt(const EliminationOrder& order, int size);

    /// Precondition: `isWorthIt`. Errors: OutOfMemory.
    Result<void> analyse(const SymmetricMatrix& pattern, const EliminationOrder& order);
    /// Precondition: `analyse` succeeded with this pattern. Errors: FactorisationFailed (not
    /// positive definite), OutOfMemory.
    /// @param release  called as soon as the matrix is not looked at any more
    Result<void> factorise(const SymmetricMatrix& matrix, const std::function<void()>& release);
    /// Precondition: `factorise` succeeded.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;

    bool isFactorised() const { return !nodes_.empty(); }
    int size() const { return static_cast<int>(permutation_.size()); }
    /// Unknown in each row of the factor: the first half's, the second's, the separator's.
    const std::vector<int>& permutation() const { return permutation_; }
    int separatorStart() const { return separatorStart_; }
    /// Those of the first half, of the second, and one for the separator.
    const std::vector<FactorNode>& nodes() const { return nodes_; }
    /// Where the halves' nodes end.
    const std::array<int, 2>& nodeEnd() const { return nodeEnd_; }

    /// About what it takes in memory.
    std::size_t bytes() const;
    /// Operations of the factorisation.
    double work() const;

private:
    struct Half {
        CholmodState cholmod;
        std::vector<int> place;  ///< of each unknown: its row in the half's factor, or -1
        int size = 0;
        std::vector<int> rows;   ///< CHOLMOD's row lists, in rows of the whole factor
        std::vector<int> taken;  ///< separator's unknowns, the last to be eliminated first
        DenseBlock left{nullptr, 0, 0, Eigen::OuterStride<>(0)};  ///< G G^T in that order, above
        Eigen::MatrixXd apart;      ///< where that stands, if not in the factor
        Result<void> outcome = {};  ///< of what it did last
    };

    void analyseHalf(Half& half, int number, const SymmetricMatrix& pattern);
    static SymmetricMatrix partOf(const Half& half, const SymmetricMatrix& matrix, bool withValues);
    void takeSeparator(const SymmetricMatrix& matrix);
    void factoriseHalf(Half& half, SymmetricMatrix part);
    void squareLeft(Half& half);
    void addLeft(Half& half);
    void addNodes(const Half& half);

    std::array<Half, 2> halves_;
    std::array<int, 2> halfEnd_{};
    int separatorStart_ = 0;
    std::vector<int> permutation_;
    std::vector<int> placeInSeparator_;  ///< of each unknown, or -1
    std::vector<int> separatorRows_;     ///< of the factor
    Eigen::MatrixXd separator_;          ///< its factor, lower triangle
    std::vector<FactorNode> nodes_;
    std::array<int, 2> nodeEnd_{};
};

}  // namespace toile
