// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/diagnose/finding.h"
#include "core/garment/garment.h"

namespace toile::app {

/// Whether a finding is about pieces of a file that looks like a scan, while nobody has said how it
/// is to be read: preparing it comes before anything that helps a piece.
bool isOfUnpreparedScan(const Finding& finding, const Garment& garment);

}  // namespace toile::app
