// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/base/words.h"
#include "core/prove/proof.h"

namespace toile {
namespace {

constexpr Word<ProofFaultKind> kFaultWords[] = {
    {ProofFaultKind::Mirrored, "mirrored"},    {ProofFaultKind::OtherFits, "other-fits"},
    {ProofFaultKind::SeamSlips, "seam-slips"}, {ProofFaultKind::LengthDiffers, "length-differs"},
    {ProofFaultKind::NotThere, "not-there"},   {ProofFaultKind::NotNeeded, "not-needed"},
    {ProofFaultKind::FarOff, "far-off"}};

/// From these values on strain and the free share are reported; 1 is 100 %.
constexpr double kToldStrain = 0.01, kToldFree = 0.1;

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
        return isSeam ? worded("; the seam %1 pulls %2 %, more than the fabric gives", arguments)
                      : worded("; %1 pulls %2 %, more than the fabric gives", arguments);
    }
    if (given && strain <= given->least) {
        return isSeam ? worded("; the seam %1 pulls %2 %, which the fabric gives", arguments)
                      : worded("; %1 pulls %2 %, which the fabric gives", arguments);
    }
    return isSeam ? worded("; the seam %1 pulls %2 %", arguments)
                  : worded("; %1 pulls %2 %", arguments);
}

/// The seam or the piece with most tension or slack; nothing if all is below 1 %.
Wording tellingPlace(const Proof& proof, const Garment& garment) {
    const auto seam = std::ranges::max_element(proof.seams, {}, &ProvenSeam::strain);
    if (seam != proof.seams.end() && seam->strain >= kToldStrain) {
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
    if (pulled->mostPull >= kToldStrain && pulled->mostPull >= slack->mostSlack) {
        const auto number = static_cast<int>(pulled - proof.pieces.begin());
        return pulling(nameOf(pulled), pulled->mostPull, givenBy(proof, {number}), false);
    }
    return slack->mostSlack >= kToldStrain
               ? worded("; %1 bags by %2 %", {nameOf(slack), figure(100 * slack->mostSlack, 1)})
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

std::string_view name(ProofFaultKind kind) {
    return wordOf(kFaultWords, kind);
}

Wording sentence(const Proof& proof, const Garment& garment) {
    Wording said =
        worded("Sewn back it sits %1 mm from the design on average, %2 mm at the worst twentieth",
               {figure(proof.gap.mean, 1), figure(proof.gap.most95, 1)});
    said += tellingPlace(proof, garment);
    if (proof.freeShare >= kToldFree) {
        said += worded("; %1 % of it hangs free", {figure(100 * proof.freeShare)});
    }
    // Pieces that the user left out do not count.
    const auto missing =
        std::ranges::count(proof.faults, ProofFaultKind::NotThere, &ProofFault::kind);
    if (missing > 0) {
        said += worded("; %1 of %2 pieces are not in it",
                       {figure(static_cast<double>(missing)),
                        figure(static_cast<double>(proof.pieces.size()))});
    }
    return said;
}

Wording howHeld(const Proof& proof) {
    const ProofSettings& settings = proof.settings;
    const Wording pressure = typedFigure(settings.pressure);
    Wording said = !proof.hasBody           ? worded("on the design, %1 Pa", {pressure})
                   : proof.bodyName.empty() ? worded("on a body, %1 Pa", {pressure})
                                            : worded("on %1, %2 Pa", {proof.bodyName, pressure});
    if (settings.hasGravity) {
        said += worded(", gravity");
    }
    if (settings.touchesItself) {
        said += worded(", %1 mm off itself", {typedFigure(settings.thickness)});
    }
    if (proof.scale != 1) {
        said += worded(", %1 times as large", {typedFigure(proof.scale)});
    }
    if (settings.stiffness != StatedStiffness()) {
        said += worded(", cloth as typed");
    }
    return said;
}

}  // namespace toile
