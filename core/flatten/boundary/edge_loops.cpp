// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/boundary/edge_loops.h"

#include <utility>

#include "core/quality/measures.h"

namespace toile {

EdgeLoops::EdgeLoops(std::vector<int> outline)
    : EdgeLoops(std::vector<std::vector<int>>{std::move(outline)}) {}

EdgeLoops::EdgeLoops(const std::vector<std::vector<int>>& loops) {
    for (const auto& loop : loops) {
        const int first = count();
        const int last = first + static_cast<int>(loop.size()) - 1;
        starts_.push_back(first);
        vertices_.insert(vertices_.end(), loop.begin(), loop.end());
        for (int i = first; i <= last; ++i) {
            next_.push_back(i < last ? i + 1 : first);
            previous_.push_back(i > first ? i - 1 : last);
        }
    }
    starts_.push_back(count());
}

std::vector<int> EdgeLoops::loop(int index) const {
    return {vertices_.begin() + starts_[index], vertices_.begin() + starts_[index + 1]};
}

EdgeLoops EdgeLoops::renumbered(const std::vector<int>& numbers) const {
    EdgeLoops other = *this;
    for (int& v : other.vertices_) {
        v = numbers[v];
    }
    return other;
}

Eigen::VectorXd EdgeLoops::lengths3d(const Points3& V) const {
    Eigen::VectorXd lengths(count());
    for (int i = 0; i < count(); ++i) {
        lengths[i] = (V.row(end(i)) - V.row(vertex(i))).norm();
    }
    return lengths;
}

Eigen::VectorXd EdgeLoops::angles3d(const MeshArrays& mesh) const {
    return boundaryAngles3d(mesh, vertices_);
}

}  // namespace toile
