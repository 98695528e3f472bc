// SPDX-License-Identifier: GPL-3.0-or-later
#include "piece.h"

#include <utility>

namespace toile::samples {

namespace {

Vec3 mirrored(Vec3 p) {
    return {-p.x, p.y, p.z};
}

}  // namespace

Piece makePiece(std::string name, const Patch& patch) {
    Piece piece;
    piece.name = std::move(name);
    piece.vertices = patch.space;
    for (const Triangle& triangle : patch.net.triangles) {
        piece.triangles.push_back(triangle.corner);
    }
    return piece;
}

Piece unfoldPiece(std::string name, const Patch& half) {
    Piece piece = makePiece(std::move(name), half);
    std::vector<int> partner(half.space.size());
    for (std::size_t v = 0; v < half.space.size(); ++v) {
        if (v < half.onFold.size() && half.onFold[v]) {
            piece.vertices[v].x = 0.0;
            partner[v] = static_cast<int>(v);
        } else {
            partner[v] = static_cast<int>(piece.vertices.size());
            piece.vertices.push_back(mirrored(half.space[v]));
        }
    }
    for (const Triangle& triangle : half.net.triangles) {
        const auto [a, b, c] = triangle.corner;
        piece.triangles.push_back({partner[static_cast<std::size_t>(a)],
                                   partner[static_cast<std::size_t>(c)],
                                   partner[static_cast<std::size_t>(b)]});
    }
    return piece;
}

Piece mirrorPiece(std::string name, const Piece& piece) {
    Piece other;
    other.name = std::move(name);
    for (const Vec3 p : piece.vertices) {
        other.vertices.push_back(mirrored(p));
    }
    for (const auto [a, b, c] : piece.triangles) {
        other.triangles.push_back({a, c, b});
    }
    return other;
}

}  // namespace toile::samples
