// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/proof_words.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/base/wording.h"
#include "core/garment/garment.h"
#include "core/prove/proof.h"

namespace toile {
namespace {

/// @param amount  mm
void setAmount(Finding& fault, double amount) {
    fault.badness = amount;
    if (amount > 0) {
        fault.figures = {{amount, Figure::Unit::Length}};
    }
}

Finding pieceFault(FindingKind kind, const Garment& garment, int piece, Wording told) {
    Finding fault{kind, Severity::Fault,
                  subjectOf(*garment.pieces[static_cast<std::size_t>(piece)])};
    fault.pieces = {piece};
    fault.reason = std::move(told);
    return fault;
}

Finding seamFault(FindingKind kind, const Garment& garment, int index, double amount,
                  Severity severity) {
    const Seam& seam = garment.seams.seams[static_cast<std::size_t>(index)];
    Finding fault{kind, severity, Subject::seam(seam.name, seam.id)};
    fault.pieces = {seam.left.piece};
    if (seam.right.piece != seam.left.piece) {
        fault.pieces.push_back(seam.right.piece);
    }
    fault.seam = index;
    setAmount(fault, std::abs(amount));
    return fault;
}

const std::string& calledInFile(const FilePiece& piece) {
    return piece.name.empty() ? piece.id : piece.name;
}

}  // namespace

Finding clothNowhereNear(double gap, double size) {
    Finding fault{FindingKind::FarOff, Severity::Fault};
    setAmount(fault, gap);
    fault.reason = worded(
        "the cloth ended %1 mm from the design on average, on a design of %2 mm; check that "
        "pattern and unit belong to this garment",
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
                        "its outlines, read in %1, are %2 times as long as those of the garment; "
                        "set its unit, or that of the garment",
                        {was, share});
}

Wording nothingToSew() {
    return worded(
        "no piece of the pattern is a flat piece of the garment; use a pattern made from this "
        "garment");
}

Wording patternTooSmall() {
    return worded("its pattern is too small to be written to a file; set the unit of the garment");
}

Wording edgesTooFine(double edge, double triangles, double least) {
    return worded("edges of %1 mm make %2 triangles, too many to sew; use edges of %3 mm or more",
                  {figure(edge, 1), figure(triangles, 0), figure(std::ceil(10 * least) / 10, 1)});
}

Wording sourceIsReference() {
    return worded("the designer's panels");
}

Wording sourceIsReadBack() {
    return worded("ASTM DXF, read back");
}

Finding pieceNotThere(const Garment& garment, int piece) {
    return pieceFault(FindingKind::NotThere, garment, piece,
                      worded("the pattern has no piece %1", {garment.pieces[piece]->name}));
}

Finding pieceCrossesItself(const Garment& garment, int piece) {
    return pieceFault(
        FindingKind::NotThere, garment, piece,
        worded("the outline of %1 crosses itself in the pattern, so the piece is left out",
               {garment.pieces[piece]->name}));
}

Finding pieceSewnAway(const Garment& garment, int piece) {
    return pieceFault(FindingKind::NotThere, garment, piece,
                      worded("the sides of %1 are sewn to each other, so nothing of it is left",
                             {garment.pieces[piece]->name}));
}

Finding pieceNotNeeded(const FilePiece& piece) {
    Finding fault{FindingKind::NotNeeded, Severity::Fault};
    fault.reason = worded("the garment has no piece for %1 of the pattern", {calledInFile(piece)});
    return fault;
}

Finding pieceMirrored(const Garment& garment, int piece) {
    return pieceFault(FindingKind::Mirrored, garment, piece,
                      worded("%1 is mirrored in the pattern and is turned over for sewing",
                             {garment.pieces[piece]->name}));
}

Finding otherPieceFits(const Garment& garment, int piece, int other, const FilePiece& there) {
    Finding fault = pieceFault(
        FindingKind::OtherFits, garment, piece,
        worded("%1 of the pattern does not fit %2, but %3",
               {calledInFile(there), garment.pieces[piece]->name, garment.pieces[other]->name}));
    fault.pieces.push_back(other);
    return fault;
}

Finding seamSlips(const Garment& garment, int seam, double slip) {
    Finding fault = seamFault(FindingKind::SeamSlips, garment, seam, slip, Severity::Fault);
    const Seam& at = garment.seams.seams[static_cast<std::size_t>(seam)];
    const bool isOfOne = at.left.piece == at.right.piece;
    const int longer = slip > 0 ? at.left.piece : at.right.piece;
    fault.reason = isOfOne
                       ? worded("%1: the two sides differ by %2 mm more than their ease",
                                {at.name, figure(fault.badness, 1)})
                       : worded("%1: the side of %2 is %3 mm longer than the other side",
                                {at.name, garment.pieces[longer]->name, figure(fault.badness, 1)});
    return fault;
}

Finding seamLengthDiffers(const Garment& garment, int seam, double longer) {
    Finding fault = seamFault(FindingKind::LengthDiffers, garment, seam, longer, Severity::Doubt);
    const std::string& name = garment.seams.seams[static_cast<std::size_t>(seam)].name;
    fault.reason = longer > 0 ? worded("%1 is %2 mm longer in the pattern than on the design",
                                       {name, figure(fault.badness, 1)})
                              : worded("%1 is %2 mm shorter in the pattern than on the design",
                                       {name, figure(fault.badness, 1)});
    return fault;
}

namespace {

/// From these values on strain and the free share are reported; 1 is 100 %.
constexpr double kReportedStrain = 0.01, kReportedFree = 0.1;

/// Stretch limits of the fabrics of some pieces along warp, weft and bias.
struct Given {
    double least, most;  ///< over all directions and fabrics: smallest and largest limit
};

std::optional<Given> givenBy(const Proof& proof, std::initializer_list<int> pieces) {
    std::optional<Given> given;
    for (const int piece : pieces) {
        if (piece < 0 || piece >= std::ssize(proof.fabrics)) {
            return std::nullopt;
        }
        const Fabric& fabric = proof.fabrics[static_cast<std::size_t>(piece)];
        if (!hasLimits(fabric)) {
            return std::nullopt;
        }
        const auto [least, most] =
            std::minmax({fabric.warp.most, fabric.weft.most, fabric.bias.most});
        given = given ? Given{std::min(given->least, least), std::max(given->most, most)}
                      : Given{least, most};
    }
    return given;
}

/// Compares the strain with the fabric's limits; mentions them only if all directions agree.
Wording pulling(const Wording& subject, double strain, const std::optional<Given>& given,
                bool isSeam) {
    const std::vector<Wording> arguments{subject, figure(100 * strain, 1)};
    if (given && strain > given->most) {
        return isSeam
                   ? worded(". Tightest seam: %1, %2 %, more than the fabric allows", arguments)
                   : worded(". Tightest piece: %1, %2 %, more than the fabric allows", arguments);
    }
    if (given && strain <= given->least) {
        return isSeam ? worded(". Tightest seam: %1, %2 %, which the fabric allows", arguments)
                      : worded(". Tightest piece: %1, %2 %, which the fabric allows", arguments);
    }
    return isSeam ? worded(". Tightest seam: %1, %2 %", arguments)
                  : worded(". Tightest piece: %1, %2 %", arguments);
}

/// The seam or the piece with most tension or slack; nothing if all is below 1 %.
Wording tellingPlace(const Proof& proof, const Garment& garment) {
    const auto seam = std::ranges::max_element(proof.seams, {}, &ProvenSeam::strain);
    if (seam != proof.seams.end() && seam->strain >= kReportedStrain) {
        const Seam& sewn = garment.seams.seams[static_cast<std::size_t>(seam->seam)];
        return pulling(sewn.name, seam->strain, givenBy(proof, {sewn.left.piece, sewn.right.piece}),
                       true);
    }
    const auto pulled = std::ranges::max_element(proof.pieces, {}, &ProvenPiece::mostPull);
    const auto slack = std::ranges::max_element(proof.pieces, {}, &ProvenPiece::mostSlack);
    if (pulled == proof.pieces.end()) {
        return {};
    }
    const auto nameOf = [&](const auto& piece) {
        return garment.pieces[static_cast<std::size_t>(piece - proof.pieces.begin())]->name;
    };
    if (pulled->mostPull >= kReportedStrain && pulled->mostPull >= slack->mostSlack) {
        const auto number = static_cast<int>(pulled - proof.pieces.begin());
        return pulling(nameOf(pulled), pulled->mostPull, givenBy(proof, {number}), false);
    }
    return slack->mostSlack >= kReportedStrain
               ? worded(". Loosest piece: %1, %2 % slack",
                        {nameOf(slack), figure(100 * slack->mostSlack, 1)})
               : Wording();
}

/// The figure with no more decimals than needed.
Wording typedFigure(double value) {
    constexpr int kMaxDecimals = 4;
    int decimals = 0;
    for (double ten = value; decimals < kMaxDecimals && std::abs(ten - std::round(ten)) > 1e-9;
         ++decimals) {
        ten *= 10;
    }
    return figure(value, decimals);
}

}  // namespace

Wording sentence(const Proof& proof, const Garment& garment) {
    Wording stated;
    if (!proof.hasSettled && proof.iterations > 0) {
        stated = worded("Not settled after %1 steps, so all figures are rough. ",
                        {figure(proof.iterations)});
    }
    stated += worded("The sewn pattern is %1 mm from the design on average, 95 % within %2 mm",
                     {figure(proof.gap.mean, 1), figure(proof.gap.most95, 1)});
    stated += tellingPlace(proof, garment);
    if (proof.freeShare >= kReportedFree) {
        stated += worded(". %1 % hangs free", {figure(100 * proof.freeShare)});
    }
    // Pieces that the user left out do not count.
    const auto missing = std::ranges::count(proof.faults, FindingKind::NotThere, &Finding::kind);
    if (missing > 0) {
        stated += worded(". %1 of %2 pieces are missing",
                         {figure(static_cast<double>(missing)),
                          figure(static_cast<double>(proof.pieces.size()))});
    }
    return stated;
}

Wording howHeld(const Proof& proof) {
    const ProofSettings& settings = proof.settings;
    const Wording pressure = typedFigure(settings.pressure);
    Wording stated = !proof.hasBody           ? worded("on the design, %1 Pa", {pressure})
                     : proof.bodyName.empty() ? worded("on a body, %1 Pa", {pressure})
                                              : worded("on %1, %2 Pa", {proof.bodyName, pressure});
    if (settings.hasGravity) {
        stated += worded(", gravity");
    }
    if (settings.touchesItself) {
        stated += worded(", %1 mm between layers", {typedFigure(settings.thickness)});
    }
    if (proof.scale != 1) {
        stated += worded(", scaled by %1", {typedFigure(proof.scale)});
    }
    if (settings.stiffness != StatedStiffness()) {
        stated += worded(", own stiffness values");
    }
    return stated;
}

}  // namespace toile
