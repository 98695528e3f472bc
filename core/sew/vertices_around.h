// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "core/sew/cloth.h"

// For the sources of this folder only.
namespace toile::sew {

/// Per vertex of the cloth its neighbours along edges, and the edge lengths at rest, mm: an edge
/// appears once for each of its triangles.
using Neighbours = std::vector<std::vector<std::pair<int, double>>>;
Neighbours neighboursOf(const Cloth& cloth);

/// Finds vertices near given ones along the cloth; reuses its memory between queries.
class VerticesAround {
public:
    /// Keeps a reference. @param far  mm
    VerticesAround(const Neighbours& neighbours, int rings, double far)
        : neighbours_(neighbours),
          rings_(rings),
          far_(far),
          requestedAt_(neighbours.size()),
          wayTo_(neighbours.size()) {}

    /// Ascending: the seeds, and all vertices within `rings` edges of one, or within `far` by the
    /// shortest path along edges.  Cost: n log n in the result.
    std::vector<int> of(const std::vector<int>& seeds);

private:
    using Way = std::pair<double, int>;  ///< its length, and its last vertex

    void reach(int vertex);
    void shorten(int vertex, double way);

    const Neighbours& neighbours_;
    int rings_;
    double far_;
    std::vector<int> reached_;
    std::vector<int> requestedAt_;  ///< per vertex: the last query that reached it
    std::vector<double> wayTo_;     ///< per reached vertex: shortest length so far
    std::priority_queue<Way, std::vector<Way>, std::greater<>> open_;
    int requested_ = 0;
};

}  // namespace toile::sew
