// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/words.h"
#include "core/compare/comparison.h"
#include "core/cut/seams_file.h"
#include "core/flatten/base/piece_result.h"
#include "core/flatten/flatten.h"
#include "core/garment/garment.h"
#include "core/garment/identify.h"
#include "core/layout/marker.h"
#include "core/pattern/line_settings.h"
#include "core/prepare/preparation.h"

namespace toile {

/// The whole way from files to flat pieces as three calls, for the command line, the window's jobs
/// and tests. All functions are re-entrant; the garment and the results are immutable and may be
/// shared between threads.

/// Where automatic cuts run.
enum class CutStyle {
    Auto,      ///< as tailors cut, where a garment that is worn is recognised; else the shortest
    Tailor,    ///< the same, and gores for forms that nobody wears
    Topology,  ///< the shortest that make a piece lie flat
};

inline constexpr Word<CutStyle> kCutStyleWords[] = {
    {CutStyle::Auto, "auto"}, {CutStyle::Tailor, "tailor"}, {CutStyle::Topology, "topology"}};

struct LoadOptions {
    std::optional<FileUnit> unit{};  ///< of all files; guessed per file where not given
    std::optional<UpAxis> up{};      ///< of all files; guessed per file where not given
    SplitMode split = SplitMode::Auto;
    Preparation preparing{};  ///< what the files are, and what is done with them before
    bool weld = false;        ///< join vertices that lie on each other, within each object
    bool closeSlits = false;  ///< make both sides of slits inside pieces one (`closeSlits`)
    bool strict = false;      ///< refuse a file in which anything had to be left out or repaired
    bool autoCut = false;     ///< cut open what is no disk
    CutStyle cutStyle = CutStyle::Topology;  ///< of automatic cuts
    bool isFrontSwapped = false;  ///< where tailors' cuts guess the front, it is the back
    /// A strain at which no further cut is worth its length, part of 1: of what tailors would cut
    /// as much is cut as that needs, and darts where that is not enough. None: their usual seams.
    std::optional<double> enoughStrain{};
    /// Cuts and joins, in the unit and axes of the first file; and ease by the names of seams,
    /// which `resolveNames` turns into settings.
    SeamsFile seams{};
    std::vector<SeamSettings> seamSettings{};
    /// Pieces that the division is known to have given before: they keep their ids.
    std::vector<KnownPiece> known{};

    bool operator==(const LoadOptions&) const = default;
};

/// The order as it is kept once the garment is there: ease by names has become settings of seams,
/// cuts have ids.
LoadOptions resolveNames(LoadOptions options, const Garment& garment);

using ReadFiles = std::vector<ReadFile>;

/// All that a garment follows from.
struct GarmentInputs {
    ReadFiles files{};
    LoadOptions loading{};

    bool operator==(const GarmentInputs&) const = default;
};

/// Reads the files. Errors: those of readSoup, for the first that cannot be read.
Result<ReadFiles> readFiles(const std::vector<std::filesystem::path>& paths, Progress& progress);

/// Makes one garment of files: weld, unit, division, repair, slits, joins, cuts, seams. With
/// several files piece names are prefixed by the file's stem. A cut or a join that cannot be made,
/// or an ease for a seam that is not there, is a problem of the garment. The same inputs give the
/// same garment, whatever there was before. Errors: NoGeometry, Cancelled; with `strict` also the
/// first note about something left out or repaired.
/// @param before  a garment and its inputs: what comes out as it was there is the same pointer, and
///                where nothing but joins, cuts and ease is another it is not divided anew
Result<Garment> makeGarment(const GarmentInputs& inputs, Progress& progress,
                            const GarmentInputs& inputsBefore = {},
                            const Garment* before = nullptr);

/// The two in one. Errors: of both.
Result<Garment> loadGarment(const std::vector<std::filesystem::path>& paths,
                            const LoadOptions& options, Progress& progress);

/// The same garment joined, cut and sewn anew, for an edit of joins, cuts or ease: nothing is
/// divided, and pieces that come out as they were before are the same pointers as before.
/// Errors: Cancelled.
Result<Garment> cutGarment(const Garment& garment, const LoadOptions& options,
                           const Progress& progress);

/// The garment with other ease: its pieces stay. None where seams have other names by that too.
/// Cost: its seams. Pure.
std::optional<Garment> easedGarment(const Garment& garment,
                                    const std::vector<SeamSettings>& settings);

/// Flattens and measures every piece, in parallel over pieces, and looks for the cut that helps
/// where an outline crosses itself (nameCrossingCut); a piece that fails leaves the others alone.
/// Same input, same bytes, whatever the number of threads. Cancelled, it returns within
/// `kCancelSeconds` at any size of garment: the work is done on threads that share what they use,
/// and a stage that cannot be stopped (a factorisation) runs out on its own after that, unseen.
/// Until it has, it keeps its memory and its core; where as many such stages run as the machine has
/// cores, a new call begins when one of them has ended, or is cancelled before. Where the system
/// has no thread to give, the work is done on the caller's, without progress on the way: a cancel
/// then comes too late, and `kCancelSeconds` does not hold.
/// @param progress  grows by triangles done, within a piece by the stages and iterations of the
///                  method; reaches 1 at the end and only there. Not used after the return.
/// @param threads   how many work at once; 0: as many as the machine has cores
/// @param lines     how the outlines are drawn, and what they are to measure; as it is here, as
///                  they are in 3D. Where they are mirrored a cancel may come up to a quarter of a
///                  second later, at a million triangles, while the mirror plane is looked for
/// @return one result per piece, in the garment's order; after a cancel the unfinished ones carry
///         ErrorCode::Cancelled
/// For a garment that is being edited see garment_flattener.h.
PieceResults flattenGarment(const Garment& garment, const FlattenOptions& options,
                            Progress& progress, int threads = 0, const LineSettings& lines = {});

/// From `Progress::cancel` to the return of `flattenGarment`, at most, at a million triangles and
/// where there are threads to be had.
inline constexpr double kCancelSeconds = 0.05;

/// What pieces are mirrored in; null where they are not, or nothing mirrors anything.
/// Cost: that of `findSymmetry`. Pure.
std::shared_ptr<const Symmetry> symmetryOf(const Garment& garment, const LineSettings& lines,
                                           const Progress& progress = {});

/// The pattern of a garment in rows. @param results  one per piece; null where there is none
/// @param lines  by which they were drawn; the symmetry is looked for where they are mirrored
/// @param byHalf  `Cutting::byHalf` of all pieces
LaidOutPattern inRows(const Garment& garment, const PieceResults& results,
                      const LineSettings& lines = {}, bool byHalf = false);

/// Flattens and measures every piece by every method, one method after the other, pieces side by
/// side. A piece that fails under one method leaves the others alone.
/// @param methods  in the order wanted  @param options  `method` is not looked at
/// @return after a cancel the unfinished pieces carry ErrorCode::Cancelled
/// Cost: `flattenGarment` once per method; all flat pieces are kept. Re-entrant.
Comparison compareMethods(const Garment& garment, std::span<const Method> methods,
                          const FlattenOptions& options, Progress& progress);

}  // namespace toile
