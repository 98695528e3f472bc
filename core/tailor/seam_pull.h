// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/tailor/body_ways.h"
#include "core/tailor/mesh_lines.h"

namespace toile::tailor {

/// Mean likeliness along a path, by length.
double alongLines(const BodyWays& ways, const MeshLines& lines, const std::vector<int>& way);

/// Pulls lines that follow the form to lines of the mesh that look like seams.
class SeamPull {
public:
    SeamPull(const BodyWays& ways, const MeshLines& lines);

    /// Costs of edges, reduced where they look like seams: near zero along certain seams, and high
    /// in the strip next to them, so that lines near a seam run along it.
    std::vector<double> eased(std::vector<double> costs) const;
    bool hasSure() const { return !besideSure_.empty(); }
    /// Whether a certain seam passes there.
    bool isAtSure(int vertex) const { return !besideSure_.empty() && besideSure_[vertex] == 0; }
    double along(const std::vector<int>& way) const;  ///< see `alongLines`
    /// Whether two consecutive edges, given by their vertices, belong to one line of the mesh.
    bool goesOn(int first, int middle, int last) const;
    /// Whether the edge between two vertices is a border of the file.
    bool isBorder(int from, int to) const;
    /// The path between the two sets that the mesh suggests near `way`, or `way` itself if nothing
    /// better is near.
    std::vector<int> pulled(const std::vector<int>& way, const std::vector<double>& costs,
                            const std::vector<int>& from, const std::vector<int>& to) const;

private:
    /// Share of a path along certain seams, by length.
    double alongSure(const std::vector<int>& way) const;
    /// Costs within a corridor (mm) around a path; prohibitive beyond.
    std::vector<double> near(const std::vector<int>& way, double corridor,
                             std::vector<double> costs) const;

    const BodyWays& ways_;
    const MeshLines& lines_;
    std::vector<double> besideSure_;  ///< per vertex: mm from certain seams; empty without any
};

}  // namespace toile::tailor
