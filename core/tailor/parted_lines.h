// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/cut/surface_links.h"
#include "core/cut/surface_point.h"
#include "core/geometry/shortest_paths.h"

namespace toile {

/// Where a surface is parted, by its vertices, as cuts are added one by one: those of rims, and for
/// each point of a cut the vertex next to it.
class PartedLines {
public:
    /// Keeps references.
    PartedLines(const SurfaceLinks& links, const NearestSurface& nearest,
                const std::vector<char>& rims)
        : links_(links), nearest_(nearest), isParted_(rims), isSewn_(rims) {}

    /// The vertices next to a line on the surface, in its order, none twice in a row.
    std::vector<int> verticesAlong(const std::vector<Eigen::Vector3d>& points) const;
    /// @param isDart  other darts do not begin on it
    void add(const std::vector<Eigen::Vector3d>& points, bool isDart);

    const std::vector<char>& isParted() const { return isParted_; }
    /// The same with one more line.
    std::vector<char> with(const std::vector<Eigen::Vector3d>& points) const;
    /// Whether a line meets a dart.
    bool meetsDart(const std::vector<Eigen::Vector3d>& points) const;
    /// Per vertex: how far it is from a rim or a seam along edges, mm; infinite where none is.
    std::vector<double> distances(const std::vector<double>& edgeLengths,
                                  const Progress& progress) const;
    /// The shortest way to a vertex from a rim or a seam: its first point lies on that.
    std::vector<Eigen::Vector3d> wayTo(int vertex, const std::vector<double>& edgeLengths,
                                       const Progress& progress) const;

private:
    geometry::ShortestForest forest(const std::vector<double>& edgeLengths, int stopAt,
                                    const Progress& progress) const;

    const SurfaceLinks& links_;
    const NearestSurface& nearest_;
    std::vector<char> isParted_, isSewn_;
    std::map<int, Eigen::Vector3d> place_;  ///< on the line, of vertices next to one
};

}  // namespace toile
