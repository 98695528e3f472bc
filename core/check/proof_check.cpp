// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/proof_check.h"

#include <algorithm>
#include <utility>

#include "core/check/piece_check.h"
#include "core/prove/proof.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

/// The piece's flat result; null if it has none or one of another shape.
const PieceResult* flatResult(const CutPlan& plan, int piece) {
    const auto i = static_cast<std::size_t>(piece);
    const PieceResult* result =
        piece >= 0 && i < plan.results.size() ? plan.results[i].get() : nullptr;
    return result && result->flat && result->piece == plan.garment->pieces[i] ? result : nullptr;
}

Severity severityOf(ProofFaultKind kind) {
    // A method with a free outline changes both sides alike, so the seam can still be sewn.
    return kind == ProofFaultKind::LengthDiffers ? Severity::Doubt : Severity::Fault;
}

/// Whether another finding already reports it.
bool isToldElsewhere(const CutPlan& plan, const ProofFault& fault) {
    if (fault.kind == ProofFaultKind::NotThere) {
        return std::ranges::none_of(fault.pieces, [&](int piece) {
            const PieceResult* result = flatResult(plan, piece);
            return result && !(result->quality && result->quality->outlineCrossings > 0);
        });
    }
    const auto& seams = plan.garment->seams.seams;
    const auto seam = static_cast<std::size_t>(fault.seam);
    if (fault.kind != ProofFaultKind::SeamSlips || fault.seam < 0 || seam >= seams.size() ||
        !flatResult(plan, seams[seam].left.piece) || !flatResult(plan, seams[seam].right.piece)) {
        return false;
    }
    const SeamFit fit = seamFit(seams[seam], measured(*plan.garment, plan.results, fault.seam));
    return fit == SeamFit::Nearly || fit == SeamFit::Differs;
}

void checkFaults(const CutPlan& plan, FindingList& found) {
    for (const ProofFault& fault : plan.proof->faults) {
        if (isToldElsewhere(plan, fault)) {
            continue;
        }
        Finding finding;
        finding.kind = FindingKind::ProofFault;
        finding.severity = severityOf(fault.kind);
        finding.subject = fault.subject;
        finding.pieces = fault.pieces;
        finding.seam = fault.seam;
        finding.reason = fault.told;
        if (fault.amount > 0) {
            finding.figures = {{fault.amount, Figure::Unit::Length}};
        }
        found.add(std::move(finding), fault.amount);
    }
}

/// A gap measured before the cloth came to rest may be far too small.
void checkRest(FindingList& found) {
    Finding finding;
    finding.kind = FindingKind::ProofFault;
    finding.severity = Severity::Doubt;
    finding.reason =
        worded("sewn back, the cloth has not come to rest, so that the gap says little");
    found.add(std::move(finding));
}

void checkGap(const CutPlan& plan, FindingList& found) {
    const Proof& proof = *plan.proof;
    if (!proof.hasSettled) {
        checkRest(found);
        return;
    }
    if (!(proof.gap.mean >= kDoubtfulGap)) {
        return;
    }
    const auto meanOf = [](const ProvenPiece& piece) {
        return piece.isSewn() ? piece.gapFigures.mean : -1;
    };
    const auto farthest = std::ranges::max_element(proof.pieces, {}, meanOf);
    const auto index = static_cast<std::size_t>(farthest - proof.pieces.begin());
    const Piece& piece = *plan.garment->pieces[index];
    Finding finding;
    finding.kind = FindingKind::SewnGap;
    finding.severity = Severity::Doubt;
    finding.subject = subjectOf(piece);
    finding.pieces = {static_cast<int>(index)};
    finding.figures = {{proof.gap.mean, Figure::Unit::Length},
                       {proof.gap.most95, Figure::Unit::Length},
                       {farthest->gapFigures.mean, Figure::Unit::Length}};
    const int vertex = farthest->gapFigures.place;
    const PieceResult* result = flatResult(plan, static_cast<int>(index));
    if (result && vertex >= 0 && vertex < piece.mesh.V.rows()) {
        finding.place = placeAtVertex(piece, result->flat->Q, vertex);
    }
    found.add(std::move(finding), proof.gap.mean);
}

}  // namespace

void checkProof(const CutPlan& plan, FindingList& found) {
    if (plan.proof && !plan.proof->pieces.empty() &&
        plan.proof->pieces.size() == plan.garment->pieces.size()) {
        checkFaults(plan, found);
        checkGap(plan, found);
    }
}

}  // namespace toile
