// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/edge_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

namespace toile {
namespace {

// Bits that the outlines are cut into, per edge: bounds the work where a few edges are very long.
constexpr double kBitsPerEdge = 8;
// Cells that the widest reach spans: a few edges may be entered in so many cells cubed.
constexpr double kCellsPerReach = 3;
// Smallest cell, as a part of the garment: keeps cell numbers far inside an int.
constexpr double kSmallestCell = 1e-7;

using Cell = std::array<int, 3>;
using Entry = std::pair<Cell, int>;

/// A cell no smaller than a typical edge, and than what keeps the number of entries in bounds.
double cellSize(const Outlines& outlines, const std::vector<double>& reach) {
    std::vector<double> lengths;
    double total = 0;
    for (const Outline& outline : outlines.list) {
        for (int k = 0; k < outline.size(); ++k) {
            lengths.push_back(outline.arc[k + 1] - outline.arc[k]);
        }
        total += outline.length();
    }
    if (lengths.empty()) {
        return 1;
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    const double widest = *std::max_element(reach.begin(), reach.end());
    return std::max({widest / kCellsPerReach, *middle, kSmallestCell * outlines.size,
                     total / (kBitsPerEdge * static_cast<double>(lengths.size()))});
}

class Grid {
public:
    Grid(const Eigen::Vector3d& origin, double cell) : origin_(origin), cell_(cell) {}

    /// Enters the edge in every cell that comes within its reach.
    void enter(int edge, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double reach) {
        const int bits = std::max(1, static_cast<int>(std::ceil((to - from).norm() / cell_)));
        for (int k = 0; k < bits; ++k) {
            const Eigen::Vector3d p = from + (to - from) * (static_cast<double>(k) / bits);
            const Eigen::Vector3d q = from + (to - from) * ((k + 1.0) / bits);
            const Cell low = cellOf(p.cwiseMin(q).array() - reach);
            const Cell high = cellOf(p.cwiseMax(q).array() + reach);
            for (int x = low[0]; x <= high[0]; ++x) {
                for (int y = low[1]; y <= high[1]; ++y) {
                    for (int z = low[2]; z <= high[2]; ++z) {
                        entries_.push_back({Cell{x, y, z}, edge});
                    }
                }
            }
        }
    }

    std::vector<std::pair<int, int>> pairs() {
        std::sort(entries_.begin(), entries_.end());
        entries_.erase(std::unique(entries_.begin(), entries_.end()), entries_.end());
        std::vector<std::pair<int, int>> found;
        for (std::size_t from = 0, to = 0; from < entries_.size(); from = to) {
            while (to < entries_.size() && entries_[to].first == entries_[from].first) {
                ++to;
            }
            for (std::size_t i = from; i < to; ++i) {
                for (std::size_t j = i + 1; j < to; ++j) {
                    found.emplace_back(entries_[i].second, entries_[j].second);
                }
            }
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

private:
    Cell cellOf(const Eigen::Vector3d& p) const {
        const Eigen::Vector3d q = (p - origin_) / cell_;
        return {static_cast<int>(std::floor(q.x())), static_cast<int>(std::floor(q.y())),
                static_cast<int>(std::floor(q.z()))};
    }

    Eigen::Vector3d origin_;
    double cell_;
    std::vector<Entry> entries_;
};

}  // namespace

std::vector<std::pair<int, int>> nearbyEdges(const Outlines& outlines,
                                             const std::vector<char>& skip,
                                             const std::vector<double>& reach) {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    for (const Outline& outline : outlines.list) {
        if (outline.size() > 0) {
            origin = outline.P.row(0);
            break;
        }
    }
    Grid grid(origin, cellSize(outlines, reach));
    for (int edge = 0; edge < outlines.edgeCount(); ++edge) {
        if (!skip[edge]) {
            const Outline& outline = outlines.of(edge);
            const int k = outlines.local(edge);
            grid.enter(edge, outline.P.row(k), outline.P.row((k + 1) % outline.size()),
                       reach[edge]);
        }
    }
    return grid.pairs();
}

}  // namespace toile
