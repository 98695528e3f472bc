// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace toile::fuzz {

/// Patterns of other programs, read as `toile info` does and compared with two pieces as
/// `toile compare` does.
/// @return the first promise that is broken, in words; empty where all are kept: every coordinate
///         finite, closed lines of three points, a second reading the same, a refusal that names
///         the file and the reason, pairs that refer to pieces
/// Cost: that of comparing lines. Re-entrant.
std::string whatBreaksInDxf(std::string bytes);
std::string whatBreaksInSvg(std::string bytes);
std::string whatBreaksInGarmentCode(std::string bytes);

/// Our own files as they are read back: numbers finite, indices in range, a second reading the
/// same, a refusal that gives its reason. Linear. Re-entrant.
std::string whatBreaksInPdf(std::string bytes);
std::string whatBreaksInPlt(std::string bytes);
std::string whatBreaksInGlb(std::string bytes);
std::string whatBreaksInUsda(std::string bytes);

}  // namespace toile::fuzz
