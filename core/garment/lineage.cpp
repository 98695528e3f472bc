// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/lineage.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/garment/piece.h"

namespace toile {
namespace {

/// Of the cuts that parted both: on how many they lie on different sides, negative, and on how many
/// on the same.
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
    if (lineage.wholes.size() == 1 && lineage.sides.empty()) {
        return lineage.wholes.front();
    }
    std::uint64_t id = 0;
    for (const PieceId& whole : lineage.wholes) {
        id = hashOf({id, whole.value});
    }
    for (const CutSide& side : lineage.sides) {
        id = hashOf({id, side.cut.value, static_cast<std::uint64_t>(side.side)});
    }
    return {id};
}

std::vector<int> predecessors(const std::vector<std::shared_ptr<const Piece>>& before,
                              const std::vector<std::shared_ptr<const Piece>>& after) {
    std::map<PieceId, int> byId;
    std::map<PieceId, std::vector<int>> byWhole;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] && before[i]->id) {
            byId.emplace(before[i]->id, static_cast<int>(i));
            for (const PieceId& whole : before[i]->lineage.wholes) {
                byWhole[whole].push_back(static_cast<int>(i));
            }
        }
    }
    std::vector<int> found;
    for (const auto& piece : after) {
        const auto same = byId.find(piece->id);
        int best = same == byId.end() ? -1 : same->second;
        std::optional<std::pair<std::pair<int, int>, Eigen::Index>> most;  // likeness, faces
        for (const PieceId& whole : piece->lineage.wholes) {
            if (same != byId.end() || !byWhole.contains(whole)) {
                continue;
            }
            for (const int i : byWhole[whole]) {
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

}  // namespace toile
