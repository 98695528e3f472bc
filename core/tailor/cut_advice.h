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

/// What a dart takes in where it reaches the rim.
struct DartIntake {
    double width = 0;  ///< mm
    double angle = 0;  ///< radians

    bool operator==(const DartIntake&) const = default;
};

struct AdvisedCut {
    TailorCut what;
    Wording evidence{};
    double length = 0;                      ///< mm
    bool isNeeded = true;                   ///< of those that are enough
    StrainFigures predicted{};              ///< with this and all before it
    std::optional<StrainFigures> solved{};  ///< the same, flattened, where that was done
    std::optional<DartIntake> intake{};     ///< of darts
};

struct AdviceOptions {
    bool isFrontSwapped = false;  ///< the front is where it is not guessed
    /// The mean strain from which on no cut is worth its length. None: seams as tailors have them,
    /// and darts only where strain is beyond that of any cloth.
    std::optional<double> enoughStrain{};
    std::vector<char> borders{};  ///< per edge, as of `fileBorders`; may be empty

    bool operator==(const AdviceOptions&) const = default;
};

/// Cuts for one piece, those first that do most for their length, and what they are worth.
struct CutAdvice {
    bool isWorn = false;     ///< a garment that is worn was recognised
    StrainFigures before{};  ///< predicted for the shortest cuts that open the piece
    std::vector<AdvisedCut> cuts{};
    /// What a part is called that comes of these cuts: "front"; empty where nothing is known.
    std::function<std::string(const Piece&)> nameOf{};
};

/// Marks the cuts that are needed until a mean strain is reached, both sides of a garment alike.
/// None: what is worn needs its usual seams, other forms as many as leave 1.5 %. Linear.
void markNeeded(CutAdvice& advice, const std::optional<double>& enough);

/// Proposes cuts for one piece: as tailors cut what is worn (`tailorCuts`), along ridges and the
/// mirror plane where it is a solid that is to be covered, and darts where strain remains.
/// @param own  cuts that are made anyhow; proposals end on them and do not repeat them
/// Cost: that of `tailorCuts`, and a sparse factorisation for each cut looked at. Deterministic.
/// Pure.
CutAdvice adviseCuts(const std::shared_ptr<const Piece>& piece, const std::vector<UserCut>& own,
                     const AdviceOptions& options, const Progress& progress = {});

}  // namespace toile
