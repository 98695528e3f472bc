// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "core/garment/garment.h"

namespace toile {
class Progress;
}  // namespace toile

namespace toile::app {

struct Arguments;

/// Prints, for each piece as it was before cuts of Toile's, the cuts that would take most strain
/// away, and what they leave: foretold for all, solved for the best five.
/// Cost: that of `adviseCuts`, and six flattenings of each piece.
void printAdvice(const Arguments& arguments, const Garment& garment, Progress& progress,
                 std::ostream& out);

}  // namespace toile::app
