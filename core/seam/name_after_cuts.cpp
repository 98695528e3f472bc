// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/name_after_cuts.h"

#include <algorithm>
#include <set>

namespace toile {
namespace {

/// A point of a cut lies on the outline but for rounding: this part of the edge's length.
constexpr double kOnLine = 1e-6;

bool liesOnEdge(const Eigen::RowVector3d& point, const Eigen::RowVector3d& a,
                const Eigen::RowVector3d& b) {
    const Eigen::RowVector3d edge = b - a;
    const double length = edge.norm();
    if (!(length > 0)) {
        return false;
    }
    const double t = std::clamp((point - a).dot(edge) / (length * length), 0.0, 1.0);
    return (a + t * edge - point).norm() <= kOnLine * length;
}

bool runsThrough(const SeamSide& side, const Piece& piece, const Eigen::RowVector3d& point) {
    const int n = static_cast<int>(piece.boundary.size());
    for (int k = side.first; k < side.first + side.count; ++k) {
        if (liesOnEdge(point, piece.mesh.V.row(piece.boundary[k % n]),
                       piece.mesh.V.row(piece.boundary[(k + 1) % n]))) {
            return true;
        }
    }
    return false;
}

/// The seams that a cut left.
std::vector<Seam*> seamsOf(const MadeCut& cut, SeamGraph& graph,
                           const std::vector<std::shared_ptr<const Piece>>& pieces) {
    std::vector<Seam*> seams;
    for (Seam& seam : graph.seams) {
        const auto isOn = [&](const Eigen::Vector3d& point) {
            return runsThrough(seam.left, *pieces[seam.left.piece], point.transpose());
        };
        if (seam.kind != SeamKind::Free && std::ranges::any_of(cut.middles, isOn)) {
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
