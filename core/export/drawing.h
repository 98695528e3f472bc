// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/layout/marker.h"
#include "core/mesh/mesh_arrays.h"
#include "core/pattern/layer_kind.h"
#include "core/pattern/piece_marks.h"

namespace toile {

struct DrawnPath {
    std::string id;  ///< unique in the drawing
    LayerKind layer;
    Points2 points;  ///< mm, y up; where closed, the first point is not repeated
    bool closed = true;
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
    std::string pair;  ///< the edge that it is sewn to; empty: free, or not drawn
    std::string seam;  ///< as it is called
    int number = 0;    ///< of the seam in the garment
    int path = -1;     ///< index into Drawing::paths, the line that it is part of
    /// Arc lengths along that line: `from` within the first turn, `to` counted on.
    double from = 0, to = 0;
    Points2 points;       ///< #n x 2, that part of it
    double length3d = 0;  ///< in the garment, mm
};

/// A copy of a piece in the drawing: what is drawn of it follows each other.
struct DrawnBlock {
    std::string id;                            ///< "piece-<slug>"
    int piece = -1;                            ///< index into Pattern::pieces
    Placement placement{};                     ///< on the page
    std::size_t path = 0, text = 0, edge = 0;  ///< the first of its own
    std::size_t pathCount = 0, textCount = 0, edgeCount = 0;
};

/// The one picture of a pattern that every writer turns into its format: true scale, millimetres,
/// y up, in [0, width] x [0, height].
struct Drawing {
    std::string title;
    double width = 0, height = 0;
    std::vector<DrawnPath> paths;
    std::vector<DrawnText> texts;
    std::vector<DrawnEdge> edges{};
    std::vector<DrawnBlock> blocks{};  ///< the pieces; what is in none belongs to the page
    DrawingWords words{};              ///< of its language, for the sheets
};

/// A pattern and its drawing: what is printed.
struct DrawnPattern {
    Pattern pattern;
    Drawing drawing;
};

/// Around all of a drawing, mm.
inline constexpr double kDrawingMargin = 10;

/// True where the drawing has the layer: see kLayerKinds.
bool hasLayer(const Drawing& drawing, LayerKind kind);

/// Draws what every copy is cut along (of a half pattern with the edge that lies on the fold,
/// marked as such by `foldMark`), its seam line where that is another, its holes, its notches, its
/// extensions, internal lines and drill points, the marks of its darts where it has allowances, its
/// label (`labelLines`), its grain line where the grain is stated (`placeMarks`), the ticks,
/// numbers and names of its seams, and a 100 mm check square to the right of the pieces, with a
/// margin of 10 mm around all; labels of pieces narrower than their names stay on the page. Width
/// and height are whole millimetres. Each piece is a block, with the sides of its seams as edges.
/// Ids: `piece-<slug>-cut`, `piece-<slug>--sew`,
/// `piece-<slug>--notch-<k>` (further strokes of it
/// `-2` and so on), `piece-<slug>--extension-<k>`, `piece-<slug>--dart-<k>-fold`, `-drill`,
/// `-tip-1` and `-tip-2`, `piece-<slug>--line-<k>`, `piece-<slug>--point-<k>` (its cross `-2` and
/// `-3`), `piece-<slug>--hole-<k>`, `piece-<slug>-name`, `piece-<slug>--grain`,
/// `piece-<slug>--seam-<number>-tick-<k>`, `...-number` and `...-name` ("b" after the number of a
/// seam's second side on the same piece), `piece-<slug>--fold`, `piece-<slug>--fold-text`,
/// `check-square`, `check-square-text`; of edges `piece-<slug>--edge-<number>` ("b" likewise, "-2"
/// and so on where a half pattern has more parts of it). A piece that is laid again has a slug with
/// "-copy-2" and so on there.
/// @param pattern  as it is cut (`asCut`)
/// Cost: that of placeMarks per piece. Pure.
Drawing draw(const Pattern& pattern, const Marker& marker, const DrawingWords& words = {});

}  // namespace toile
