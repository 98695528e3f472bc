// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/weld.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/mesh/edge_table.h"

namespace toile {
namespace {

/// Of the median edge: above the last digit that mesh files carry, below anything cut from cloth.
constexpr double kToleranceOfMedianEdge = 1e-3;
/// Of the vertices used, how many must belong to one face for a file of loose faces, and how many
/// of them must lie on an earlier one (a closed mesh of loose triangles has five of six).
constexpr double kLooseShare = 0.95;
constexpr double kCoincidentShare = 1.0 / 3;
/// Cells across the largest coordinate: what a double can still count.
constexpr double kMostCells = 1e15;

using Cell = std::array<std::int64_t, 3>;

std::uint64_t hashOf(const Cell& cell) {
    std::uint64_t h = 0;
    for (const std::int64_t c : cell) {
        h = (h ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15u;
        h ^= h >> 32;  // the well mixed bits are the high ones, buckets take the low
    }
    return h;
}

/// The vertices kept so far, by the cell they stand in, as chains from hash buckets.
class Cells {
public:
    explicit Cells(int capacity)
        : bucket_(std::bit_ceil(static_cast<std::size_t>(capacity) + 1), -1),
          nextInBucket_(capacity, -1) {}

    void insert(const Cell& cell, int vertex) {
        int& first = bucket_[hashOf(cell) & (bucket_.size() - 1)];
        nextInBucket_[vertex] = first;
        first = vertex;
    }

    /// Visits all vertices of the cell, and perhaps others.
    template <class Visit>
    void visit(const Cell& cell, Visit visit) const {
        for (int v = bucket_[hashOf(cell) & (bucket_.size() - 1)]; v >= 0; v = nextInBucket_[v]) {
            visit(v);
        }
    }

private:
    std::vector<int> bucket_;
    std::vector<int> nextInBucket_;
};

std::vector<char> usedVertices(const Triangles& F, Eigen::Index vertexCount) {
    std::vector<char> used(vertexCount, 0);
    for (Eigen::Index corner = 0; corner < F.size(); ++corner) {
        used[F.data()[corner]] = 1;
    }
    return used;
}

std::vector<char> borderVertices(const Triangles& F, Eigen::Index vertexCount) {
    std::vector<char> border(vertexCount, 0);
    const EdgeTable table = buildEdgeTable(F, static_cast<int>(vertexCount));
    for (int e = 0; e < table.edges.rows(); ++e) {
        if (table.useStart[e + 1] - table.useStart[e] != 2) {
            border[table.edges(e, 0)] = 1;
            border[table.edges(e, 1)] = 1;
        }
    }
    return border;
}

/// Gives positions their cells: the bits themselves where they are to be equal, else cubes of twice
/// the tolerance, counted from a vertex so that they stay countable far from the origin.
class Grid {
public:
    Grid(const PointsView& V, const std::vector<char>& takesPart, double tolerance)
        : tolerance_(tolerance) {
        double extent = 0;
        bool any = false;
        for (int v = 0; v < V.rows(); ++v) {
            if (takesPart[v] != 0) {
                origin_ = any ? origin_ : Eigen::RowVector3d(V.row(v));
                any = true;
                extent = std::max(extent, (V.row(v) - origin_).cwiseAbs().maxCoeff());
            }
        }
        size_ = std::max(2 * tolerance, extent / kMostCells);
    }

    /// The cell of a point moved by the tolerance along each axis: down (-1), not (0) or up (1).
    Cell cellOf(const Eigen::RowVector3d& p, int way) const {
        Cell cell;
        for (int k = 0; k < 3; ++k) {
            cell[k] = tolerance_ > 0 ? static_cast<std::int64_t>(std::floor(
                                           (p[k] - origin_[k] + way * tolerance_) / size_))
                                     : std::bit_cast<std::int64_t>(p[k] + 0.0);  // -0 + 0 is 0
        }
        return cell;
    }

private:
    Eigen::RowVector3d origin_ = Eigen::RowVector3d::Zero();
    double tolerance_;
    double size_;
};

/// The least vertex in `cells` that stands within the tolerance of p, or `self`.
int leastNear(const Cells& cells, const Grid& grid, const PointsView& V, int self,
              double tolerance) {
    const Eigen::RowVector3d p = V.row(self);
    const Cell low = grid.cellOf(p, -1);
    const Cell high = grid.cellOf(p, 1);  // at most one further along each axis
    int least = self;
    for (auto x = low[0]; x <= high[0]; ++x) {
        for (auto y = low[1]; y <= high[1]; ++y) {
            for (auto z = low[2]; z <= high[2]; ++z) {
                cells.visit({x, y, z}, [&](int other) {
                    if (other < least && (V.row(other) - p).norm() <= tolerance) {
                        least = other;
                    }
                });
            }
        }
    }
    return least;
}

}  // namespace

Weld findWeld(const Triangles& F, const PointsView& V, const WeldOptions& options) {
    const int vertexCount = static_cast<int>(V.rows());
    std::vector<char> takesPart =
        options.borderOnly ? borderVertices(F, vertexCount) : usedVertices(F, vertexCount);
    for (int v = 0; v < vertexCount; ++v) {
        takesPart[v] = takesPart[v] != 0 && V.row(v).allFinite() ? 1 : 0;
    }
    const Grid grid(V, takesPart, options.tolerance);
    Cells kept(vertexCount);
    Weld weld;
    weld.target.resize(vertexCount);
    for (int v = 0; v < vertexCount; ++v) {
        weld.target[v] = v;
        if (takesPart[v] == 0) {
            continue;
        }
        weld.target[v] = leastNear(kept, grid, V, v, options.tolerance);
        if (weld.target[v] == v) {
            kept.insert(grid.cellOf(V.row(v), 0), v);
        } else {
            ++weld.merged;
        }
    }
    return weld;
}

Error weldNote(const Weld& weld, const PointsView& V, const std::string& name) {
    int first = 0;
    while (weld.target[first] == first) {
        ++first;
    }
    const std::vector<Wording> words{countWording(weld.merged, "vertex"), figure(V(first, 0), 1),
                                     figure(V(first, 1), 1), figure(V(first, 2), 1)};
    return {ErrorCode::VerticesWelded, name,
            weld.merged == 1 ? worded("%1 welded to another, at %2, %3, %4 mm", words)
                             : worded("%1 welded to another, the first at %2, %3, %4 mm", words)};
}

double weldTolerance(const Triangles& F, const PointsView& V) {
    std::vector<double> lengths;
    lengths.reserve(F.size());
    for (int f = 0; f < F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const double length = (V.row(F(f, (k + 1) % 3)) - V.row(F(f, k))).norm();
            if (std::isfinite(length)) {
                lengths.push_back(length);
            }
        }
    }
    if (lengths.empty()) {
        return 0;
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return kToleranceOfMedianEdge * *middle;
}

bool isMostlyLoose(const std::vector<int>& uses) {
    const auto used = std::ssize(uses) - std::count(uses.begin(), uses.end(), 0);
    const auto loose =
        std::count_if(uses.begin(), uses.end(), [](int n) { return n == 1 || n == 2; });
    return static_cast<double>(loose) >= kLooseShare * static_cast<double>(used);
}

bool looksUnwelded(const Triangles& F, const PointsView& V) {
    std::vector<int> uses(V.rows(), 0);
    for (Eigen::Index corner = 0; corner < F.size(); ++corner) {
        ++uses[F.data()[corner]];
    }
    const auto used = std::ssize(uses) - std::count(uses.begin(), uses.end(), 0);
    return F.rows() > 1 && isMostlyLoose(uses) &&
           findWeld(F, V, {}).merged >= kCoincidentShare * static_cast<double>(used);
}

}  // namespace toile
