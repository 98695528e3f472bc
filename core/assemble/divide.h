// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/assemble/split.h"
#include "core/base/progress.h"
#include "core/garment/garment.h"
#include "core/garment/records.h"
#include "core/io/soup.h"

namespace toile {

struct DivideOptions {
    SplitMode split = SplitMode::Auto;
    /// Repair pieces, with a note per kind of fault; else they are unchanged.
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
    Problems problems;                           ///< from triangulating and repair
};

/// Divides a file into pieces, in order of first face, positions scaled to millimetres. Each part
/// is repaired (`repair`) and checked (`makePiece`); a part that is not a disk keeps its arrays and
/// stores the reason in `defect`. Pieces are named from the file's names for their faces; equal
/// names get " 2", " 3"; `namePrefix` is put in front of every name. If the UV map is the garment's
/// flat pattern, each piece keeps its panel as `reference`.
/// Cost: linear, except for repair. Re-entrant.
DividedFile divide(const SourceFile& file, int fileIndex, const std::string& namePrefix,
                   const DivideOptions& options);

/// The division of the file with the largest share of pieces that can lie flat, if that share is
/// larger than the present one, and with more pieces; of equal shares the one with fewer pieces.
/// Compares UV islands, objects, groups, materials and connected parts, by topology alone: before
/// any repair, and a piece with holes does not count as flat.
/// Cost: linear, about a second for all at a million triangles. Pure. Nothing after a cancel.
std::optional<DivisionCount> betterDivision(const PolygonSoup& soup, const DivisionCount& present,
                                            const Progress& progress = {});

}  // namespace toile
