// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/lineage.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "core/garment/piece.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {
namespace {

/// Of the cuts that separated both: the number with different sides, negative, and the number with
/// the same side.
std::pair<int, int> likeness(const Lineage& a, const Lineage& b) {
    std::pair<int, int> sides{0, 0};
    for (const CutSide& side : a.sides) {
        const auto other = std::ranges::find(b.sides, side.cut, &CutSide::cut);
        if (other != b.sides.end()) {
            other->side != side.side ? --sides.first : ++sides.second;
        }
    }
    return sides;
}

}  // namespace

PieceId idOf(const Lineage& lineage) {
    if (lineage.uncut.size() == 1 && lineage.sides.empty()) {
        return lineage.uncut.front();
    }
    std::uint64_t id = 0;
    for (const PieceId& whole : lineage.uncut) {
        id = hashOf({id, whole.value});
    }
    for (const CutSide& side : lineage.sides) {
        id = hashOf({id, side.cut.value, static_cast<std::uint64_t>(side.side)});
    }
    return {id};
}

std::vector<int> predecessors(const Pieces& before, const Pieces& after) {
    std::map<PieceId, int> byId;
    std::map<PieceId, std::vector<int>> byUncut;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] && before[i]->id) {
            byId.emplace(before[i]->id, static_cast<int>(i));
            for (const PieceId& whole : before[i]->lineage.uncut) {
                byUncut[whole].push_back(static_cast<int>(i));
            }
        }
    }
    std::vector<int> found;
    for (const auto& piece : after) {
        const auto same = byId.find(piece->id);
        int best = same == byId.end() ? -1 : same->second;
        std::optional<std::pair<std::pair<int, int>, Eigen::Index>> most;  // likeness, faces
        for (const PieceId& whole : piece->lineage.uncut) {
            if (same != byId.end() || !byUncut.contains(whole)) {
                continue;
            }
            for (const int i : byUncut[whole]) {
                const Piece& old = *before[static_cast<std::size_t>(i)];
                const std::pair score{likeness(piece->lineage, old.lineage), old.mesh.F.rows()};
                if (!most || score > *most) {
                    most = score;
                    best = i;
                }
            }
        }
        found.push_back(best);
    }
    return found;
}

namespace {

using Place = std::array<double, 3>;

/// A rim as vertices, with their positions in the file.
struct Rim {
    std::vector<int> vertices;
    std::vector<Place> places;
};

std::vector<Rim> rimsOf(const Piece& piece, UpAxis up) {
    std::vector<Rim> rims;
    for (RimLoop& loop : rimsOf(piece.mesh, piece.table)) {
        Rim& rim = rims.emplace_back();
        for (const int v : loop.vertices) {
            const Eigen::RowVector3d at = asInFile(up, piece.mesh.V.row(v));
            rim.places.push_back({at.x(), at.y(), at.z()});
        }
        rim.vertices = std::move(loop.vertices);
    }
    return rims;
}

/// Rotates the rim to start at its smallest vertex, independent of the numbering: if two coincide,
/// the following vertices decide. Compares two candidates at a time and skips the common prefix as
/// a whole, so the cost is linear.
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
