// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/flatten/flatten.h"
#include "core/garment/piece.h"
#include "core/quality/piece_quality.h"

namespace toile {

/// One piece after the solver: flat, or the reason why not.
struct PieceResult {
    std::shared_ptr<const Piece> piece;
    FlattenOptions options;
    std::optional<FlatPiece> flat;        ///< points in the plane, before the sheet places them
    std::optional<PieceQuality> quality;  ///< there where flat is
    std::optional<Error> error;           ///< there where flat is not
    double seconds = 0;
};

using PieceResults = std::vector<std::shared_ptr<const PieceResult>>;

}  // namespace toile
