// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/slits.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/assemble/join_pieces.h"
#include "core/assemble/weld_soup.h"
#include "core/mesh/disk_check.h"
#include "core/mesh/repair.h"

namespace toile {
namespace {

double lengthOf(const MeshArrays& mesh, const RimPairs::Edge& edge) {
    return (mesh.V.row(edge.head) - mesh.V.row(edge.tail)).norm();
}

/// The rims of a piece as loops of edges; rims that do not close are omitted.
std::vector<std::vector<int>> loopsOf(const RimPairs& rims, const std::vector<int>& edges) {
    std::vector<std::vector<int>> loops;
    std::set<int> seen;
    for (const int first : edges) {
        std::vector<int> loop;
        int at = first;
        while (at >= 0 && seen.insert(at).second) {
            loop.push_back(at);
            at = rims.edge(at).next;
        }
        if (!loop.empty() && at == first) {
            loops.push_back(std::move(loop));
        }
    }
    return loops;
}

/// The rims of a piece that are slits: all but the outline whose edges coincide.
std::vector<std::vector<int>> slitLoops(const RimPairs& rims, std::size_t p,
                                        const MeshArrays& mesh) {
    std::vector<std::vector<int>> loops = loopsOf(rims, rims.rims()[p]);
    const auto around = [&](const std::vector<int>& loop) {
        double sum = 0;
        for (const int e : loop) {
            sum += lengthOf(mesh, rims.edge(e));
        }
        return sum;
    };
    if (!loops.empty()) {
        loops.erase(std::ranges::max_element(loops, {}, around));
    }
    std::erase_if(loops, [&](const std::vector<int>& loop) {
        const std::set<int> own(loop.begin(), loop.end());
        return !std::ranges::all_of(loop, [&](int e) { return own.contains(rims.edge(e).mate); });
    });
    return loops;
}

/// A piece with the two sides of these slits merged; null if it would not be a surface.
std::shared_ptr<Piece> withSlitsClosed(const Piece& piece, const RimPairs& rims,
                                       const std::vector<std::vector<int>>& loops) {
    geometry::DisjointSets same(static_cast<int>(piece.mesh.V.rows()));
    for (const std::vector<int>& loop : loops) {
        for (const int e : loop) {  // its head comes with its mate, also in the loop
            same.join(rims.edge(e).tail, rims.edge(rims.edge(e).mate).head);
        }
    }
    MergedVertices merged = mergedVertices(piece.mesh.V, piece.sourceVertex, same);
    MeshArrays mesh{std::move(merged.V), piece.mesh.F};
    for (int& v : cornersOf(mesh.F)) {
        v = merged.number[v];
    }
    EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    if (!isValidSurface(mesh, table)) {
        return nullptr;
    }
    auto made = std::make_shared<Piece>(makePiece(piece.name, std::move(mesh), std::move(table)));
    made->file = piece.file;
    made->sourceVertex = std::move(merged.sourceVertex);
    made->sourceFace = piece.sourceFace;
    return made;
}

}  // namespace

std::vector<Slit> slitsInside(const Pieces& pieces) {
    const RimPairs rims(pieces);
    std::vector<Slit> slits;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const MeshArrays& mesh = pieces[p]->mesh;
        for (const std::vector<int>& loop : slitLoops(rims, p, mesh)) {
            std::set<int> done;
            for (const int e : loop) {
                if (done.contains(e)) {
                    continue;
                }
                const PairedChain chain = chainAround(rims, e);
                Slit slit{static_cast<int>(p), {}, 0};
                slit.points.emplace_back(
                    mesh.V.row(rims.edge(chain.edges.front()).tail).transpose());
                for (const int along : chain.edges) {
                    done.insert({along, rims.edge(along).mate});
                    const Eigen::RowVector3d middle = 0.5 * (mesh.V.row(rims.edge(along).tail) +
                                                             mesh.V.row(rims.edge(along).head));
                    slit.points.emplace_back(middle.transpose());
                    slit.length += lengthOf(mesh, rims.edge(along));
                }
                slit.points.emplace_back(
                    mesh.V.row(rims.edge(chain.edges.back()).head).transpose());
                slits.push_back(std::move(slit));
            }
        }
    }
    return slits;
}

void closeSlits(std::vector<std::shared_ptr<Piece>>& pieces) {
    const Pieces before(pieces.begin(), pieces.end());
    const RimPairs rims(before);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const auto loops = slitLoops(rims, p, pieces[p]->mesh);
        if (loops.empty()) {
            continue;
        }
        if (auto closed = withSlitsClosed(*pieces[p], rims, loops)) {
            pieces[p] = std::move(closed);
        }
    }
}

}  // namespace toile
