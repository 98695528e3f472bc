// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "app/actions/action_table.h"
#include "core/check/ready_to_cut.h"
#include "core/diagnose/finding.h"
#include "core/garment/garment.h"

namespace toile::app {

/// What can be done about a finding at once, by the button in its row.
enum class Remedy {
    FlattenNow,
    DivideByUv,
    CutOpen,
    ProposeCuts,  ///< shows tailors' cuts, to be made or not
    SetUnit,
    SetUpAxis,
    TurnOver,
    StateEase,
    BestGrain,
    ShowStrain,
    PutDart,  ///< from the nearest edge to the worst place, as a proposal
    LayOutAgain,
};

/// Whether a finding is about pieces of a file that looks like a scan, while nobody has said how it
/// is to be read: preparing it comes before anything that helps a piece.
bool isOfUnpreparedScan(const Finding& finding, const Garment& garment);

/// The best first; empty where a person has to find the way himself.
/// @param finding  of this plan
std::vector<Remedy> remediesFor(const Finding& finding, const CutPlan& plan);

/// On a button: "Cut open".
QString remedyText(Remedy remedy);
/// What it will do, as a sentence without a full stop.
QString remedyTip(Remedy remedy);
/// What does it, on what the finding is about: one, or several to choose from.
std::vector<ActionId> actionsOf(Remedy remedy);

}  // namespace toile::app
