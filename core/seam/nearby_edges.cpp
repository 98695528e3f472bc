// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>

#include <Eigen/Geometry>

#include "core/geometry/segment.h"
#include "core/seam/contacts.h"

namespace toile::seam {
namespace {

// Cells with no more edges than this are paired without further splitting.
constexpr std::size_t kFewEdges = 16;
// Largest mean number of cells per edge: splitting a cell does not separate edges that lie along
// each other, or meet in one point.
constexpr double kMaxCopiesPerEdge = 16;
// More edges than this, inseparable, are a crowd: 64 corners in one point, or 128 layers.
constexpr std::size_t kCrowd = 128;
// Largest number of halvings of the garment's size: one part in 1e7.
constexpr int kMaxDepth = 24;
// Fraction of the garment's size that rounding may take from an edge's radius.
constexpr double kRounding = 1e-9;

struct Stretch {
    Eigen::Vector3d from, to;
    double radius;
};

struct Cell {
    Eigen::Vector3d low;
    double side;
    int depth = 0;
    double copies = 1;  ///< mean number of entries per edge so far

    Cell child(int octant, double copiesThere) const {
        const double half = 0.5 * side;
        const Eigen::Vector3d step(octant & 1, octant >> 1 & 1, octant >> 2);
        return {low + half * step, half, depth + 1, copiesThere};
    }

    /// Whether the edge comes within its radius of the cell, along each axis.
    bool isReachedBy(const Stretch& edge) const {
        const Eigen::Vector3d below = low.array() - edge.radius;
        const Eigen::Vector3d above = low.array() + side + edge.radius;
        const Eigen::Vector3d way = edge.to - edge.from;
        const geometry::ShareInBox share = geometry::shareInBox(edge.from, way, below, above);
        return share.first <= share.last;
    }
};

class PairSearch {
public:
    explicit PairSearch(std::vector<Stretch> stretches) : stretches_(std::move(stretches)) {}

    void search(const std::vector<int>& edges, const Cell& cell) {
        if (edges.size() <= kFewEdges) {
            pairAll(edges);
            return;
        }
        std::vector<unsigned char> octants(edges.size(), 0);  // bits of reached octants
        double entries = 0;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (int octant = 0; octant < 8; ++octant) {
                const bool reached = cell.child(octant, 0).isReachedBy(
                    stretches_[static_cast<std::size_t>(edges[i])]);
                octants[i] |= static_cast<unsigned char>(reached ? 1 << octant : 0);
            }
            entries += std::popcount(octants[i]);
        }
        const double copies = cell.copies * entries / static_cast<double>(edges.size());
        if (copies > kMaxCopiesPerEdge || cell.depth == kMaxDepth) {
            endAt(edges, cell);
            return;
        }
        std::vector<int> there;
        for (int octant = 0; octant < 8; ++octant) {
            there.clear();
            for (std::size_t i = 0; i < edges.size(); ++i) {
                if (octants[i] >> octant & 1) {
                    there.push_back(edges[i]);
                }
            }
            search(there, cell.child(octant, copies));
        }
    }

    NearbyEdges take() {
        sortOut();
        return std::move(found_);
    }

private:
    void endAt(const std::vector<int>& edges, const Cell& cell) {
        if (edges.size() <= kCrowd) {
            pairAll(edges);
        } else {
            found_.crowded.push_back({cell.low + Eigen::Vector3d::Constant(0.5 * cell.side),
                                      static_cast<int>(edges.size())});
        }
    }

    void pairAll(const std::vector<int>& edges) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (std::size_t k = i + 1; k < edges.size(); ++k) {
                found_.pairs.emplace_back(edges[i], edges[k]);
            }
        }
        if (found_.pairs.size() > 2 * different_ + stretches_.size()) {
            sortOut();
        }
    }

    /// Removes duplicates: edges that lie along each other have many cells in common.
    void sortOut() {
        std::sort(found_.pairs.begin(), found_.pairs.end());
        found_.pairs.erase(std::unique(found_.pairs.begin(), found_.pairs.end()),
                           found_.pairs.end());
        different_ = found_.pairs.size();
    }

    std::vector<Stretch> stretches_;
    NearbyEdges found_;
    std::size_t different_ = 0;  ///< number of pairs after the last removal of duplicates
};

}  // namespace

NearbyEdges nearbyEdges(const Outlines& outlines, const std::vector<char>& skip,
                        const std::vector<double>& radius) {
    std::vector<Stretch> stretches;
    std::vector<int> edges;
    Eigen::AlignedBox3d box;
    for (int edge = 0; edge < outlines.edgeCount(); ++edge) {
        const Outline& outline = outlines.of(edge);
        const int k = outlines.local(edge);
        stretches.push_back({outline.line.point(k), outline.line.point(k + 1),
                             radius[edge] + kRounding * outlines.size});
        if (!skip[edge]) {
            edges.push_back(edge);
            box.extend(stretches.back().from).extend(stretches.back().to);
        }
    }
    if (edges.empty()) {
        return {};
    }
    // The nearest points of two edges lie between them, so within their box.
    PairSearch pairs(std::move(stretches));
    pairs.search(edges, {box.min(), box.sizes().maxCoeff()});
    return pairs.take();
}

}  // namespace toile::seam
