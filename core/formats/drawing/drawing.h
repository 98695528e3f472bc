// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/wording.h"
#include "core/layout/marker.h"
#include "core/mesh/mesh_arrays.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/piece_marks.h"

namespace toile {

struct DrawnPath {
    std::string id;  ///< unique in the drawing
    LayerKind layer;
    Points2 points;  ///< mm, y up; if closed, the first point is not repeated
    bool closed = true;
    bool isDrill = false;  ///< of the symbol of a drill point: a circle, or a stroke of a cross
};

struct DrawnText {
    std::string id;
    LayerKind layer;
    Eigen::Vector2d position;  ///< middle of the first line, mm, y up; lines are centred on it
    double height;             ///< of a capital letter, mm
    std::vector<std::string> lines;
    double angle = 0;  ///< of the lines, anti-clockwise about the position, radians
};

/// One side of a seam, or a free edge, on a line of the drawing.
struct DrawnEdge {
    std::string id;    ///< unique in the drawing
    std::string pair;  ///< the edge it is sewn to; empty: free, or not drawn
    std::string seam;  ///< its name
    int number = 0;    ///< of the seam in the garment
    int path = -1;     ///< index into Drawing::paths, the line that contains it
    /// Arc lengths along that line: `from` in the first round, `to` not wrapped.
    double from = 0, to = 0;
    Points2 points;       ///< #n x 2, that part of it
    double length3d = 0;  ///< in the garment, mm
};

/// A copy of a piece in the drawing. Its paths, texts and edges are contiguous.
struct DrawnBlock {
    std::string id;                            ///< "piece-<slug>"
    int piece = -1;                            ///< index into Pattern::pieces
    Placement placement{};                     ///< on the page
    std::size_t path = 0, text = 0, edge = 0;  ///< index of the first one
    std::size_t pathCount = 0, textCount = 0, edgeCount = 0;
};

/// The drawing of a pattern that every writer converts to its format: true scale, millimetres, y
/// up, in [0, width] x [0, height].
struct Drawing {
    std::string title;
    double width = 0, height = 0;
    std::vector<DrawnPath> paths;
    std::vector<DrawnText> texts;
    std::vector<DrawnEdge> edges{};
    std::vector<DrawnBlock> blocks{};  ///< the pieces; all else belongs to the page
    DrawingWords words{};              ///< in the drawing's language, for the sheets
};

/// A pattern and its drawing, for printing.
struct DrawnPattern {
    Pattern pattern;
    Drawing drawing;
};

/// Names of a layer in files of three kinds.
struct LayerNames {
    const char* svg;
    const char* dxf;
    const char* pdf;  ///< in a reader's list of layers
};

/// In the order of the kinds.
inline constexpr std::array<LayerNames, kLayerKinds.size()> kLayerNames{
    {{"cut", "CUT", "cut"},
     {"sew", "SEW", "seam line"},
     {"notches", "NOTCHES", "notches"},
     {"internal", "INTERNAL", "internal lines"},
     {"marks", "MARKS", "marks"},
     {"grain", "GRAIN", "grain"},
     {"text", "TEXT", "labels"},
     {"check", "CHECK", "check"}}};

constexpr const LayerNames& namesOf(LayerKind kind) {
    return kLayerNames[static_cast<std::size_t>(kind)];
}

/// The layer of that name in one kind of file, or nothing.
std::optional<LayerKind> layerNamed(std::string_view name, const char* LayerNames::*file);

/// Margin around the whole drawing, mm.
inline constexpr double kDrawingMargin = 10;

/// Whether the drawing has the layer: see kLayerKinds.
bool hasLayer(const Drawing& drawing, LayerKind kind);

/// Draws every copy of a piece: its cutting line (for a half pattern including the fold edge,
/// marked by `foldMark`), its seam line if it differs, its holes, notches, extensions, internal
/// lines and drill points, the marks of its darts if it has allowances, its label (`labelLines`),
/// its grain line if the grain is stated (`placeMarks`), and the ticks, numbers and names of its
/// seams. Adds a 100 mm check square to the right of the pieces, and a margin of 10 mm around
/// everything; labels of pieces narrower than their names stay on the page. Width and height are
/// whole millimetres. Each piece is a block, with the sides of its seams as edges. Ids:
/// `piece-<slug>-cut`, `piece-<slug>--sew`, `piece-<slug>--notch-<k>` (further strokes of it `-2`
/// and so on), `piece-<slug>--extension-<k>`, `piece-<slug>--dart-<k>-fold`, `-drill`, `-tip-1` and
/// `-tip-2`, `piece-<slug>--line-<k>`, `piece-<slug>--point-<k>` (its cross `-2` and `-3`),
/// `piece-<slug>--hole-<k>`, `piece-<slug>-name`, `piece-<slug>--grain`,
/// `piece-<slug>--seam-<number>-tick-<k>`, `...-number` and `...-name` ("b" after the number of a
/// seam's second side on the same piece), `piece-<slug>--fold`, `piece-<slug>--fold-text`,
/// `check-square`, `check-square-text`; of edges `piece-<slug>--edge-<number>` ("b" likewise, "-2"
/// and so on if a half pattern has several parts of it). Further copies of a piece have a slug with
/// "-copy-2" and so on.
/// @param pattern  as cut (`asCut`)
/// Cost: that of placeMarks per piece. Pure.
Drawing draw(const Pattern& pattern, const Marker& marker, const DrawingWords& words = {});

/// Notes to read before using a drawing. Empty if there is nothing to report.

/// Lists pieces whose cut lines overlap on the page, with a remedy, in one note.
/// Cost: as `overlappingOutlines`. Pure.
std::vector<Wording> overlapNotes(const Pattern& pattern, const Drawing& drawing);
/// Lists pieces drawn without a grain line because their grain is not stated, in one note. Pure.
std::vector<Wording> grainNotes(const Pattern& pattern, const Drawing& drawing);

}  // namespace toile
