// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "core/sew/cloth.h"

// For the sources of this folder only.
namespace toile::sew {

/// Per vertex of the cloth those that it has an edge with, and their lengths at rest, mm: an edge
/// once for each of its triangles.
using Neighbours = std::vector<std::vector<std::pair<int, double>>>;
Neighbours neighboursOf(const Cloth& cloth);

/// What lies round vertices along cloth, one question after the other, in memory that is kept from
/// one to the next.
class VerticesAround {
public:
    /// Keeps a reference. @param far  mm
    VerticesAround(const Neighbours& neighbours, int rings, double far)
        : neighbours_(neighbours),
          rings_(rings),
          far_(far),
          askedAt_(neighbours.size()),
          wayTo_(neighbours.size()) {}

    /// Ascending: some vertices, and all that are within so many edges of one, or no farther than
    /// `far` by the shortest way along edges.  Cost: n log n in what comes out.
    std::vector<int> of(const std::vector<int>& seeds);

private:
    using Way = std::pair<double, int>;  ///< its length, and the vertex where it ends

    void reach(int vertex);
    void shorten(int vertex, double way);

    const Neighbours& neighbours_;
    int rings_;
    double far_;
    std::vector<int> reached_;
    std::vector<int> askedAt_;   ///< per vertex: for which question it was reached last
    std::vector<double> wayTo_;  ///< per reached vertex: the shortest so far
    std::priority_queue<Way, std::vector<Way>, std::greater<>> open_;
    int asked_ = 0;
};

}  // namespace toile::sew
