// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>
#include <cholmod.h>

// For the sources of this folder only, as it shows CHOLMOD.
namespace toile {

/// The columns of a factor that can be non-zero in L^-1 u for sparse vectors u: a union of ways up
/// the elimination tree, node by node.
struct FactorReach {
    std::vector<int> nodes;     ///< ascending
    std::vector<int> columns;   ///< of these nodes, ascending
    std::vector<int> position;  ///< of each of the factor's columns in `columns`, or -1
};

/// Columns first .. first + width - 1 of a factor, dense from their diagonal block down.
struct FactorNode {
    int first, width, height;
    const int* rows;      ///< `height`; the first `width` are the node's own columns
    const double* value;  ///< column by column, `height` apart
};

/// Reads a factor P A P^T = L L^T, simplicial or supernodal, and solves with each half
/// alone, which CHOLMOD does only for whole right-hand sides. A node is a run of columns with the
/// same rows below; a simplicial factor has one column a node. The factor must outlive the view and
/// is not changed: any number of threads may read one.
class FactorView {
public:
    /// Many columns at once, row by row: what the inner loops run along.
    using Panel = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    /// Precondition: `isReadable(factor)`.
    explicit FactorView(const cholmod_factor& factor);

    /// False for L D L^T, for complex numbers or long indices, and for what is only analysed.
    static bool isReadable(const cholmod_factor& factor);

    int size() const { return size_; }
    /// Row of A in each row of L.
    const int* permutation() const { return permutation_; }

    /// Cost: the ways' lengths, and O(size) for the arrays.
    FactorReach reachOf(const std::vector<int>& columns) const;
    /// Multiplications of `forwardOn` per column of the panel.
    double workOn(const FactorReach& reach) const;
    /// X := L^-1 X for a panel on the reach: row i belongs to `reach.columns[i]`, all other rows
    /// are zero and stay so. Cost: the entries of L in the reach, per column; columns that are
    /// still zero at a node are passed over, and the better the nearer like columns stand.
    void forwardOn(const FactorReach& reach, Panel& X) const;

    /// X := L^-1 X and X := L^-T X. Cost: the entries of L, per column.
    void forward(Panel& X) const;
    void backward(Panel& X) const;

private:
    using Node = FactorNode;

    /// Right-hand sides that are solved for at once: more would not stay in registers.
    static constexpr int kFew = 3;
    using Solve = void (FactorView::*)(Panel&) const;

    Node node(int k) const;
    int nodeCount() const;

    template <int R>
    void forwardFew(Panel& X) const;
    template <int R>
    void backwardFew(Panel& X) const;
    void solveFew(Panel& X, const std::array<Solve, kFew>& solve) const;

    const cholmod_factor* factor_;
    int size_;
    const int* permutation_;
};

}  // namespace toile
