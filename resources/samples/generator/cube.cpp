// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <utility>

#include "shapes.h"

namespace toile::samples {

namespace {

constexpr int kSquares = 8;        // along an edge of the cube
constexpr double kSquare = 25.0;   // mm
constexpr int kRight = kSquares;   // of the wearer, were there one: x = 0 and x = kSquares
using Place = std::array<int, 3>;  // in squares; x to the left, y up, z to the front

/// The cuts: the lower back edge, and at both of its ends the edge up and the edge to the front.
/// They stop short of the corners where they end, so that these stay whole.
bool isOnCut(const Place& p) {
    const auto [x, y, z] = p;
    if (y == 0 && z == 0) {
        return true;
    }
    const bool atAnEnd = x == 0 || x == kRight;
    return atAnEnd && ((z == 0 && y < kSquares) || (y == 0 && z < kSquares));
}

Vec3 inSpace(const Place& p) {
    constexpr double kHalf = kSquares * kSquare / 2;
    return {kSquare * p[0] - kHalf, kSquare * p[1], kSquare * p[2] - kHalf};
}

}  // namespace

Garment makeCubeOpenedAlongH() {
    Piece piece;
    piece.name = "cube";
    // A place on a cut has a vertex for each face of the cube that meets there.
    std::map<std::pair<Place, int>, int> known;
    const auto vertex = [&](const Place& p, int face) {
        const auto [entry, isNew] = known.emplace(std::pair(p, isOnCut(p) ? face : -1),
                                                  static_cast<int>(piece.vertices.size()));
        if (isNew) {
            piece.vertices.push_back(inSpace(p));
        }
        return entry->second;
    };
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const bool isFar = face % 2 == 1;
        const auto at = [&](int i, int j) {
            Place p{};
            p[static_cast<std::size_t>(axis)] = isFar ? kSquares : 0;
            p[static_cast<std::size_t>((axis + 1) % 3)] = i;
            p[static_cast<std::size_t>((axis + 2) % 3)] = j;
            return vertex(p, face);
        };
        for (int i = 0; i < kSquares; ++i) {
            for (int j = 0; j < kSquares; ++j) {
                std::array<int, 4> q{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
                if (!isFar) {
                    std::swap(q[1], q[3]);  // anti-clockwise seen from outside
                }
                const std::size_t k = static_cast<std::size_t>((i + j) % 2);  // alternating
                piece.triangles.push_back({q[k], q[k + 1], q[k + 2]});
                piece.triangles.push_back({q[k], q[k + 2], q[(k + 3) % 4]});
            }
        }
    }
    return {"cube-h",
            "The cube of Wang (2005), Table 1, Example IV: opened along five edges, an H",
            {std::move(piece)}};
}

}  // namespace toile::samples
