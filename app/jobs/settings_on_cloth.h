// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/jobs/derivation.h"

namespace toile::app {

/// What the state says of the pieces, after a derivation: pieces stay where they are on the sheet,
/// and those without a place, or without a grain where there is a rule for it, get one; where none
/// has a place yet, they lie in rows, none wider than a cloth of the pieces in it. What a piece is
/// cut from follows its layer, unless a person has said it. Idempotent.
/// @param before  settings of the pieces before, in their order
SettingsById settingsAfter(const Derivation& made, const DocumentState& state,
                           const std::vector<PieceSettings>& before);

}  // namespace toile::app
