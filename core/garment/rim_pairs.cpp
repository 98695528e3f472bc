// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/rim_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include <Eigen/Geometry>

namespace toile {
namespace {

/// Numbers places: points closer together than a tolerance share one.
class Places {
public:
    explicit Places(double tolerance) : tolerance_(tolerance) {}

    int of(const Eigen::Vector3d& point) {
        const Cell cell = cellOf(point);
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dz = -1; dz <= 1; ++dz) {
                    const auto found = cells_.find({cell[0] + dx, cell[1] + dy, cell[2] + dz});
                    if (found == cells_.end()) {
                        continue;
                    }
                    for (const int known : found->second) {
                        if ((points_[known] - point).norm() <= tolerance_) {
                            return known;
                        }
                    }
                }
            }
        }
        cells_[cell].push_back(static_cast<int>(points_.size()));
        points_.push_back(point);
        return static_cast<int>(points_.size()) - 1;
    }

private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cellOf(const Eigen::Vector3d& point) const {
        Cell cell;
        for (int k = 0; k < 3; ++k) {
            cell[k] = std::llround(point[k] / (2 * tolerance_));
        }
        return cell;
    }

    double tolerance_;
    std::map<Cell, std::vector<int>> cells_;
    std::vector<Eigen::Vector3d> points_;
};

bool isUsable(const std::shared_ptr<const Piece>& piece) {
    return piece && piece->mesh.F.rows() > 0 && piece->mesh.V.allFinite();
}

void collectEdges(const Piece& piece, int index, std::vector<RimPairs::Edge>& edges) {
    const EdgeTable& table = piece.table;
    for (std::size_t e = 0; e + 1 < table.useStart.size(); ++e) {
        if (table.useStart[e + 1] - table.useStart[e] == 1) {
            const int use = table.use[table.useStart[e]];
            edges.push_back(
                {index, piece.mesh.F(use / 3, use % 3), piece.mesh.F(use / 3, (use % 3 + 1) % 3)});
        }
    }
}

/// Who follows whom; at a vertex where several edges begin or end nobody does.
void linkNeighbours(std::vector<RimPairs::Edge>& edges) {
    std::map<std::pair<int, int>, std::vector<int>> from, to;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        from[{edges[e].piece, edges[e].tail}].push_back(e);
        to[{edges[e].piece, edges[e].head}].push_back(e);
    }
    for (const auto& [vertex, arriving] : to) {
        const auto leaving = from.find(vertex);
        if (arriving.size() == 1 && leaving != from.end() && leaving->second.size() == 1) {
            edges[arriving[0]].next = leaving->second[0];
            edges[leaving->second[0]].prev = arriving[0];
        }
    }
}

void findMates(const std::vector<std::shared_ptr<const Piece>>& pieces, double tolerance,
               std::vector<RimPairs::Edge>& edges) {
    Places places(tolerance);
    const auto placeOf = [&](int piece, int vertex) {
        return places.of(pieces[piece]->mesh.V.row(vertex).transpose());
    };
    std::map<std::pair<int, int>, std::vector<int>> between;
    std::vector<std::pair<int, int>> ends;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        ends.emplace_back(placeOf(edges[e].piece, edges[e].tail),
                          placeOf(edges[e].piece, edges[e].head));
        between[ends.back()].push_back(e);
    }
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        const auto [tail, head] = ends[e];
        const auto against = between.find({head, tail});
        if (tail == head || against == between.end()) {
            continue;
        }
        const bool single = against->second.size() == 1 && between[ends[e]].size() == 1;
        edges[e].mate = single ? against->second[0] : RimPairs::kSeveral;
    }
}

}  // namespace

RimPairs pairRims(const std::vector<std::shared_ptr<const Piece>>& pieces) {
    RimPairs rims;
    Eigen::AlignedBox3d box;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        if (isUsable(pieces[p])) {
            collectEdges(*pieces[p], static_cast<int>(p), rims.edges);
            box.extend(Eigen::Vector3d(pieces[p]->mesh.V.colwise().minCoeff().transpose()));
            box.extend(Eigen::Vector3d(pieces[p]->mesh.V.colwise().maxCoeff().transpose()));
        }
    }
    const double tolerance = box.isEmpty() ? 0 : kSamePlace * box.diagonal().norm();
    linkNeighbours(rims.edges);
    if (tolerance > 0) {
        findMates(pieces, tolerance, rims.edges);
    }
    return rims;
}

PairedChain chainAround(const RimPairs& rims, int seed) {
    const std::vector<RimPairs::Edge>& edges = rims.edges;
    PairedChain chain{{seed}};
    std::set<int> used{seed, edges[seed].mate};
    for (int last = seed;;) {
        const int next = edges[last].next;
        if (next == seed && edges[edges[seed].mate].next == edges[last].mate) {
            chain.closed = chain.edges.size() > 2;
            return chain;
        }
        // At the tip of a dart the edge goes on with its own mate: the seam ends there.
        if (next < 0 || edges[next].mate < 0 || used.contains(next) ||
            edges[edges[next].mate].next != edges[last].mate) {
            break;
        }
        used.insert({next, edges[next].mate});
        chain.edges.push_back(next);
        last = next;
    }
    for (int first = seed;;) {
        const int before = edges[first].prev;
        if (before < 0 || edges[before].mate < 0 || used.contains(before) ||
            edges[edges[first].mate].next != edges[before].mate) {
            break;
        }
        used.insert({before, edges[before].mate});
        chain.edges.insert(chain.edges.begin(), before);
        first = before;
    }
    return chain;
}

}  // namespace toile
