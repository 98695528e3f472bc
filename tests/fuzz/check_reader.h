// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/garment/piece.h"
#include "core/io/soup.h"

namespace toile::fuzz {

using ReadFunction = Result<PolygonSoup> (*)(std::shared_ptr<const std::string>, const std::string&,
                                             Progress&);

/// Inputs beyond these bounds are passed over: a fuzzer learns nothing from them but patience.
inline constexpr std::size_t kMaxBytes = 64 * 1024;
inline constexpr int kMaxFaces = 5000;

/// Reads the bytes, and where they are taken in goes on as the program does: triangles, division
/// into pieces (each way there is to divide, repaired and not), check for disks, half-edges.
/// @return the first promise that is broken, in words; empty where all are kept, which includes
///         every refusal that gives its reason
/// Cost: linear in the bytes but for polygons of many corners. Re-entrant.
std::string whatBreaks(ReadFunction reader, std::string bytes);

/// Promises of a piece as divided: where everything comes from, indices in range, an outline or a
/// defect in words. Empty where all are kept. Linear.
std::string whatBreaksIn(const Piece& piece, const PolygonSoup& soup);

}  // namespace toile::fuzz
