// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/rim_pairs.h"

#include <set>

#include <Eigen/Geometry>

#include "core/mesh/mesh_arrays.h"

namespace toile {
namespace {

bool isUsable(const std::shared_ptr<const Piece>& piece) {
    return piece && piece->mesh.F.rows() > 0 && piece->mesh.V.allFinite();
}

double toleranceOf(const Pieces& pieces) {
    Eigen::AlignedBox3d box;
    for (const auto& piece : pieces) {
        if (isUsable(piece)) {
            box.extend(Eigen::Vector3d(piece->mesh.V.colwise().minCoeff().transpose()));
            box.extend(Eigen::Vector3d(piece->mesh.V.colwise().maxCoeff().transpose()));
        }
    }
    return box.isEmpty() ? 0 : kRimTolerance * box.diagonal().norm();
}

}  // namespace

RimPairs::RimPairs(const Pieces& pieces)
    : rims_(pieces.size()), index_(places_, toleranceOf(pieces)) {
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        if (isUsable(pieces[p])) {
            add(*pieces[p], static_cast<int>(p), {});
        }
    }
    for (const auto& [ends, edges] : between_) {
        findMates(ends);
    }
}

void RimPairs::replace(int left, int right, const Piece& made) {
    std::vector<int> old = std::exchange(rims_[left], {});
    old.insert(old.end(), rims_[right].begin(), rims_[right].end());
    rims_[right].clear();
    std::set<Ends> changed;
    for (const int e : old) {
        std::erase(between_[ends_[e]], e);
        changed.insert(ends_[e]);
    }
    add(made, left, std::move(old));
    for (const int e : rims_[left]) {
        changed.insert(ends_[e]);
    }
    for (const Ends& ends : changed) {
        findMates(ends);
    }
}

void RimPairs::add(const Piece& piece, int index, std::vector<int> numbers) {
    const EdgeTable& table = piece.table;
    std::vector<int>& rim = rims_[index];
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        if (!table.isBorder(e)) {
            continue;
        }
        if (numbers.empty()) {
            numbers.push_back(static_cast<int>(edges_.size()));
            edges_.emplace_back();
            ends_.emplace_back();
        }
        const int number = numbers.back();
        numbers.pop_back();
        const int side = table.usesOf(e)[0];
        const int tail = tailOf(piece.mesh.F, side), head = headOf(piece.mesh.F, side);
        edges_[number] = {index, tail, head};
        const int from = index_.insert(piece.mesh.V.row(tail)).first;
        ends_[number] = {from, index_.insert(piece.mesh.V.row(head)).first};
        between_[ends_[number]].push_back(number);
        rim.push_back(number);
    }
    link(rim, piece.mesh.V.rows());
}

/// Links each edge to the next; none at a vertex where several edges begin or end.
void RimPairs::link(const std::vector<int>& rim, Eigen::Index vertexCount) {
    std::vector<int> leaving(vertexCount, kNone), arriving(vertexCount, kNone);
    const auto note = [](int& slot, int e) { slot = slot == kNone ? e : kSeveral; };
    for (const int e : rim) {
        note(leaving[edges_[e].tail], e);
        note(arriving[edges_[e].head], e);
    }
    for (const int e : rim) {
        const int next = leaving[edges_[e].head];
        if (next >= 0 && arriving[edges_[e].head] == e) {
            edges_[e].next = next;
            edges_[next].prev = e;
        }
    }
}

/// Among all edges between two places.
void RimPairs::findMates(const Ends& ends) {
    const std::vector<int> none;
    const auto edgesBetween = [&](const Ends& key) -> const std::vector<int>& {
        const auto found = between_.find(key);
        return found == between_.end() ? none : found->second;
    };
    const std::vector<int>& along = edgesBetween(ends);
    const std::vector<int>& against = edgesBetween({ends.second, ends.first});
    const bool areSingle = along.size() == 1 && against.size() == 1;
    const bool areApart = along.empty() || against.empty() || ends.first == ends.second;
    for (const auto& [edges, others] : {std::pair(&along, &against), std::pair(&against, &along)}) {
        for (const int e : *edges) {
            edges_[e].mate = areApart ? kNone : areSingle ? others->front() : kSeveral;
        }
    }
}

PairedChain chainAround(const RimPairs& rims, int seed) {
    PairedChain chain{{seed}};
    std::set<int> used{seed, rims.edge(seed).mate};
    const auto mateOf = [&rims](int e) { return rims.edge(e).mate; };
    // At the tip of a dart the edge continues with its own mate: the seam ends there.
    const auto isFree = [&](int e) { return e >= 0 && mateOf(e) >= 0 && !used.contains(e); };
    const auto areInRow = [&](int e, int next) {
        return rims.edge(mateOf(next)).next == mateOf(e);
    };
    const auto take = [&](int e, std::vector<int>& edges) {
        used.insert({e, mateOf(e)});
        edges.push_back(e);
    };
    int last = seed, next = rims.edge(seed).next;
    for (; isFree(next) && areInRow(last, next); next = rims.edge(last).next) {
        take(next, chain.edges);
        last = next;
    }
    if (next == seed && areInRow(last, seed)) {
        chain.closed = chain.edges.size() > 2;
        return chain;
    }
    std::vector<int> ahead;
    int first = seed;
    for (int e = rims.edge(seed).prev; isFree(e) && areInRow(e, first); e = rims.edge(first).prev) {
        take(e, ahead);
        first = e;
    }
    chain.edges.insert(chain.edges.begin(), ahead.rbegin(), ahead.rend());
    return chain;
}

}  // namespace toile
