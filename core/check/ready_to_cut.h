// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/check/readiness.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/fabric.h"
#include "core/garment/garment.h"
#include "core/marker/cloth_fit.h"
#include "core/pattern/line_settings.h"
#include "core/project/piece_settings.h"

namespace toile {

struct Proof;

/// What is looked through before cloth is cut. All of it immutable and shared, so that a copy for
/// another thread costs nothing.
struct CutPlan {
    std::shared_ptr<const Garment> garment{};  ///< null: nothing is open
    PieceResults results{};                    ///< one per piece, or null, or left out
    FlattenOptions options{};                  ///< as the pieces are to be flattened
    LineSettings lines{};                      ///< and as their outlines are to be drawn
    Fabric fabric = fabricPresets().front();
    MaterialList materials{};                  ///< of pieces that are cut from another fabric
    std::shared_ptr<const Pattern> pattern{};  ///< of all that; or null
    std::vector<PieceSettings> settings{};     ///< one per piece, without anchors; or left out
    PieceLabels labels{};                      ///< what findings call the pieces; or left out
    ClothRules rules{};                        ///< how they may lie on their cloth
    /// The pattern sewn back together: of this garment and these results, as they are; or null.
    std::shared_ptr<const Proof> proof{};
    std::string referenceName{};            ///< of the file that the pieces are compared with
    std::vector<Wording> referenceNotes{};  ///< what reading it left out or put right
    bool guessesKept = false;  ///< unit and up axis, where guessed, are right: a person said so

    bool operator==(const CutPlan&) const = default;
};

/// Kinks at the ends of seams are named from here on, radians; smaller ones designers leave too.
inline constexpr double kTellingKink = 0.08726646259971647;  ///< 5 degrees

/// A garment is larger than a doll's and smaller than a tent; largest extent, mm.
inline constexpr double kSmallestGarment = 10, kLargestGarment = 10000;

/// Looks through everything that a pattern maker would before cutting; docs/ready-to-cut.md names
/// each check and its rule. Seams are judged as the ledger does (core/seam/seam_measure.h). A piece
/// whose result is of another shape than it has now is passed by.
/// Cost: linear in the triangles, a tenth of a second for a million; outlines n log n where
/// they cross or lie near each other. Pure, thread-safe.
/// @param progress  looked at between the checks of pieces; cancelled, the findings are incomplete
Readiness readyToCut(const CutPlan& plan, const Progress& progress = Progress());

/// The verdict and all findings as JSON (docs/ready-to-cut.md). @param readiness  of that garment
std::string writeReadiness(const Garment& garment, const Readiness& readiness);

}  // namespace toile
