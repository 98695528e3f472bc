// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Closed loops of boundary edges whose lengths are kept: the outline of a piece, and after it the
/// rims of holes where these count too. Vertices and edges are numbered through all loops; edge i
/// runs from vertex i to the next one of its loop. No vertex is in two loops. Immutable.
class EdgeLoops {
public:
    /// The outline alone.
    EdgeLoops(std::vector<int> outline);
    /// @param loops  the outline first; each of three vertices or more, surface on the left
    explicit EdgeLoops(const std::vector<std::vector<int>>& loops);

    int count() const { return static_cast<int>(vertices_.size()); }
    const std::vector<int>& vertices() const { return vertices_; }
    int vertex(int i) const { return vertices_[i]; }
    int next(int i) const { return next_[i]; }
    int previous(int i) const { return previous_[i]; }
    /// The vertex at the end of edge i.
    int end(int i) const { return vertices_[next_[i]]; }

    int loopCount() const { return static_cast<int>(starts_.size()) - 1; }
    /// Number of the first vertex of a loop; of the one after the last loop: `count()`.
    int start(int loop) const { return starts_[loop]; }
    std::vector<int> loop(int index) const;
    std::vector<int> outline() const { return loop(0); }

    /// The same loops with other numbers of vertices.
    EdgeLoops renumbered(const std::vector<int>& numbers) const;

    /// Lengths of the edges on the surface, and the inner angles of the surface at the vertices.
    Eigen::VectorXd lengths3d(const Points3& V) const;
    Eigen::VectorXd angles3d(const MeshArrays& mesh) const;

private:
    std::vector<int> vertices_;
    std::vector<int> next_, previous_;
    std::vector<int> starts_;
};

}  // namespace toile
