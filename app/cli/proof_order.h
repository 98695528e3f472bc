// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/garment/garment.h"
#include "core/prove/proof.h"

namespace toile::app {

struct Arguments;

/// What was typed does not suit the garment.
struct UnfitProof {
    std::string sentence;   ///< without its end
    std::string subject{};  ///< the file that it is about, if it is about one
};

using ProofOrdered = std::variant<ProofOrder, Error, UnfitProof>;

/// What is to be sewn and what holds it, as typed; its files are read. Errors: those of
/// `readPatternFile` and `readBody`.
ProofOrdered proofOrder(const Arguments& arguments, const Garment& garment, Progress& progress);

}  // namespace toile::app
