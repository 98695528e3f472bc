// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "core/seam/seam_measure.h"
#include "core/seam/seam_origin.h"

namespace toile {
namespace {

/// For each cut of the user's, the seams that it left (`isLeftBy`). A seam is held only to those
/// middles that lie between its ends in x: cuts may be many, and seams thousands.
std::vector<std::vector<Seam*>> seamsOf(const std::vector<MadeCut>& cuts, SeamGraph& graph,
                                        const std::vector<std::shared_ptr<const Piece>>& pieces) {
    std::vector<std::pair<Eigen::Vector3d, std::size_t>> middles;  // and whose
    const auto xOf = [](const auto& middle) { return middle.first.x(); };
    for (std::size_t c = 0; c < cuts.size(); ++c) {
        for (const Eigen::Vector3d& middle : cuts[c].middles) {
            if (cuts[c].author == CutAuthor::User) {
                middles.emplace_back(middle, c);
            }
        }
    }
    std::ranges::stable_sort(middles, {}, xOf);
    std::vector<std::vector<Seam*>> seams(cuts.size());
    for (std::size_t s = 0; s < graph.seams.size() && !middles.empty(); ++s) {
        Seam& seam = graph.seams[s];
        const Piece& piece = *pieces[seam.left.piece];
        const std::vector<int>& loop = loopOf(seam.left, piece);
        Eigen::AlignedBox3d box;
        for (int k = seam.left.first; k <= seam.left.first + seam.left.count; ++k) {
            box.extend(piece.mesh.V.row(loop[k % loop.size()]).transpose());
        }
        const double reach = kOnLine * box.diagonal().norm();
        std::set<std::size_t> left;
        for (auto at = std::ranges::lower_bound(middles, box.min().x() - reach, {}, xOf);
             at != middles.end() && xOf(*at) <= box.max().x() + reach; ++at) {
            if (runsThrough(seam, piece, at->first)) {
                left.insert(at->second);
            }
        }
        for (const std::size_t c : left) {
            seams[c].push_back(&seam);
        }
    }
    return seams;
}

std::string freeName(const std::string& wanted, bool several, const std::set<std::string>& taken) {
    if (!several && !taken.contains(wanted)) {
        return wanted;
    }
    int number = 1;
    while (taken.contains(wanted + " " + std::to_string(number))) {
        ++number;
    }
    return wanted + " " + std::to_string(number);
}

}  // namespace

void nameAfterCuts(SeamGraph& graph, const std::vector<std::shared_ptr<const Piece>>& pieces,
                   const std::vector<MadeCut>& cuts) {
    std::set<std::string> taken;
    for (const Seam& seam : graph.seams) {
        taken.insert(seam.name);
    }
    std::set<const Seam*> named;  // where two cuts run on into one seam the first names it
    std::vector<std::vector<Seam*>> seamsOfCut = seamsOf(cuts, graph, pieces);
    for (std::size_t c = 0; c < cuts.size(); ++c) {
        std::vector<Seam*>& seams = seamsOfCut[c];
        std::erase_if(seams, [&named](const Seam* seam) { return named.contains(seam); });
        for (Seam* seam : seams) {
            named.insert(seam);
            taken.erase(seam->name);
            seam->name = freeName(cuts[c].name, seams.size() > 1, taken);
            taken.insert(seam->name);
        }
    }
}

}  // namespace toile
