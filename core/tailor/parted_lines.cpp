// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/parted_lines.h"

#include <algorithm>

#include "core/cut/surface_paths.h"

namespace toile {

std::vector<int> PartedLines::verticesAlong(const std::vector<Eigen::Vector3d>& points) const {
    std::vector<int> vertices;
    for (const Eigen::Vector3d& point : points) {
        const SurfacePoint at = nearest_.find(point);
        int corner = 0;
        at.barycentric.maxCoeff(&corner);
        const int vertex = links_.mesh().F(at.face, corner);
        if (vertices.empty() || vertices.back() != vertex) {
            vertices.push_back(vertex);
        }
    }
    return vertices;
}

void PartedLines::add(const std::vector<Eigen::Vector3d>& points, bool isDart) {
    for (const Eigen::Vector3d& point : points) {
        const int vertex = verticesAlong({point}).front();
        isParted_[static_cast<std::size_t>(vertex)] = 1;
        if (!isDart) {
            isSewn_[static_cast<std::size_t>(vertex)] = 1;
            place_.emplace(vertex, point);
        }
    }
}

std::vector<char> PartedLines::with(const std::vector<Eigen::Vector3d>& points) const {
    std::vector<char> parted = isParted_;
    for (const int vertex : verticesAlong(points)) {
        parted[static_cast<std::size_t>(vertex)] = 1;
    }
    return parted;
}

bool PartedLines::meetsDart(const std::vector<Eigen::Vector3d>& points) const {
    return std::ranges::any_of(verticesAlong(points), [this](int v) {
        const auto at = static_cast<std::size_t>(v);
        return isParted_[at] != 0 && isSewn_[at] == 0;
    });
}

geometry::ShortestForest PartedLines::forest(const std::vector<double>& edgeLengths, int stopAt,
                                             const Progress& progress) const {
    std::vector<std::vector<int>> sources(1);
    for (int v = 0; v < links_.vertexCount(); ++v) {
        if (isSewn_[static_cast<std::size_t>(v)] != 0 && !links_.cornersAt(v).empty()) {
            sources[0].push_back(v);
        }
    }
    return geometry::shortestForest(links_.table().edges, links_.vertexCount(), edgeLengths,
                                    sources, stopAt, progress);
}

std::vector<double> PartedLines::distances(const std::vector<double>& edgeLengths,
                                           const Progress& progress) const {
    return forest(edgeLengths, -1, progress).distance;
}

std::vector<Eigen::Vector3d> PartedLines::wayTo(int vertex, const std::vector<double>& edgeLengths,
                                                const Progress& progress) const {
    const auto ways = forest(edgeLengths, vertex, progress);
    if (ways.source[static_cast<std::size_t>(vertex)] < 0 || progress.isCancelled()) {
        return {};
    }
    const int from = ways.pathTo(vertex, links_.table().edges).front();
    const auto known = place_.find(from);
    const SurfacePoint begin =
        known != place_.end() ? nearest_.find(known->second) : links_.atVertex(from);
    const auto path = geodesicPath(links_, begin, links_.atVertex(vertex), progress);
    return path ? positionsOf(links_.mesh(), *path) : std::vector<Eigen::Vector3d>();
}

}  // namespace toile
