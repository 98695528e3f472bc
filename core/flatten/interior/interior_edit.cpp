// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/interior/interior_edit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace toile {
namespace {

/// Change of an entry, in parts of the lesser diagonal entry of its row and column, that is
/// rounding: weights of the same triangles, summed in another order.
constexpr double kRounding = 1e-14;

Eigen::VectorXd diagonalOf(const HeldGraph& held) {
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(held.count);
    for (int e = 0; e < held.graph.edges.rows(); ++e) {
        for (const int v : {held.graph.edges(e, 0), held.graph.edges(e, 1)}) {
            if (held.unknown[v] >= 0) {
                diagonal[held.unknown[v]] += held.graph.weights[e];
            }
        }
    }
    return diagonal;
}

/// Finds edges by their ends. Edges are sorted, and so mostly are the questions: the one after the
/// last answer is tried first.
class EdgeFinder {
public:
    EdgeFinder(const Edges& edges, std::size_t vertexCount)
        : edges_(edges), start_(vertexCount + 1, 0) {
        for (int e = 0; e < edges.rows(); ++e) {
            start_[edges(e, 0) + 1] = e + 1;
        }
        for (std::size_t v = 1; v < start_.size(); ++v) {
            start_[v] = std::max(start_[v], start_[v - 1]);
        }
    }

    /// -1 where there is none.
    int find(int a, int b) {
        if (a > b) {
            std::swap(a, b);
        }
        if (next_ < edges_.rows() && edges_(next_, 0) == a && edges_(next_, 1) == b) {
            return next_++;
        }
        const auto ends = edges_.col(1);
        const int last = std::max(start_[a], start_[a + 1]);
        const auto found =
            std::lower_bound(ends.begin() + start_[a], ends.begin() + last, b) - ends.begin();
        if (found == last || edges_(found, 1) != b) {
            return -1;
        }
        next_ = static_cast<int>(found) + 1;
        return static_cast<int>(found);
    }

private:
    const Edges& edges_;
    std::vector<int> start_;  ///< first edge of each vertex as the smaller end
    int next_ = 0;
};

class Comparison {
public:
    Comparison(const HeldGraph& before, const HeldGraph& now, const std::vector<int>& vertexBefore)
        : before_(before),
          now_(now),
          diagonalBefore_(diagonalOf(before)),
          diagonal_(diagonalOf(now)),
          counterpart_(static_cast<std::size_t>(now.count), -1),
          newOf_(static_cast<std::size_t>(before.count), -1),
          isTouched_(static_cast<std::size_t>(now.count), 0),
          edgeBefore_(static_cast<std::size_t>(now.graph.edges.rows()), -1),
          isFound_(static_cast<std::size_t>(before.graph.edges.rows()), 0) {
        for (std::size_t v = 0; v < now.unknown.size(); ++v) {
            const int i = now.unknown[v];
            const int p = vertexBefore[v] >= 0 ? before.unknown[vertexBefore[v]] : -1;
            if (i >= 0 && p >= 0 && newOf_[p] < 0) {
                newOf_[p] = i;
                counterpart_[i] = p;
            }
        }
    }

    InteriorEdit run(const std::vector<int>& vertexBefore) {
        findTouched(vertexBefore);
        InteriorEdit edit;
        edit.row = counterpart_;
        std::vector<int>& row = edit.row;
        for (int i = 0; i < now_.count; ++i) {
            const int p = counterpart_[i];
            if (p < 0) {
                const int added = edit.matrix.addedCount++;
                row[i] = before_.count + added;
                edit.matrix.amongAdded.push_back({added, added, diagonal_[i]});
            } else if (isTouched_[i] != 0) {
                edit.matrix.changed.push_back({p, p, diagonal_[i] - diagonalBefore_[p]});
            }
        }
        for (const int p : dropped_) {
            edit.matrix.dropped.push_back(p);
        }
        addEdges(row, edit.matrix);
        return edit;
    }

private:
    /// Of entries in rows i and j. True where one is no number.
    bool differs(double a, double b, int i, int j) const {
        return !(std::abs(a - b) <= kRounding * std::min(diagonal_[i], diagonal_[j]));
    }

