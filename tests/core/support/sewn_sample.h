// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace toile::test {

/// Writes one of our sample garments as the shared ones are, in centimetres: NAME.obj, one surface
/// whose panels share their vertices along the seams, with the panels laid flat side by side as its
/// texture coordinates; NAME_pieces.obj, the panels apart; NAME.truth.json, what is sewn to what,
/// by comparing every outline edge's ends, in the form of the shared truths.
/// @return NAME's path without an ending
std::filesystem::path writeSewnSample(const std::string& name, const std::filesystem::path& folder);

/// That of a sample where the name begins with "samples/", else the shared garment's, without an
/// ending.
std::filesystem::path garmentWithTruth(const std::string& name,
                                       const std::filesystem::path& folder);

}  // namespace toile::test
