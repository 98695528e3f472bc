// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/fault_words.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/garment/garment.h"

namespace toile {
namespace {

ProofFault pieceFault(ProofFaultKind kind, const Garment& garment, int piece, Wording told) {
    ProofFault fault{kind, subjectOf(*garment.pieces[static_cast<std::size_t>(piece)])};
    fault.pieces = {piece};
    fault.told = std::move(told);
    return fault;
}

ProofFault seamFault(ProofFaultKind kind, const Garment& garment, int index, double amount) {
    const Seam& seam = garment.seams.seams[static_cast<std::size_t>(index)];
    ProofFault fault{kind, Subject::seam(seam.name, seam.id)};
    fault.pieces = {seam.left.piece};
    if (seam.right.piece != seam.left.piece) {
        fault.pieces.push_back(seam.right.piece);
    }
    fault.seam = index;
    fault.amount = std::abs(amount);
    return fault;
}

const std::string& calledInFile(const FilePiece& piece) {
    return piece.name.empty() ? piece.id : piece.name;
}

}  // namespace

ProofFault clothNowhereNear(double gap, double size) {
    ProofFault fault{ProofFaultKind::FarOff};
    fault.amount = gap;
    fault.told = worded(
        "the cloth ended %1 mm from the design on average, which is %2 mm large; the pattern or "
        "its unit is not that of this garment",
        {figure(gap, 0), figure(size, 0)});
    return fault;
}

Wording patternInOtherUnit(double times, const FileUnit& read) {
    constexpr double kLikely = 1.5;  // a closer unit within this factor is suggested
    double off = kLikely;
    std::optional<LengthUnit> likely;
    for (const LengthUnit unit : kLengthUnits) {
        const double left = times * millimetresPer(unit) / millimetresPer(read);
        if (std::max(left, 1 / left) < off) {
            off = std::max(left, 1 / left);
            likely = unit;
        }
    }
    const Wording share = times > 1 ? figure(times, 0) : figure(times, times < 0.01 ? 4 : 2);
    const Wording was = unitText(read);
    return likely ? worded(
                        "its outlines, read in %1, are %2 times as long as those of the "
                        "garment; it is probably in %3 (--pattern-unit %3)",
                        {was, share, Wording(std::string(symbol(*likely)))})
                  : worded(
                        "its outlines, read in %1, are %2 times as long as those of the "
                        "garment; state its unit, or that of the garment",
                        {was, share});
}

Wording nothingToSew() {
    return worded(
        "nothing of the pattern is a piece of the garment that is flat; take the pattern that was "
        "made of it");
}

Wording patternTooSmall() {
    return worded(
        "its pattern is so small that nothing of it is left in a file; state the unit of the "
        "garment");
}

Wording edgesTooFine(double edge, double triangles, double least) {
    return worded(
        "edges of %1 mm make %2 triangles; from %3 mm on there are few enough of them to be sewn",
        {figure(edge, 1), figure(triangles, 0), figure(std::ceil(10 * least) / 10, 1)});
}

Wording sourceIsReference() {
    return worded("the designer's panels");
}

Wording sourceIsReadBack() {
    return worded("ASTM DXF, read back");
}

ProofFault pieceNotThere(const Garment& garment, int piece) {
    return pieceFault(ProofFaultKind::NotThere, garment, piece,
                      worded("the pattern has no piece %1", {garment.pieces[piece]->name}));
}

ProofFault pieceCrossesItself(const Garment& garment, int piece) {
    return pieceFault(ProofFaultKind::NotThere, garment, piece,
                      worded("the outline of %1 crosses itself in the pattern; it is left out",
                             {garment.pieces[piece]->name}));
}

ProofFault pieceSewnAway(const Garment& garment, int piece) {
    return pieceFault(
        ProofFaultKind::NotThere, garment, piece,
        worded("the sides of %1 are sewn to each other, so that nothing of it is left",
               {garment.pieces[piece]->name}));
}

ProofFault pieceNotNeeded(const FilePiece& piece) {
    ProofFault fault{ProofFaultKind::NotNeeded};
    fault.told = worded("%1 of the pattern is no piece of the garment", {calledInFile(piece)});
    return fault;
}

ProofFault pieceMirrored(const Garment& garment, int piece) {
    return pieceFault(ProofFaultKind::Mirrored, garment, piece,
                      worded("%1 is mirrored in the pattern; it is turned over to be sewn",
                             {garment.pieces[piece]->name}));
}

ProofFault otherPieceFits(const Garment& garment, int piece, int other, const FilePiece& there) {
    ProofFault fault = pieceFault(
        ProofFaultKind::OtherFits, garment, piece,
        worded("what the pattern calls %1 does not fit %2 but %3",
               {calledInFile(there), garment.pieces[piece]->name, garment.pieces[other]->name}));
    fault.pieces.push_back(other);
    return fault;
}

ProofFault seamSlips(const Garment& garment, int seam, double slip) {
    ProofFault fault = seamFault(ProofFaultKind::SeamSlips, garment, seam, slip);
    const Seam& at = garment.seams.seams[static_cast<std::size_t>(seam)];
    const bool isOfOne = at.left.piece == at.right.piece;
    const int longer = slip > 0 ? at.left.piece : at.right.piece;
    fault.told = isOfOne ? worded("%1: the two sides differ by %2 mm more than their ease",
                                  {at.name, figure(fault.amount, 1)})
                         : worded("%1: the side of %2 is %3 mm longer than what it is sewn to",
                                  {at.name, garment.pieces[longer]->name, figure(fault.amount, 1)});
    return fault;
}

ProofFault seamLengthDiffers(const Garment& garment, int seam, double longer) {
    ProofFault fault = seamFault(ProofFaultKind::LengthDiffers, garment, seam, longer);
    const std::string& name = garment.seams.seams[static_cast<std::size_t>(seam)].name;
    fault.told = longer > 0 ? worded("%1 is %2 mm longer in the pattern than on the design",
                                     {name, figure(fault.amount, 1)})
                            : worded("%1 is %2 mm shorter in the pattern than on the design",
                                     {name, figure(fault.amount, 1)});
    return fault;
}

}  // namespace toile
