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
#include "core/garment/garment.h"
#include "core/symmetry/symmetry.h"
#include "core/toile/piece_work.h"
#include "core/toile/pipeline.h"

namespace toile {

/// `flattenGarment` for a garment that is being edited: keeps the results of the last call and
/// solves only changed pieces again, starting from their last solution.
///
/// A piece that is the same pointer as before, with the same options, gets the same result by
/// pointer. A changed piece starts from its predecessor (`predecessors`; flatten.h documents the
/// result after an edit); both parts of a cut piece start from it. Another method starts from
/// scratch.
///
/// These fast results are for viewing (`FlatPiece::warm`). `settle` replaces them by those of
/// `flattenGarment`, which depend on the piece and the options alone.
///
/// The mirror plane is kept while the division of the garment stays the same, whatever is cut or
/// joined. The rest of the symmetry is kept while pieces and seams stay the same.
///
/// Thread-safe. Calls may overlap: each starts from the state at its beginning, and the state of
/// the call that ends last is kept. After a cancel, finished pieces are kept, and the others keep
/// their earlier state. A cancelled call returns within `kCancelSeconds`; workers that have not
/// ended then change nothing here, and the destructor waits for them.
class GarmentFlattener {
public:
    /// @param mostBytes  limit for all pieces together, meshes and results aside, by an estimate
    ///                   (`PieceFlattener::expectedBytes`). In the garment's order, pieces beyond
    ///                   the limit are flattened as `flattenGarment` does, and only their results
    ///                   are kept. During a call the earlier state is kept too.
    explicit GarmentFlattener(std::size_t mostBytes = std::size_t{1} << 30U)
        : mostBytes_(mostBytes) {}

    /// Like `flattenGarment`; the same earlier calls give the same bytes with any number of
    /// threads.
    /// @param known    results of some of these pieces: those with the same options are reused
    /// @param onPiece  called for each piece that is solved
    /// @param cloths   one per piece, or empty: a result with another cloth is reused if the energy
    ///                 does not read it
    PieceResults flatten(const Garment& garment, const FlattenOptions& options, Progress& progress,
                         int threads = 0, const PieceResults& known = {},
                         const LineSettings& lines = {}, const OnPiece& onPiece = {},
                         const PieceCloths& cloths = {});
    /// Solves warm results from scratch with the same options, and draws them with the same lines,
    /// to the same bytes as `flattenGarment`. After a cancel the rest stays unchanged.
    PieceResults settle(const Garment& garment, PieceResults results, Progress& progress,
                        int threads = 0, const LineSettings& lines = {});

    /// The symmetry that mirrors the lines; null if `lines` does not mirror, if the garment has no
    /// symmetry, or after a cancel.
    std::shared_ptr<const Symmetry> symmetryOf(const Garment& garment, const LineSettings& lines,
                                               const Progress& progress = {});

    /// Forgets everything that is kept.
    void reset();

    /// Approximate size of the kept state, meshes and results aside.
    std::size_t keptBytes() const;

private:
    struct Kept {
        std::shared_ptr<const PieceResult> result;
        PieceFlattener flattener;
    };

    using KeptPointer = std::shared_ptr<const Kept>;

    /// The symmetry of a garment, and the data it depends on; the plane depends on `uncut` alone.
    struct KeptSymmetry {
        Pieces uncut;
        std::optional<MirrorPlane> plane;
        Pieces pieces;
        std::vector<double> places;            ///< of the seams' sides
        std::optional<Symmetry> found, close;  ///< `close`: by `withinTolerance`
    };

    std::vector<KeptPointer> snapshot() const;
    PieceResults flattenExactly(const Garment& garment, const FlattenOptions& options,
                                Progress& progress, int threads, const PieceResults& known,
                                const std::vector<OutlineTargets>& targets,
                                const PieceCloths& cloths, const OnPiece& onPiece);
    PieceResults settleExactly(PieceResults results, Progress& progress, int threads);

    const std::size_t mostBytes_;
    mutable std::mutex mutex_;
    std::vector<KeptPointer> kept_;  ///< in the order of the last garment
    std::shared_ptr<const KeptSymmetry> symmetry_;
    EndingWorkers ending_;
};

}  // namespace toile

// Internal header of this folder.
namespace toile {

/// Replaces pieces by equal ones of an earlier garment, so that data known about them (parts, flat
/// points) stays valid. Cost: linear in the meshes.
void reusePieces(Pieces& pieces, const Garment& before);

}  // namespace toile
