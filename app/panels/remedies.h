// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "app/actions/action_table.h"
#include "core/check/ready_to_cut.h"
#include "core/diagnose/finding.h"
#include "core/garment/garment.h"

namespace toile::app {

/// What can be done about a finding with the button in its row.
enum class Remedy {
    FlattenNow,
    DivideByUv,
    CutOpen,
    ProposeCuts,  ///< shows cuts as tailors make them, as proposals
    SetUnit,
    SetUpAxis,
    TurnOver,
    StateEase,
    BestGrain,
    ShowStrain,
    PutDart,  ///< from the nearest edge to the worst place, as a proposal
    LayOutAgain,
};

/// True if a finding is about pieces of a file that looks like a scan, and the user has not set how
/// to read it. Preparing the scan comes before any remedy for a piece.
bool isOfUnpreparedScan(const Finding& finding, const Garment& garment);

/// Best remedy first. Empty if the user has to find a solution.
/// @param finding  belongs to `plan`
std::vector<Remedy> remediesFor(const Finding& finding, const CutPlan& plan);

/// Button text: "Cut open".
QString remedyText(Remedy remedy);
/// What the remedy does, as a sentence without a full stop.
QString remedyTip(Remedy remedy);
/// The actions that apply the remedy: one, or several for the user to choose from.
std::vector<ActionId> actionsOf(Remedy remedy);

}  // namespace toile::app
