// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/name_after_cuts.h"

#include <algorithm>
#include <set>

#include "core/seam/seam_origin.h"

namespace toile {
namespace {

/// The seams that a cut left.
std::vector<Seam*> seamsOf(const MadeCut& cut, SeamGraph& graph,
                           const std::vector<std::shared_ptr<const Piece>>& pieces) {
    std::vector<Seam*> seams;
    for (Seam& seam : graph.seams) {
        if (isLeftBy(seam, cut, pieces)) {
            seams.push_back(&seam);
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
    for (const MadeCut& cut : cuts) {
        if (cut.author != CutAuthor::User) {
            continue;
        }
        std::vector<Seam*> seams = seamsOf(cut, graph, pieces);
        std::erase_if(seams, [&named](const Seam* seam) { return named.contains(seam); });
        for (Seam* seam : seams) {
            named.insert(seam);
            taken.erase(seam->name);
            seam->name = freeName(cut.name, seams.size() > 1, taken);
            taken.insert(seam->name);
        }
    }
}

}  // namespace toile
