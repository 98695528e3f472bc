// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "core/prove/proof.h"

namespace toile::app {

/// The sentence, a table of the pieces, the seams whose sides do not fit each other, the faults,
/// and how all was found.
void printProof(const Garment& garment, const Proof& proof, std::ostream& out);

}  // namespace toile::app
