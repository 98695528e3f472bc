// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/diagnose/finding.h"
#include "core/garment/garment.h"

namespace toile::app {

/// True if a finding is about pieces of a file that looks like a scan, and the user has not set how
/// to read it. Preparing the scan comes before any remedy for a piece.
bool isOfUnpreparedScan(const Finding& finding, const Garment& garment);

}  // namespace toile::app
