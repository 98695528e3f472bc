// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/garment/cut_pieces.h"
#include "core/garment/piece.h"
#include "core/tailor/strain_model.h"
#include "core/tailor/tailor_cuts.h"

namespace toile {

/// Amount that a dart takes in at the rim.
struct DartIntake {
    double width = 0;  ///< mm
    double angle = 0;  ///< radians

    bool operator==(const DartIntake&) const = default;
};

struct AdvisedCut {
    TailorCut what;
    Wording evidence{};
    double length = 0;                      ///< mm
    bool isNeeded = true;                   ///< part of the sufficient set
    StrainFigures predicted{};              ///< with this and all earlier cuts
    std::optional<StrainFigures> solved{};  ///< the same after flattening, if it was done
    std::optional<DartIntake> intake{};     ///< for darts
};

struct AdviceOptions {
    bool isFrontSwapped = false;  ///< the front is opposite to the guess
    /// Mean strain below which no cut is worth its length. None: tailors' usual seams, and darts
    /// only if strain exceeds that of any cloth.
    std::optional<double> enoughStrain{};
    std::vector<char> borders{};  ///< per edge, from `fileBorders`; may be empty

    bool operator==(const AdviceOptions&) const = default;
};

/// Cuts for one piece, the greatest gain for their length first, and their effect.
struct CutAdvice {
    bool isWorn = false;     ///< the piece was recognised as a worn garment
    StrainFigures before{};  ///< predicted for the shortest cuts that open the piece
    std::vector<AdvisedCut> cuts{};
    /// Name of a part that results from these cuts: "front"; empty if unknown.
    std::function<std::string(const Piece&)> nameOf{};
};

/// Marks the cuts that are needed to reach a mean strain, symmetrically on both sides of a garment.
/// None: worn garments need their usual seams, other forms enough to leave 1.5 %. Linear.
void markNeeded(CutAdvice& advice, const std::optional<double>& enough);

/// Proposes cuts for one piece: tailors' cuts for worn garments (`tailorCuts`), cuts along ridges
/// and the mirror plane for solids to cover, and darts where strain remains.
/// @param own  cuts that are made in any case; proposals end on them and do not repeat them
/// Cost: that of `tailorCuts`, and a sparse factorisation for each cut looked at. Deterministic.
/// Pure.
CutAdvice adviseCuts(const std::shared_ptr<const Piece>& piece, const std::vector<UserCut>& own,
                     const AdviceOptions& options, const Progress& progress = {});

}  // namespace toile
