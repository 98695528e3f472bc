// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace toile::fuzz {

/// A seams file and a project in memory: read, written and read again, and what they say done to a
/// small garment (a panel and a tube): cuts, joins, ease; a project also flattens it by its method
/// and lays it out.
/// @return the first promise that is broken, in words; empty where all are kept: what is written
///         reads back to the same, a refusal names the file and the reason, and what `whatBreaksIn`
///         (check_garment.h) holds a garment to
/// Cost: that of flattening; files of many points are only read. Re-entrant.
std::string whatBreaksInSeams(std::string bytes);
std::string whatBreaksInProject(std::string bytes);

}  // namespace toile::fuzz
