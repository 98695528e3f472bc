// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/tailor/body_ways.h"
#include "core/tailor/mesh_lines.h"

namespace toile::tailor {

/// Pulls lines that follow the form to lines of the mesh that look like seams.
class SeamPull {
public:
    SeamPull(const BodyWays& ways, const MeshLines& lines) : ways_(ways), lines_(lines) {}

    /// Costs of edges, less where they look like seams.
    std::vector<double> eased(std::vector<double> costs) const;
    /// Mean likeliness along a way, by length.
    double along(const std::vector<int>& way) const;
    /// The way from one set to the other that the mesh suggests near `way`, or `way` itself where
    /// nothing better is near.
    std::vector<int> pulled(const std::vector<int>& way, const std::vector<double>& costs,
                            const std::vector<int>& from, const std::vector<int>& to) const;

private:
    /// Costs within so many mm of a way; beyond, they are out of reach.
    std::vector<double> near(const std::vector<int>& way, double corridor,
                             std::vector<double> costs) const;

    const BodyWays& ways_;
    const MeshLines& lines_;
};

}  // namespace toile::tailor
