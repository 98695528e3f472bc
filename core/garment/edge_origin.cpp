// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/edge_origin.h"

#include <algorithm>
#include <array>

#include "core/garment/piece.h"
#include "core/mesh/sides.h"

namespace toile {
namespace {

using Place = std::array<double, 3>;

/// A rim as vertices, and where they are in the file.
struct Rim {
    std::vector<int> vertices;
    std::vector<Place> places;
};

std::vector<Rim> rimsOf(const Piece& piece, UpAxis up) {
    const EdgeTable& table = piece.table;
    const auto vertexCount = static_cast<std::size_t>(piece.mesh.V.rows());
    std::vector<int> next(vertexCount, -1);
    std::vector<char> isDoubtful(vertexCount, 0), isSeen(vertexCount, 0);
    std::vector<int> tails;
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        if (table.isBorder(e)) {
            const int side = table.usesOf(e)[0];
            const int tail = tailOf(piece.mesh.F, side);
            isDoubtful[tail] = next[tail] >= 0 ? 1 : 0;
            next[tail] = headOf(piece.mesh.F, side);
            tails.push_back(tail);
        }
    }
    std::vector<Rim> rims;
    for (const int first : tails) {
        Rim rim;
        int v = first;
        while (v >= 0 && isSeen[v] == 0 && isDoubtful[v] == 0) {
            isSeen[v] = 1;
            const Eigen::RowVector3d at = asInFile(up, piece.mesh.V.row(v));
            rim.vertices.push_back(v);
            rim.places.push_back({at.x(), at.y(), at.z()});
            v = next[v];
        }
        if (v == first && !rim.vertices.empty()) {
            rims.push_back(std::move(rim));
        }
    }
    return rims;
}

/// Makes the rim begin at its least vertex, whatever the numbering: where two lie on each other
/// those after them tell. Two candidates at a time: what one of them begins with is passed by as a
/// whole, so the cost is linear.
void startAtLeast(Rim& rim) {
    const std::size_t n = rim.places.size();
    std::size_t first = 0, other = 1, same = 0;
    while (first < n && other < n && same < n) {
        const Place &a = rim.places[(first + same) % n], &b = rim.places[(other + same) % n];
        if (a == b) {
            ++same;
            continue;
        }
        (b < a ? first : other) += same + 1;
        other += first == other ? 1 : 0;
        same = 0;
    }
    first = std::min(first, other);
    const auto turn = static_cast<std::ptrdiff_t>(first);
    std::rotate(rim.vertices.begin(), rim.vertices.begin() + turn, rim.vertices.end());
    std::rotate(rim.places.begin(), rim.places.begin() + turn, rim.places.end());
}

}  // namespace

LineId lineOf(CutId cut) {
    return {hashOf({cut.value, 'c'})};
}

std::vector<EdgeOrigin> rimOrigins(const Piece& piece, UpAxis up) {
    std::vector<Rim> rims = rimsOf(piece, up);
    for (Rim& rim : rims) {
        startAtLeast(rim);
    }
    std::ranges::stable_sort(rims, {}, &Rim::places);
    std::vector<EdgeOrigin> origins;
    for (std::size_t r = 0; r < rims.size(); ++r) {
        const std::vector<int>& loop = rims[r].vertices;
        const LineId line{hashOf({piece.id.value, r})};
        std::vector<double> arc{0};
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const int head = loop[(k + 1) % loop.size()];
            arc.push_back(arc.back() + (piece.mesh.V.row(head) - piece.mesh.V.row(loop[k])).norm());
        }
        for (std::size_t k = 0; k < loop.size() && arc.back() > 0; ++k) {
            origins.push_back({loop[k],
                               loop[(k + 1) % loop.size()],
                               line,
                               {},
                               arc[k] / arc.back(),
                               arc[k + 1] / arc.back()});
        }
    }
    std::ranges::sort(origins, {}, &EdgeOrigin::tail);
    return origins;
}

const EdgeOrigin* originAt(const std::vector<EdgeOrigin>& origins, int tail) {
    const auto found = std::ranges::lower_bound(origins, tail, {}, &EdgeOrigin::tail);
    return found != origins.end() && found->tail == tail ? &*found : nullptr;
}

}  // namespace toile
