// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/garment/garment.h"
#include "core/garment/split.h"

namespace toile {

struct DivideOptions {
    SplitMode split = SplitMode::Auto;
    /// What can be repaired is, with a note per kind; else it stays as it is.
    bool repair = true;
};

/// Files that fall into more pieces are not divided: no garment has as many, and a piece of one
/// triangle takes up to 8 kB and 0.1 ms.
inline constexpr int kMaxPiecesOfFile = 50'000;

/// A file divided into pieces.
struct DividedFile {
    int partCount = 0;                           ///< beyond `kMaxPiecesOfFile` no pieces are made
    std::vector<std::shared_ptr<Piece>> pieces;  ///< without ids yet (`identify`)
    SplitChoice split;                           ///< the mode used, and why
    Problems problems;                           ///< what triangulating and repair had to say
};

/// Divides a file into pieces, in order of first face, positions scaled to millimetres. Each part
/// is repaired (`repair`) and checked (`makePiece`); one that is no disk keeps its arrays
/// and says why in `defect`. Pieces are named from the file's names for their faces; several of one
/// name get " 2", " 3"; `namePrefix` goes before every name. Where the UV map is the garment's flat
/// pattern, each piece keeps its panel as `reference`.
/// Cost: linear, but for repair. Re-entrant.
DividedFile divide(const SourceFile& file, int fileIndex, const std::string& namePrefix,
                   const DivideOptions& options);

}  // namespace toile
