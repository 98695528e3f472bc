// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/flatten.h"

// For the sources of this folder only.
namespace toile {

struct FlatteningMemory;
struct Piece;

/// `flatten`, with what is kept from one time to the next, or null.
/// @param memory  `present` is the piece; changed on the way, also where an error comes back
Result<FlatPiece> flattenWith(FlatteningMemory* memory, const Piece& piece,
                              const FlattenOptions& options, const Progress& progress);

}  // namespace toile
