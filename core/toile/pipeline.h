// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/assemble/load_options.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/wording.h"
#include "core/compare/comparison.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/base/piece_result.h"
#include "core/flatten/flatten.h"
#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/symmetry/symmetry.h"
#include "core/tailor/cut_advice.h"

namespace toile {

class EndingWorkers;

/// The whole way from files to flat pieces as three calls, for the command line, the window's jobs
/// and tests. All functions are re-entrant; the garment and the results are immutable and may be
/// shared between threads.

/// The options to store once the garment exists: ease by names becomes settings of seams, and cuts
/// get ids.
LoadOptions resolveNames(LoadOptions options, const Garment& garment);

/// Reads the files. Errors: those of readSoup, for the first that cannot be read.
Result<ReadFiles> readFiles(const std::vector<std::filesystem::path>& paths, Progress& progress);

/// Makes one garment of files: weld, unit, division, repair, slits, joins, cuts, seams. With
/// several files, piece names are prefixed by the file's stem. A cut or join that cannot be made,
/// or an ease for a missing seam, is a problem of the garment. The same inputs give the same
/// garment, independent of `before`. Errors: NoGeometry, Cancelled; with `strict` also the first
/// note about something left out or repaired.
/// @param before  an earlier garment with its inputs: unchanged parts keep their pointers, and if
///                only joins, cuts or ease differ, the division is reused
Result<Garment> makeGarment(const GarmentInputs& inputs, Progress& progress,
                            const GarmentInputs& inputsBefore = {},
                            const Garment* before = nullptr);

/// Both in one call. Errors: of both.
Result<Garment> loadGarment(const std::vector<std::filesystem::path>& paths,
                            const LoadOptions& options, Progress& progress);

/// Joins, cuts and sews the same garment again after an edit of joins, cuts or ease: nothing is
/// divided, and unchanged pieces keep their pointers. Errors: Cancelled.
Result<Garment> cutGarment(const Garment& garment, const LoadOptions& options,
                           const Progress& progress);

/// The garment with other ease and the same pieces. Empty if the ease also changes names of seams.
/// Cost: its seams. Pure.
std::optional<Garment> easedGarment(const Garment& garment,
                                    const std::vector<SeamSettings>& settings);

/// Flattens and measures every piece, in parallel over pieces, and finds a helpful cut for an
/// outline that crosses itself (nameCrossingCut); a piece that fails does not affect others. Same
/// input, same bytes, with any number of threads. A stage that cannot be stopped (a factorisation)
/// runs to its end after a cancel and holds its memory and core until then: without `ending` the
/// call waits for it; with `ending` it returns within `kCancelSeconds` at any size of garment, and
/// what the stage finds is dropped. If such stages use all cores, a new call with the same `ending`
/// waits until one ends or the call is cancelled. If the system has no threads left, the work runs
/// on the caller's thread without progress, and a cancel comes too late.
/// @param progress  grows by triangles done, within a piece by the stages and iterations of the
///                  method; reaches 1 only at the end. Not used after the return.
/// @param threads   number of threads; 0: one per core
/// @param lines     how the outlines are drawn, and their lengths; default: as in 3D. If they
///                  are mirrored, a cancel may take up to a quarter of a second longer, at a
///                  million triangles, while the mirror plane is searched for
/// @param cloths    one per piece (`pieceCloths`), or empty: nothing is known
/// @param ending    takes the threads of a cancelled call that have not ended; null: waits
/// @return one result per piece, in the garment's order; after a cancel the unfinished ones carry
///         ErrorCode::Cancelled
/// For a garment that is being edited see garment_flattener.h.
PieceResults flattenGarment(const Garment& garment, const FlattenOptions& options,
                            Progress& progress, int threads = 0, const LineSettings& lines = {},
                            const PieceCloths& cloths = {}, EndingWorkers* ending = nullptr);

/// Longest time from `Progress::cancel` to the return of `flattenGarment` with `ending`, at a
/// million triangles and with free threads.
inline constexpr double kCancelSeconds = 0.05;

/// The symmetry that mirrors pieces; null if `lines` does not mirror, or if the garment has none.
/// Cost: that of `findSymmetry`. Pure.
std::shared_ptr<const Symmetry> symmetryOf(const Garment& garment, const LineSettings& lines,
                                           const Progress& progress = {});

/// Flattens and measures every piece by every method, one method after the other, pieces in
/// parallel. A piece that fails under one method does not affect others.
/// @param methods  in the order wanted  @param options  `method` is ignored
/// @return after a cancel the unfinished pieces carry ErrorCode::Cancelled
/// Cost: `flattenGarment` once per method; all flat pieces are kept. Re-entrant.
Comparison compareMethods(const Garment& garment, std::span<const Method> methods,
                          const FlattenOptions& options, Progress& progress);

/// So many of the first advised cuts are solved, to compare with the estimate.
constexpr std::size_t kSolvedAhead = 5;

/// The actual strain with the first `count` advised cuts: makes them and the piece's own cuts,
/// opens closed parts by the shortest cuts, and flattens all parts.
/// @errors  of the first part that cannot be flattened; Cancelled
/// Cost: that of flattening the piece. Re-entrant.
Result<StrainFigures> solvedStrain(const std::shared_ptr<const Piece>& piece,
                                   const std::vector<UserCut>& own, const CutAdvice& advice,
                                   std::size_t count, const FlattenOptions& options,
                                   Progress& progress);

}  // namespace toile
