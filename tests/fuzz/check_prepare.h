// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/io/soup.h"
#include "core/prepare/preparation.h"

namespace toile::fuzz {

/// A file made a garment of as it is said to be read: welded, prepared, divided, cut open.
/// @param soup  in mm
/// @return the first promise that is broken, in words; empty where all are kept: the same garment
///         twice, indices in range, no positions but finite ones where the file has none, what is
///         not done is said, and what `whatBreaksIn` (check_garment.h) holds a garment to
/// Cost: that of preparing, twice. Re-entrant.
std::string whatBreaksInPreparing(const std::shared_ptr<const PolygonSoup>& soup,
                                  const Preparation& preparing);

/// The same of an OFF file in memory, after bytes that say how it is read: kind, surface, layer and
/// half, and three lengths in parts of the file's size. Files of many faces are passed over.
std::string whatBreaksInPreparing(std::string bytes);

}  // namespace toile::fuzz
