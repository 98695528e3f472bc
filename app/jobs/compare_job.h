// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "app/jobs/job.h"
#include "core/compare/comparison.h"

namespace toile {

struct Scene;

/// What one method makes of one piece.
struct ComparedPiece {
    std::shared_ptr<const PieceResult> result{};  ///< flat, or the reason why not
    ComparedFigures figures{};                    ///< seams: with pieces flattened alike
    std::shared_ptr<const Scene> scene{};         ///< of this piece alone; null where not flat
};

struct CompareOrder {
    std::shared_ptr<const Garment> garment;
    int piece = 0;
    FlattenOptions options{};  ///< the method among them
    /// One per piece: what is known already by these options; null where it is not.
    PieceResults known{};
};

/// Flattens one piece, and those that are sewn to it, by one method, and measures it.
/// @param done  called on the GUI thread; `results`: one per piece of the garment, null where it
///              was of no interest
std::unique_ptr<Job> compareJob(
    CompareOrder order, std::function<void(ComparedPiece made, const PieceResults& results)> done);

}  // namespace toile
