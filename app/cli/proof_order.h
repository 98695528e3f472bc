// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "app/cli/refusal.h"
#include "core/base/progress.h"
#include "core/garment/garment.h"
#include "core/prove/proof.h"

namespace toile::app {

struct Arguments;

/// What is to be sewn and what holds it, as typed; its files are read. Refused: what
/// `readPatternFile` and `readBody` say, and `kNotProved` where it does not suit the garment.
std::variant<ProofOrder, Refusal> proofOrder(const Arguments& arguments, const Garment& garment,
                                             Progress& progress);

}  // namespace toile::app
