// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "core/base/progress.h"
#include "core/flatten/base/piece_result.h"
#include "core/flatten/flatten.h"
#include "core/pipeline/pipeline.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// Says that a piece is begun. @param done, count  so many are flat by then, of so many
/// Called on the workers, one call after the other, also by one that a cancel leaves behind: it
/// owns what it uses.
using OnPiece = std::function<void(int done, int count, const Piece& begun)>;

/// `flattenGarment` for a garment that is being edited: what the last call found is kept, and only
/// what has changed since is solved again, from what it was.
///
/// A piece that is the same pointer as before, with the same options, gets the same result by
/// pointer. A changed piece goes on from what it was before (`predecessors`; flatten.h says
/// what the result promises after an edit); two pieces that were one both go on from it. Another
/// method begins anew.
///
/// What is found so fast is to be looked at (`FlatPiece::warm`); `settle` puts in its place what
/// `flattenGarment` finds, which follows from the piece and the options alone.
///
/// The mirror plane is kept as long as the garment as divided is the same, whatever is cut or
/// joined, and what follows from it as long as pieces and seams are.
///
/// Thread-safe. Calls may overlap: each begins with what was kept when it began, and the one that
/// ends last is kept. After a cancel the finished pieces are kept, and of the others what was
/// before; a worker left behind changes nothing here.
class GarmentFlattener {
public:
    /// @param mostBytes  kept of all pieces together, meshes and results aside, by an estimate
    ///                   (`PieceFlattener::expectedBytes`). In the garment's order pieces that
    ///                   would go beyond are flattened as `flattenGarment` does, and nothing is
    ///                   kept of them but their results. While a call is on its way what was kept
    ///                   before stays too.
    explicit GarmentFlattener(std::size_t mostBytes = std::size_t{1} << 30U)
        : mostBytes_(mostBytes) {}

    /// As `flattenGarment`, and the same bytes whatever the number of threads, given the same calls
    /// before.
    /// @param known    of some of these pieces, by whomever: what is of these options is handed on
    /// @param onPiece  is told of each piece that is solved
    PieceResults flatten(const Garment& garment, const FlattenOptions& options, Progress& progress,
                         int threads = 0, const PieceResults& known = {},
                         const LineSettings& lines = {}, const OnPiece& onPiece = {});
    /// The results with those that are warm solved anew, by the same options, and drawn by the same
    /// lines, to the same bytes as `flattenGarment`. Cancelled, it leaves the rest as it was.
    PieceResults settle(const Garment& garment, PieceResults results, Progress& progress,
                        int threads = 0, const LineSettings& lines = {});

    /// What the lines are mirrored by; null where they ask for none, where the garment has none, or
    /// after a cancel.
    std::shared_ptr<const Symmetry> symmetryOf(const Garment& garment, const LineSettings& lines,
                                               const Progress& progress = {});

    /// Begins anew.
    void reset();

    /// About what is kept now, meshes and results aside.
    std::size_t keptBytes() const;

private:
    struct Kept {
        std::shared_ptr<const PieceResult> result;
        PieceFlattener flattener;
    };

    using KeptPointer = std::shared_ptr<const Kept>;

    /// The symmetry of a garment, and all that it follows from; the plane from `uncut` alone.
    struct KeptSymmetry {
        std::vector<std::shared_ptr<const Piece>> uncut;
        std::optional<MirrorPlane> plane;
        std::vector<std::shared_ptr<const Piece>> pieces;
        std::vector<double> places;            ///< of the seams' sides
        std::optional<Symmetry> found, close;  ///< `close`: by `withinTolerance`
    };

    std::vector<KeptPointer> snapshot() const;
    PieceResults flattenExactly(const Garment& garment, const FlattenOptions& options,
                                Progress& progress, int threads, const PieceResults& known,
                                const std::vector<OutlineTargets>& targets, const OnPiece& onPiece);
    PieceResults settleExactly(PieceResults results, Progress& progress, int threads);

    const std::size_t mostBytes_;
    mutable std::mutex mutex_;
    std::vector<KeptPointer> kept_;  ///< in the order of the last garment
    std::shared_ptr<const KeptSymmetry> symmetry_;
};

}  // namespace toile
