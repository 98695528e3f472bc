// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/seam_pull.h"

#include <algorithm>

#include "core/geometry/shortest_paths.h"
#include "core/mesh/edge_table.h"

namespace toile::tailor {
namespace {

/// Share of the cost that a certain seam saves.
constexpr double kSaving = 0.9;
/// Corridors, mm: a near one, in which any gain counts, and a wide one, which needs a large gain.
constexpr double kNear = 60, kWide = 180;
constexpr double kMuchMore = 0.15, kSure = 0.75;
constexpr double kOutOfReach = 1e6;
/// A reachable path with a larger share of certain seams is preferred.
constexpr double kMostlySure = 0.4;
/// Cost factor along a certain seam; width, mm, and cost factor of the strip next to it.
constexpr double kAlongSure = 0.02, kBesideSure = 10, kBeside = 30;

}  // namespace

double alongLines(const BodyWays& ways, const MeshLines& lines, const std::vector<int>& way) {
    double sum = 0, whole = 0;
    for (std::size_t k = 1; k < way.size(); ++k) {
        const double length = (ways.at(way[k]) - ways.at(way[k - 1])).norm();
        sum += length * lines.at(findEdge(ways.links().table().edges, way[k - 1], way[k]));
        whole += length;
    }
    return whole > 0 ? sum / whole : 0;
}

SeamPull::SeamPull(const BodyWays& ways, const MeshLines& lines) : ways_(ways), lines_(lines) {
    const Edges& edges = ways.links().table().edges;
    std::vector<int> sure;
    for (int e = 0; e < edges.rows() && lines.sure >= 0; ++e) {
        if (lines.isSure(e)) {
            sure.insert(sure.end(), {edges(e, 0), edges(e, 1)});
        }
    }
    if (!sure.empty()) {
        besideSure_ =
            geometry::shortestForest(edges, ways.links().vertexCount(), ways.lengths(), {sure})
                .distance;
    }
}

std::vector<double> SeamPull::eased(std::vector<double> costs) const {
    const Edges& edges = ways_.links().table().edges;
    for (std::size_t e = 0; e < costs.size(); ++e) {
        const auto edge = static_cast<int>(e);
        const bool isBeside =
            !besideSure_.empty() &&
            std::max(besideSure_[edges(edge, 0)], besideSure_[edges(edge, 1)]) < kBeside;
        costs[e] *= lines_.isSure(edge) ? kAlongSure
                    : isBeside          ? kBesideSure
                                        : 1 - kSaving * lines_.at(edge);
    }
    return costs;
}

double SeamPull::along(const std::vector<int>& way) const {
    return alongLines(ways_, lines_, way);
}

bool SeamPull::goesOn(int first, int middle, int last) const {
    const Edges& edges = ways_.links().table().edges;
    return lines_.lineOf[findEdge(edges, first, middle)] ==
           lines_.lineOf[findEdge(edges, middle, last)];
}

bool SeamPull::isBorder(int from, int to) const {
    return lines_.isBorder(findEdge(ways_.links().table().edges, from, to));
}

double SeamPull::alongSure(const std::vector<int>& way) const {
    double sure = 0;
    for (std::size_t k = 1; k < way.size() && hasSure(); ++k) {
        if (lines_.isSure(findEdge(ways_.links().table().edges, way[k - 1], way[k]))) {
            sure += (ways_.at(way[k]) - ways_.at(way[k - 1])).norm();
        }
    }
    return sure > 0 ? sure / ways_.length(way) : 0;
}

std::vector<double> SeamPull::near(const std::vector<int>& way, double corridor,
                                   std::vector<double> costs) const {
    const Edges& edges = ways_.links().table().edges;
    const auto forest =
        geometry::shortestForest(edges, ways_.links().vertexCount(), ways_.lengths(), {way});
    for (Eigen::Index e = 0; e < edges.rows(); ++e) {
        const double far = std::max(forest.distance[edges(e, 0)], forest.distance[edges(e, 1)]);
        costs[static_cast<std::size_t>(e)] *= far > corridor ? kOutOfReach : 1;
    }
    return costs;
}

std::vector<int> SeamPull::pulled(const std::vector<int>& way, const std::vector<double>& costs,
                                  const std::vector<int>& from, const std::vector<int>& to) const {
    if (way.empty()) {
        return way;
    }
    const std::vector<double> less = eased(costs);
    const double before = along(way);
    std::vector<int> close = ways_.cheapest(near(way, kNear, less), from, to);
    std::vector<int> wide = ways_.cheapest(near(way, kWide, less), from, to);
    const double closeBy = along(close), wideBy = along(wide);
    const bool isCloser = closeBy > before;
    const double reached = isCloser ? closeBy : before;
    const double sureBy = alongSure(wide);
    if (sureBy > std::max(kMostlySure, alongSure(isCloser ? close : way)) ||
        wideBy >= std::max(reached + kMuchMore, kSure)) {
        return wide;
    }
    return isCloser ? close : way;
}

}  // namespace toile::tailor
