// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "core/seam/contacts.h"

namespace toile {
namespace {

// Layers on one line that are paired with each other; more are no garment.
constexpr std::size_t kMostLayers = 8;

/// A boundary edge by what it is in its file.
struct FileEdge {
    std::array<int, 3> key;  ///< file, smaller and larger source position
    int edge;
    bool upwards;  ///< from the smaller to the larger position

    bool operator<(const FileEdge& other) const {
        return key != other.key ? key < other.key : edge < other.edge;
    }
};

std::vector<FileEdge> fileEdges(const std::vector<std::shared_ptr<const Piece>>& pieces,
                                const Outlines& outlines) {
    std::vector<FileEdge> found;
    for (std::size_t o = 0; o < outlines.list.size(); ++o) {
        const Outline& outline = outlines.list[o];
        const Piece& piece = *pieces[outline.piece];
        const int n = outline.size();
        if (piece.sourceVertex.size() != static_cast<std::size_t>(piece.mesh.V.rows())) {
            continue;
        }
        for (int k = 0; k < n; ++k) {
            const int u = piece.sourceVertex[outline.vertices[k]];
            const int v = piece.sourceVertex[outline.vertices[(k + 1) % n]];
            if (u >= 0 && v >= 0 && u != v) {
                found.push_back({{piece.file, std::min(u, v), std::max(u, v)},
                                 outlines.firstEdge[o] + k,
                                 u < v});
            }
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

double lengthOf(const Outlines& outlines, int edge) {
    const int k = outlines.local(edge);
    return outlines.of(edge).arc[k + 1] - outlines.of(edge).arc[k];
}

}  // namespace

std::vector<Contact> sharedContacts(const std::vector<std::shared_ptr<const Piece>>& pieces,
                                    const Outlines& outlines, std::vector<char>& settled) {
    const std::vector<FileEdge> edges = fileEdges(pieces, outlines);
    std::vector<Contact> contacts;
    for (std::size_t from = 0, to = 0; from < edges.size(); from = to) {
        while (to < edges.size() && edges[to].key == edges[from].key) {
            ++to;
        }
        for (std::size_t i = from; i < to && to - from > 1; ++i) {
            settled[edges[i].edge] = 1;
            for (std::size_t j = i + 1; j < std::min(to, i + 1 + kMostLayers); ++j) {
                const bool parallel = edges[i].upwards == edges[j].upwards;
                const double la = lengthOf(outlines, edges[i].edge);
                const double lb = lengthOf(outlines, edges[j].edge);
                contacts.push_back({edges[i].edge, edges[j].edge, 0, la, parallel ? 0 : lb,
                                    parallel ? lb : 0, 0, 0, parallel, to - from == 2});
            }
        }
    }
    return contacts;
}

}  // namespace toile
