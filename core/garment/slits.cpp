// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/slits.h"

#include <algorithm>
#include <set>

#include "core/garment/rim_pairs.h"

namespace toile {
namespace {

double lengthOf(const MeshArrays& mesh, const RimPairs::Edge& edge) {
    return (mesh.V.row(edge.head) - mesh.V.row(edge.tail)).norm();
}

/// The rims of a piece as loops of edges; those that do not close are left out.
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

}  // namespace

std::vector<Slit> slitsInside(const std::vector<std::shared_ptr<const Piece>>& pieces) {
    const RimPairs rims(pieces);
    std::vector<Slit> slits;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const MeshArrays& mesh = pieces[p]->mesh;
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
        for (const std::vector<int>& loop : loops) {
            const std::set<int> own(loop.begin(), loop.end());
            if (!std::ranges::all_of(loop,
                                     [&](int e) { return own.contains(rims.edge(e).mate); })) {
                continue;
            }
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

}  // namespace toile
