// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace toile::samples {

/// Three corners, anti-clockwise, and the triangle beyond the edge opposite to each corner
/// (kNone on the border).
struct Triangle {
    static constexpr int kNone = -1;

    std::array<int, 3> corner{kNone, kNone, kNone};
    std::array<int, 3> beside{kNone, kNone, kNone};
};

/// Triangles that know their neighbours, with the local operations the mesher is made of.
class TriangleNet {
public:
    std::vector<Triangle> triangles;

    Triangle& operator[](int t) { return triangles[static_cast<std::size_t>(t)]; }

    const Triangle& operator[](int t) const { return triangles[static_cast<std::size_t>(t)]; }

    int size() const { return static_cast<int>(triangles.size()); }

    /// Corner of `t` at slot `k`, with k taken modulo 3.
    int corner(int t, int k) const { return (*this)[t].corner[static_cast<std::size_t>(k % 3)]; }

    int beside(int t, int k) const { return (*this)[t].beside[static_cast<std::size_t>(k % 3)]; }

    /// Slot of the neighbour `other` in triangle `t`.
    int slotOfNeighbour(int t, int other) const;

    /// Corner of the neighbour across slot `k` that does not lie on the shared edge.
    int cornerBeyond(int t, int k) const;

    /// Replaces `t` by three triangles around `vertex`. Returns them; each has `vertex` first.
    std::array<int, 3> splitTriangle(int t, int vertex);

    /// Splits the inner edge opposite slot `k` of `t` at `vertex`: two triangles become four.
    void splitEdge(int t, int k, int vertex);

    /// Turns the inner edge opposite slot `k` of `t`. Afterwards `t` and its neighbour both have
    /// the old corner `k` first.
    void flipEdge(int t, int k);

    /// Keeps the marked triangles only; neighbours outside become kNone.
    void keep(const std::vector<bool>& kept);

private:
    void relink(int t, int from, int to);
};

}  // namespace toile::samples
