// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "core/pipeline/improve.h"

namespace toile::app {

struct Arguments;

/// The pattern of a garment made to fit it better, as the arguments ask; a line per round, and one
/// on how it ended. Errors: those of `improvePattern`.
Result<Improved> improved(const Arguments& arguments, const Garment& garment,
                          const PieceResults& results, const ProofOrder& proof, Progress& progress,
                          std::ostream& out);

}  // namespace toile::app
