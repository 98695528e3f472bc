// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/flatten/base/piece_result.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/export_options.h"
#include "core/formats/export_source.h"
#include "core/formats/tables/pattern_match.h"
#include "core/garment/garment.h"
#include "core/layout/marker.h"
#include "core/marker/cloth_marker.h"
#include "core/mesh/mesh_arrays.h"
#include "core/symmetry/symmetry.h"

namespace toile {

struct ReadBack;

/// Each writer returns the whole file as bytes; the same input gives the same bytes. Numbers do not
/// depend on the user's locale.

/// Decimals of a millimetre in drawings.
inline constexpr int kDrawingDecimals = 4;

/// SVG at true scale: page, viewBox and every number in one unit (millimetres; points for programs
/// that require them), one layer per kind or one group per piece with such layers in it, closed
/// paths ending in Z, ids kept; no transforms except for the names along seams. 4 decimals. Paths
/// name their piece (data-piece). The layer "seams" has the sides of the seams, invisible, with
/// data-seam, data-pair and data-length-3d (mm), except for machines, which would follow them.
/// Letters as outlines keep their text as data-text. Cost: linear in the points.
std::string writeSvg(const Drawing& drawing, const SvgOptions& options = {});

/// DXF R12 ASCII, profile "plain": LTYPE and LAYER tables, no blocks, POLYLINEs, closed except for
/// ticks and grain lines, on named coloured layers (CUT, MARKS, TEXT, CHECK, and SEW, NOTCHES,
/// INTERNAL and GRAIN if they have content), y up, CRLF. In `unit`, as stated in $INSUNITS; 4
/// decimals of a millimetre. Texts become ASCII.
std::string writePlainDxf(const Drawing& drawing, LengthUnit unit = LengthUnit::Millimetre);

/// The input as OBJ with the pattern as its UV map: `v` lines with the file's own digits, faces in
/// file order, polygons kept, one `vt` per (piece, vertex) in mm (shortest digits that read back
/// exactly), faces of failed pieces without `vt`, `g` naming the piece. With several files, their
/// vertices follow each other. Comments at the head list the differences from the input.
/// @param results     one per piece of the garment, in its order
/// @param marker      places of the flat points; triangles of mirrored ones are clockwise in the UV
/// map, as stated in a comment
/// Cost: linear; about a third of a second per million triangles.
std::string writeObj(const Garment& garment, const PieceResults& results, const Marker& marker);
/// Additions to the outlines of a pattern, for the end of such a file: one object for each of the
/// layers of the cutting lines, seam lines, notches and internal lines, of `v` and `l` lines in the
/// plane z = 0, as the UV map.
/// @param drawing  of the same marker  @param unit  of the file, mm  Cost: linear.
std::string writeObjLines(const Drawing& drawing, double unit);
/// The JSON report of docs/report.md. Never NaN or Infinity: null.
/// @param pattern   as cut (`asCut`): how each piece is cut, and how often; without pieces: once
/// @param own       the garment's fabric
std::string writeReport(const Garment& garment, const PieceResults& results,
                        const Pattern& pattern = {}, const Fabric& own = fabricPresets().front());

/// Compares a report with its source lengths: of each outline and each side of a seam.
/// Errors: NotReadBack. Cost: linear. Pure.
Result<ReadBack> readBackReport(const std::string& bytes, const Garment& garment,
                                const PieceResults& results);

/// A garment before flattening: files, pieces, cuts, seams and problems, as JSON.
std::string writeInfo(const Garment& garment);

struct ReportPicture {
    std::string caption;
    std::string png;  ///< in base 64
};

/// Provides pictures of the garment for reports, which the core cannot draw. Not thread-safe: call
/// it once, before any export.
void provideReportPictures(std::vector<ReportPicture> (*make)(const ExportSource&));

/// The whole pattern as a self-contained page for a browser: number of pieces and seams, their
/// fit, the drawing, pictures of the garment if available, and the tables of report_tables.h. The
/// same input gives the same bytes; only pictures may differ between machines.
/// Cost: that of the drawing, of `walkGarment` and of the pictures.
std::string writeHtmlReport(const ExportSource& source);

/// A marker and its input.
struct MadeMarker {
    std::shared_ptr<const Pattern> pattern;  ///< not null
    MarkerSettings settings;
    ClothMarker marker;
};

/// Markers of a garment, one per material, as JSON: `use`, `length` and `rounds` of all together,
/// then the figures of each, with the place of every copy (docs/marker.md).
/// @param minutesPerMetre  of seam, if the user has set it
/// Cost: linear. Pure. Precondition: there is at least one marker.
std::string writeMarkers(const std::vector<MadeMarker>& markers,
                         std::optional<double> minutesPerMetre);

/// A comparison of a pattern with one from a file, as JSON: each pair with the compared lines,
/// their distance and the differences of length and area, and the pieces without a partner.
/// Cost: linear. Pure.
std::string writePatternMatch(const Pattern& pattern, const PatternFile& file,
                              const PatternMatch& match);

/// Each pair as a picture, side by side at true scale: the pattern's line on the cutting layer, the
/// file's line over it on the seam layer, and the name with the figures. Element ids are
/// `piece-<slug>-ours` and `-theirs`, with `-2` for a second line.
Drawing drawPatternMatch(const Pattern& pattern, const PatternFile& file,
                         const PatternMatch& match);

inline constexpr double kPlotterUnits = 40;  // per mm

/// A line in the whole units of a plotter. Rounding each of many points would make a zigzag that is
/// longer than the line. This keeps only as many points as needed, rounded so that the line is off
/// by at most 0.019 mm if its points are two units apart or more, and the length up to each point
/// is right within a few hundredths of a millimetre.
/// @param line  mm, one point or more  @return  #n x 2, whole numbers; a closed line repeats its
/// first point. Cost: linear in the points, times those passed by a step. Pure.
Points2 plotterLine(const Points2& line, bool closed);

/// HPGL in whole units, 40 per millimetre, y up, nothing negative: IN, PA, then for each pen PU and
/// lists of PD with at most 64 points. Pen 3 draws the outlines of letters, pen 2 all lines that
/// are not cut, pen 1 the cut lines: a piece's holes before its outline, which holds the cloth.
/// Closed lines end where they began. Lines are those of `plotterLine`. The turned drawing is
/// rotated a quarter anti-clockwise. Cost: linear in the points. Pure.
std::string writePlt(const Drawing& drawing, const PltOptions& options = {});

}  // namespace toile
