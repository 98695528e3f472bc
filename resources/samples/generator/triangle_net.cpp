// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_net.h"

#include <stdexcept>

namespace toile::samples {

int TriangleNet::slotOfNeighbour(int t, int other) const {
    for (int k = 0; k < 3; ++k) {
        if (beside(t, k) == other) {
            return k;
        }
    }
    throw std::logic_error("triangles are not neighbours");
}

int TriangleNet::cornerBeyond(int t, int k) const {
    const int other = beside(t, k);
    return corner(other, slotOfNeighbour(other, t));
}

void TriangleNet::relink(int t, int from, int to) {
    if (t != Triangle::kNone) {
        (*this)[t].beside[static_cast<std::size_t>(slotOfNeighbour(t, from))] = to;
    }
}

std::array<int, 3> TriangleNet::splitTriangle(int t, int vertex) {
    const Triangle old = (*this)[t];
    const auto [a, b, c] = old.corner;
    const int second = size();
    const int third = second + 1;
    (*this)[t] = {{vertex, b, c}, {old.beside[0], second, third}};
    triangles.push_back({{vertex, c, a}, {old.beside[1], third, t}});
    triangles.push_back({{vertex, a, b}, {old.beside[2], t, second}});
    relink(old.beside[1], t, second);
    relink(old.beside[2], t, third);
    return {t, second, third};
}

void TriangleNet::splitEdge(int t, int k, int vertex) {
    // A new corner on the edge: split `t` (one child is flat), then turn the edge away.
    const auto children = splitTriangle(t, vertex);
    flipEdge(children[static_cast<std::size_t>(k % 3)], 0);
}

void TriangleNet::flipEdge(int t, int k) {
    const int o = beside(t, k);
    const int m = slotOfNeighbour(o, t);
    const int a = corner(t, k);
    const int b = corner(t, k + 1);
    const int c = corner(t, k + 2);
    const int d = corner(o, m);
    const int overAb = beside(t, k + 2);
    const int overCa = beside(t, k + 1);
    const int overDc = beside(o, m + 2);
    const int overBd = beside(o, m + 1);
    (*this)[t] = {{a, b, d}, {overBd, o, overAb}};
    (*this)[o] = {{a, d, c}, {overDc, overCa, t}};
    relink(overBd, o, t);
    relink(overCa, t, o);
}

void TriangleNet::keep(const std::vector<bool>& kept) {
    std::vector<int> renumbered(triangles.size(), Triangle::kNone);
    std::vector<Triangle> remaining;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (kept[t]) {
            renumbered[t] = static_cast<int>(remaining.size());
            remaining.push_back(triangles[t]);
        }
    }
    for (Triangle& triangle : remaining) {
        for (int& other : triangle.beside) {
            other = other == Triangle::kNone ? other : renumbered[static_cast<std::size_t>(other)];
        }
    }
    triangles = std::move(remaining);
}

}  // namespace toile::samples
