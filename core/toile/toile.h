// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/assemble/load_options.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/flatten/base/piece_result.h"
#include "core/formats/export_file.h"
#include "core/formats/export_source.h"
#include "core/garment/fabric.h"
#include "core/garment/garment.h"
#include "core/layout/marker.h"
#include "core/pattern/line_settings.h"
#include "core/project/piece_settings.h"
#include "core/symmetry/symmetry.h"

/// Toile as a library: from mesh files to pattern files in four calls.
///
///     const toile::PatternOrder order{.lines = toile::withPattern({})};
///     const auto garment = toile::read({"dress.obj"});            // Result: test it first
///     const auto flat = toile::flatten(*garment, order);
///     const auto pattern = toile::makePattern(*garment, flat, order);
///     const auto written = toile::write("dress.svg", pattern);    // Result: the files
///
/// Lengths are in mm, angles in radians; pieces have y up. All functions are re-entrant; garments
/// and results are immutable and may be shared between threads. An expected failure is an `Error`
/// that names its subject; `sentence` makes text of it.
namespace toile {

/// Decisions about a pattern, beyond those about reading the garment.
struct PatternOrder {
    FlattenOptions flattening{};
    /// Outlines, darts, notches, allowances and the rule for the grain. The default keeps the exact
    /// outlines, without any additions; `withPattern` adds what a pattern to sew needs.
    LineSettings lines{};
    Fabric fabric = fabricPresets().front();  ///< of pieces without a material of their own
    /// Materials that pieces may name; empty: each name in use, made of `fabric`.
    std::optional<MaterialList> materials{};
    /// Quantity, material, grain and place of each piece; one per piece, or empty for the usual
    /// settings and places in rows.
    std::vector<PieceSettings> pieces{};
    bool byHalf = false;  ///< draw half of each piece that is its own mirror image
    int threads = 0;      ///< pieces flattened at once; 0: one per core. Results do not differ.
};

/// The settings of each piece: those of the order, else the usual ones.
std::vector<PieceSettings> settingsOf(const PatternOrder& order, const Garment& garment);
/// The materials that pieces of such settings may be cut from.
MaterialList materialsOf(const PatternOrder& order, const std::vector<PieceSettings>& settings);

/// A pattern ready to be written: cut, laid out and named, with what it was made of.
struct FinishedPattern {
    Garment garment{};
    PieceResults results{};  ///< one per piece of the garment
    LaidOutPattern laid{};
    LineSettings lines{};  ///< with which it was made
    Fabric fabric = fabricPresets().front();

    /// Valid as long as this pattern. @param drawing  as of `ExportSource`
    ExportSource source(const ExportOptions& options = {}, DrawingWords words = {},
                        std::optional<Drawing> drawing = std::nullopt) const;
};

/// Reads one garment from one or more files. Unit, axis and division are guessed unless stated in
/// `options`; the garment stores all guesses and repairs.
/// Errors: those of the readers; NoGeometry, Cancelled.
Result<Garment> read(const std::vector<std::filesystem::path>& files,
                     const LoadOptions& options = {}, const Progress& progress = {});

/// Flattens every piece, in parallel. A piece that fails keeps its error and does not affect the
/// others. The same input gives the same bytes with any number of threads.
/// @return one result per piece, in the garment's order
PieceResults flatten(const Garment& garment, const PatternOrder& order,
                     const Progress& progress = {});

/// Makes the pattern of flat pieces: lines and additions, grain, materials and quantities, halves
/// and pairs, and the layout. Pieces without a result are left out.
/// @param results   one per piece of the garment, as of `flatten` with the same order
/// @param symmetry  if already known, as of `symmetryOf` with the same lines; null: searched for
/// Cost: linear in the outlines, and a search for the mirror plane if the lines mirror. Pure.
FinishedPattern makePattern(Garment garment, PieceResults results, const PatternOrder& order,
                            std::shared_ptr<const Symmetry> symmetry = nullptr);

/// Writes a pattern in the format of the file name's ending. Files for cutters and for other
/// pattern programs are read back and compared before they replace existing ones.
/// Errors: UnknownFormat, those of the writer, NotReadBack, FileUnwritable, Cancelled.
Result<Exported> write(const std::filesystem::path& file, const FinishedPattern& pattern,
                       const ExportOptions& options = {}, const Progress& progress = {});

}  // namespace toile
