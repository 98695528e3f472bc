// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/piece_check.h"

#include <utility>

#include "core/check/finding_place.h"
#include "core/check/strain_check.h"
#include "core/quality/measures.h"
#include "core/quality/outline_crossings.h"

namespace toile {
namespace {

Finding findingOf(const PieceToCut& piece, FindingKind kind, Severity severity) {
    Finding finding;
    finding.kind = kind;
    finding.severity = severity;
    finding.subject = subjectOf(*piece.result.piece);
    finding.pieces = {piece.index};
    return finding;
}

void checkOutline(const PieceToCut& checked, FindingList& found) {
    const PieceResult& result = checked.result;
    if (result.quality && result.quality->outlineCrossings == 0) {
        return;
    }
    const Piece& piece = *result.piece;
    const auto crossings = findOutlineCrossings(result.flat->Q, piece.boundary);
    if (crossings.empty()) {
        return;
    }
    Finding finding = findingOf(checked, FindingKind::OutlineCrosses, Severity::Fault);
    const OutlineCrossing& first = crossings.front();
    finding.place = placeOnOutline(piece, result.flat->Q, first.first, first.place);
    const auto crossingCount = static_cast<long long>(crossings.size());
    finding.figures = {count(static_cast<double>(crossingCount))};
    finding.error = {ErrorCode::OutlineCrosses, subjectOf(piece),
                     countWording(crossingCount, "crossing")};
    for (const Error& note : result.flat->notes) {
        if (note.code == ErrorCode::OutlineCrosses) {
            finding.error = note;  // it knows the cut that helps
        }
    }
    found.add(std::move(finding), static_cast<double>(crossingCount));
}

void checkFlips(const PieceToCut& checked, FindingList& found) {
    const PieceResult& result = checked.result;
    if (result.quality && result.quality->flippedTriangles == 0) {
        return;
    }
    const Piece& piece = *result.piece;
    const Eigen::VectorXd areas = triangleAreas2d(result.flat->Q, piece.mesh.F);
    const int flipped = flippedTriangles(areas);
    if (flipped == 0) {
        return;
    }
    Eigen::Index worst = 0;
    areas.minCoeff(&worst);
    Finding finding = findingOf(checked, FindingKind::FlippedTriangles, Severity::Fault);
    finding.place = placeInTriangle(piece, result.flat->Q, worst);
    finding.figures = {count(flipped), count(static_cast<double>(areas.size()))};
    found.add(std::move(finding), flipped);
}

void addStrain(const PieceToCut& checked, FindingKind kind, const StrainExcess& excess,
               FindingList& found) {
    if (excess.face < 0 || excess.share < kStrainDoubtShare) {
        return;
    }
    Finding finding = findingOf(
        checked, kind, excess.share < kStrainFaultShare ? Severity::Doubt : Severity::Fault);
    finding.place = placeInTriangle(*checked.result.piece, checked.result.flat->Q, excess.face);
    finding.figures = {{excess.strain, Figure::Unit::Strain},
                       {excess.limit, Figure::Unit::Strain},
                       {excess.share, Figure::Unit::Percent}};
    found.add(std::move(finding), excess.severity);
}

void checkStrain(const PieceToCut& checked, FindingList& found) {
    const StrainExcesses excesses =
        strainExcesses(checked.result.piece->mesh, checked.result.flat->Q, checked.fabric,
                       grainOf(checked.settings));
    addStrain(checked, FindingKind::StrainWarp, excesses.warp, found);
    addStrain(checked, FindingKind::StrainWeft, excesses.weft, found);
    addStrain(checked, FindingKind::StrainBias, excesses.bias, found);
}

}  // namespace

void checkPiece(const PieceToCut& piece, FindingList& found) {
    const PieceResult& result = piece.result;
    if (result.error && result.error->code != ErrorCode::Cancelled) {
        Finding finding = findingOf(piece, FindingKind::NotFlat, Severity::Fault);
        finding.error = result.error;
        found.add(std::move(finding));
    }
    if (!result.flat) {
        return;
    }
    checkOutline(piece, found);
    checkFlips(piece, found);
    checkStrain(piece, found);
    if (!piece.settings.grain) {
        found.add(findingOf(piece, FindingKind::GrainMissing, Severity::Doubt));
    }
    for (const Error& note : result.flat->notes) {
        if (note.code != ErrorCode::OutlineCrosses && note.code != ErrorCode::TrianglesFlipped) {
            found.add(note, {piece.index});
        }
    }
}

}  // namespace toile
