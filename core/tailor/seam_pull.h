// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/tailor/body_ways.h"
#include "core/tailor/mesh_lines.h"

namespace toile::tailor {

/// Mean likeliness along a way, by length.
double alongLines(const BodyWays& ways, const MeshLines& lines, const std::vector<int>& way);

/// Pulls lines that follow the form to lines of the mesh that look like seams.
class SeamPull {
public:
    SeamPull(const BodyWays& ways, const MeshLines& lines);

    /// Costs of edges, less where they look like seams; next to none along sure ones, and much
    /// beside them, so that what would run near does run along.
    std::vector<double> eased(std::vector<double> costs) const;
    bool hasSure() const { return !besideSure_.empty(); }
    /// Whether a sure seam passes there.
    bool isAtSure(int vertex) const { return !besideSure_.empty() && besideSure_[vertex] == 0; }
    double along(const std::vector<int>& way) const;  ///< as of `alongLines`
    /// Whether two edges of a way, from vertex to vertex, are of one line of the mesh.
    bool goesOn(int first, int middle, int last) const;
    /// Whether the edge between two vertices is a border of the file.
    bool isBorder(int from, int to) const;
    /// The way from one set to the other that the mesh suggests near `way`, or `way` itself where
    /// nothing better is near.
    std::vector<int> pulled(const std::vector<int>& way, const std::vector<double>& costs,
                            const std::vector<int>& from, const std::vector<int>& to) const;

private:
    /// Which part of a way runs along sure seams, by length.
    double alongSure(const std::vector<int>& way) const;
    /// Costs within so many mm of a way; beyond, they are out of reach.
    std::vector<double> near(const std::vector<int>& way, double corridor,
                             std::vector<double> costs) const;

    const BodyWays& ways_;
    const MeshLines& lines_;
    std::vector<double> besideSure_;  ///< per vertex: how far from sure seams, mm; empty: of none
};

}  // namespace toile::tailor
