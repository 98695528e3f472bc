// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/prove_text.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "app/cli/input.h"
#include "core/base/characters.h"
#include "core/base/text.h"

namespace toile::app {
namespace {

constexpr int kGapDecimals = 2, kPercentDecimals = 1;
constexpr double kShownSlip = 0.05;  // mm: from here on it is not 0.0

std::string percentText(double share) {
    return fixed(100 * share, kPercentDecimals);
}

void printProvenPieces(const Garment& garment, const Proof& proof, std::ostream& out) {
    Table table({"piece", "gap mm mean", "95 %", "max", "pulls %", "slack %", "free %"});
    for (std::size_t p = 0; p < proof.pieces.size(); ++p) {
        const ProvenPiece& piece = proof.pieces[p];
        const std::string& name = garment.pieces[p]->name;
        if (piece.isSewn()) {
            const sew::SpreadFigures& gap = piece.gapFigures;
            table.add({name, fixed(gap.mean, kGapDecimals), fixed(gap.most95, kGapDecimals),
                       fixed(gap.max, kGapDecimals), percentText(piece.mostPull),
                       percentText(piece.mostSlack), percentText(piece.freeShare)});
        } else {
            table.add({name, "-", "-", "-", "-", "-", "not sewn"});
        }
    }
    table.print(out);
}

/// The worst first; nothing where all fit.
void printSlips(const Garment& garment, const Proof& proof, std::ostream& out) {
    std::vector<ProvenSeam> slips;
    std::ranges::copy_if(proof.seams, std::back_inserter(slips),
                         [](const ProvenSeam& seam) { return std::abs(seam.slip) >= kShownSlip; });
    if (slips.empty()) {
        return;
    }
    std::ranges::stable_sort(slips, std::greater(),
                             [](const ProvenSeam& seam) { return std::abs(seam.slip); });
    out << '\n';
    Table table({"seam that slips", "left mm", "right mm", "slip mm", "strain %"});
    for (const ProvenSeam& seam : slips) {
        table.add({garment.seams.seams[static_cast<std::size_t>(seam.seam)].name,
                   fixed(seam.left, 1), fixed(seam.right, 1), fixed(seam.slip, 1),
                   percentText(seam.strain)});
    }
    table.print(out);
}

void printHow(const Proof& proof, std::ostream& out) {
    out << "sewn from: " << shownText(proof.source, kMaxOfPlace) << "; "
        << shownText(howHeld(proof), kMaxOfPlace) << "; " << counted(proof.triangles, "triangle")
        << " with edges of " << fixed(proof.edge, 1) << " mm; "
        << (proof.hasSettled ? "settled in " : "not settled after ")
        << counted(proof.iterations, "step") << ", " << fixed(100 * restShare(proof), 3)
        << " % of the force at seams is left; " << fixed(proof.seconds, 1) << " s\n";
}

}  // namespace

void printProof(const Garment& garment, const Proof& proof, std::ostream& out) {
    out << shownText(sentence(proof, garment), kMaxOfPlace) << ".\n\n";
    printProvenPieces(garment, proof, out);
    printSlips(garment, proof, out);
    out << '\n';
    for (const ProofFault& fault : proof.faults) {
        out << "fault: " << shownText(fault.told, kMaxOfPlace) << '\n';
    }
    printHow(proof, out);
}

}  // namespace toile::app
