// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/cli/refusal.h"
#include "core/base/progress.h"
#include "core/garment/garment.h"
#include "core/prove/proof.h"

namespace toile::app {

struct Arguments;

/// How a pattern is proved: what the project says, with what was typed in its place. Stiffness that
/// a project states is that of its own fabric, and does not go with another. A pattern that is
/// improved is the garment's own.
ProofPlan proofPlanOf(const Arguments& arguments);

/// What holds the cloth, by `proofPlanOf`, with the body read; what is sewn is the garment's own
/// pattern. Refused: what `readBody` says, and `kNotProved` where it does not suit the garment.
std::variant<ProofOrder, Refusal> orderOfOwn(const Arguments& arguments, const Garment& garment,
                                             Progress& progress);

/// What reading the pattern of a file left out or put right; empty without such a file.
std::vector<std::string> notesOf(const ProofOrder& order);

/// The same with what is to be sewn, read too. Refused: also what `readPatternFile` says.
std::variant<ProofOrder, Refusal> proofOrder(const Arguments& arguments, const Garment& garment,
                                             Progress& progress);

}  // namespace toile::app