    void findTouched(const std::vector<int>& vertexBefore) {
        for (int i = 0; i < now_.count; ++i) {
            const int p = counterpart_[i];
            if (p >= 0 && differs(diagonal_[i], diagonalBefore_[p], i, i)) {
                isTouched_[i] = 1;
            }
        }
        EdgeFinder finder(before_.graph.edges, before_.unknown.size());
        for (int e = 0; e < now_.graph.edges.rows(); ++e) {
            const int a = now_.graph.edges(e, 0);
            const int b = now_.graph.edges(e, 1);
            const int i = now_.unknown[a];
            const int j = now_.unknown[b];
            if (i < 0 || j < 0 || counterpart_[i] < 0 || counterpart_[j] < 0) {
                continue;
            }
            const int found = finder.find(vertexBefore[a], vertexBefore[b]);
            edgeBefore_[e] = found;
            if (found >= 0) {
                isFound_[found] = 1;
            }
            const double weight = found >= 0 ? before_.graph.weights[found] : 0;
            if (differs(now_.graph.weights[e], weight, i, j)) {
                isTouched_[i] = isTouched_[j] = 1;
            }
        }
        std::vector<char> isDropped(newOf_.size(), 0);
        for (int e = 0; e < before_.graph.edges.rows(); ++e) {
            const int p = before_.unknown[before_.graph.edges(e, 0)];
            const int q = before_.unknown[before_.graph.edges(e, 1)];
            if (p < 0 || q < 0 || isFound_[e] != 0) {
                continue;
            }
            if (newOf_[p] >= 0 && newOf_[q] >= 0) {
                isTouched_[newOf_[p]] = isTouched_[newOf_[q]] = 1;
                gone_.push_back({p, q, before_.graph.weights[e]});
            } else if (newOf_[p] >= 0 || newOf_[q] >= 0) {
                // What went, but touches nothing that stayed, may stand: nobody asks for it.
                const int lost = newOf_[p] >= 0 ? q : p;
                if (std::exchange(isDropped[lost], 1) == 0) {
                    dropped_.push_back(lost);
                }
            }
        }
    }

    void addEdges(const std::vector<int>& row, MatrixEdit& matrix) const {
        for (int e = 0; e < now_.graph.edges.rows(); ++e) {
            const int i = now_.unknown[now_.graph.edges(e, 0)];
            const int j = now_.unknown[now_.graph.edges(e, 1)];
            if (i < 0 || j < 0) {
                continue;
            }
            const double weight = now_.graph.weights[e];
            const bool isAddedI = counterpart_[i] < 0;
            const bool isAddedJ = counterpart_[j] < 0;
            if (isAddedI && isAddedJ) {
                matrix.amongAdded.push_back(
                    {row[i] - before_.count, row[j] - before_.count, -weight});
            } else if (isAddedI || isAddedJ) {
                const int old = row[isAddedI ? j : i];
                const int added = row[isAddedI ? i : j] - before_.count;
                matrix.coupled.push_back({old, added, -weight});
            } else if (isTouched_[i] != 0 && isTouched_[j] != 0) {
                const double old = edgeBefore_[e] >= 0 ? before_.graph.weights[edgeBefore_[e]] : 0;
                if (weight != old) {
                    matrix.changed.push_back({row[i], row[j], old - weight});
                }
            }
        }
        for (const auto& entry : gone_) {
            matrix.changed.push_back(entry);
        }
    }

    const HeldGraph& before_;
    const HeldGraph& now_;
    Eigen::VectorXd diagonalBefore_, diagonal_;
    std::vector<int> counterpart_;  ///< of each unknown: the old one that it is, or -1
    std::vector<int> newOf_;        ///< the other way
    std::vector<char> isTouched_;   ///< per unknown: entries of its row changed
    std::vector<int> edgeBefore_;   ///< of each edge between unknowns that both have been there
    std::vector<char> isFound_;     ///< per old edge
    std::vector<int> dropped_;
    std::vector<MatrixEdit::Entry> gone_;  ///< old edges between unknowns that stay
};

}  // namespace

InteriorEdit editBetween(const HeldGraph& before, const HeldGraph& now,
                         const std::vector<int>& vertexBefore) {
    return Comparison(before, now, vertexBefore).run(vertexBefore);
}

}  // namespace toile
