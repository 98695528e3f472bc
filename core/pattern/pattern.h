// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/id.h"
#include "core/cut/surface_point.h"
#include "core/garment/fabric.h"
#include "core/garment/seam.h"
#include "core/mesh/mesh_arrays.h"
#include "core/pattern/line_settings.h"

namespace toile {

struct Garment;
struct FlatPiece;
struct Piece;
struct PieceResult;
struct Symmetry;
using PieceResults = std::vector<std::shared_ptr<const PieceResult>>;

/// Where the warp runs where it is unset: up the piece's own y axis, radians.
inline constexpr double kGrainUpwards = 1.5707963267948966;

/// How a piece is to be cut, as a person has said it.
struct Cutting {
    /// Direction of the warp, radians anti-clockwise from the x axis of the piece's own
    /// coordinates; none where it is unset (kGrainUpwards).
    std::optional<double> grain{};
    int quantity = 1;           ///< how many are cut
    bool mirroredPair = false;  ///< each of them also mirrored: left and right
    /// Only one half is drawn of what is a mirror image: of a piece that is symmetric in itself the
    /// one beside the fold of the cloth, of two that mirror each other one, cut as a pair.
    bool byHalf = false;
    std::string material{};  ///< what it is cut from (Material); empty: the garment's own fabric

    bool operator==(const Cutting&) const = default;
};

inline double grainOf(const Cutting& cutting) {
    return cutting.grain.value_or(kGrainUpwards);
}

/// One side of a seam, or a free edge, along a piece's outline or the rim of a hole in it.
struct SeamLine {
    int number = 0;    ///< of the seam in the garment, from 1: the same on both sides
    std::string name;  ///< "front / sleeve left"
    Points2 line;      ///< #n x 2, along the outline, from end to end
    bool closed = false;
    SeamKind kind = SeamKind::Seam;
    bool isRight = false;  ///< of the two sides of the seam
    SeamId seam{};
    /// Where it lies on `PatternPiece::outline`, as a segment does; 0 and 0 on the rim of a hole.
    double from = 0, to = 0;
    /// Its start, its end is none: on a half pattern it goes on beyond the fold.
    std::array<bool, 2> isAtFold{};
    double length3d = 0;  ///< of this side in the garment, mm
};

/// A stretch of a piece's seam line from one turn point to the next (segments.h).
struct PatternSegment {
    /// Arc lengths along `PatternPiece::outline` in the plane, mm: `from` within the first turn,
    /// `to` counted on past the outline's first point.
    double from = 0, to = 0;
    bool isCorner = false;  ///< the line has a corner where the segment starts; else it runs on
    int seam = 0;           ///< SeamLine::number; 0: part of none
    bool isRight = false;   ///< of that seam's sides
    SeamKind kind = SeamKind::Free;
    LineStretch place{};   ///< by which settings know it
    double length = 0;     ///< that it is to have, mm: where lengths are kept, to - from
    bool isFaced = false;  ///< a facing is sewn to it (`facingsOf`)
    bool isFold = false;   ///< of a half pattern: the edge that lies on the fold, no seam line
    double allowance = 0;  ///< width beside it, mm
    double extension = 0;  ///< by which it is drawn out where it is a free edge, mm
    /// Of the allowances where it begins; none: mitred, or mirrored at the end of a hem.
    std::optional<CornerRule> corner{};
};

/// A notch on a piece's seam line, or on the rim of a hole (findNotches).
struct PieceNotch {
    int seam = 0;      ///< SeamLine::number
    double share = 0;  ///< of that seam's length, from its start
    int hole = -1;     ///< whose rim it is on; -1: on the outline
    double at = 0;     ///< length along that line in the plane from its first point, mm
    int count = 1;     ///< 2: a double one
    NotchReason reason = NotchReason::Balance;
};

/// What of an internal line lies on a piece, or a drill point (findInternalRuns).
struct PieceInternal {
    int line = -1;  ///< index into LineSettings::internalLines
    std::string name{};
    /// In flat coordinates, one of a drill point, the first not repeated; empty: not flat.
    Points2 points = Points2(0, 2);
    bool closed = false;
    double length = 0;  ///< along them, mm
    /// On the mesh of the piece, with all that lies between; a closed one repeats its first point.
    std::vector<SurfacePoint> way{};
};

/// What a piece mirrors in the pattern, as outlines are drawn (`Mirror`).
struct DrawnMirror {
    /// It is its own image: row k of the outline mirrors row #n - k, modulo #n, and the mirror line
    /// goes straight from row 0 to row #n / 2 through the cloth.
    bool isSymmetric = false;
    int counterpart = -1;  ///< the other piece that is its image; -1: none
    bool leads = false;    ///< of the two

    bool operator==(const DrawnMirror&) const = default;
};

/// How a piece comes out of the cloth.
enum class CutAs {
    Whole,   ///< as it is drawn
    OnFold,  ///< one half is drawn, and cut on the fold of the cloth
    Pair,    ///< it stands for its image too, and is cut with it through two layers
    Image,   ///< it is cut with its counterpart, and not drawn itself
};

/// One flat piece as a pattern maker knows it, in its own coordinates wherever copies of it lie:
/// millimetres, y up, the fabric's right side facing the reader.
struct PatternPiece : Cutting {
    std::string name;  ///< as it is called
    std::string slug;  ///< unique in the pattern, stable for the same garment
    Points2 outline;   ///< seam line, anti-clockwise, first vertex not repeated; empty: not flat
    std::vector<Points2> holes{};  ///< closed lines inside it, clockwise
    /// By number. They cover outline and rims, but for what is too short to be a free edge and
    /// for rims that nothing is sewn to.
    std::vector<SeamLine> seams{};
    PieceId id{};
    /// The outline in order; the first is the one that starts first.
    std::vector<PatternSegment> segments{};
    bool isFine = false;   ///< a fair line, which stands for a curve; else the polygon itself
    DrawnMirror mirror{};  ///< of the whole piece
    CutAs cutAs = CutAs::Whole;
    /// Round the outline, its extensions and their allowances, anti-clockwise; empty where there is
    /// none of these: the piece is cut along its outline then. Holes have none.
    Points2 cuttingLine = Points2(0, 2);
    std::vector<Points2> extensions{};       ///< edges drawn out (`extensionEdges`), inside that
    std::vector<PieceNotch> notches{};       ///< by `hole`, then `at`
    std::vector<PieceInternal> internals{};  ///< by `line`
    std::map<SeamId, DartSettings> saidOfDarts{};  ///< what a person has said of its darts
    int number = 0;  ///< from 1, of those that are drawn, in the garment's order; 0: not drawn
};

/// The line that a piece is cut along.
inline const Points2& edgeOf(const PatternPiece& piece) {
    return piece.cuttingLine.rows() > 0 ? piece.cuttingLine : piece.outline;
}

/// A facing, in the coordinates of the piece that it is a copy of.
struct FacingPiece {
    int piece = -1;   ///< index into Pattern::pieces
    int facing = -1;  ///< index into LineSettings::facings
    PatternPiece strip{};
};

struct Pattern {
    std::string name;                  ///< of the garment
    std::vector<PatternPiece> pieces;  ///< one per piece of the garment, in its order
    /// Strips of pieces that are cut a second time (`facingsOf`), by piece.
    std::vector<FacingPiece> facings{};
    bool hasAllowance = false, hasNotches = false;
    NotchForm notchForm = NotchForm::Slit;
    double notchDepth = 5;  ///< from the cutting line inwards, mm
    LabelTexts label{};
    MaterialList materials{};  ///< that its pieces may be of
    /// In which pieces are drawn as images of each other; null: in none.
    std::shared_ptr<const Symmetry> symmetry{};
};

/// What each piece is cut from. @param own  the garment's fabric
std::vector<Fabric> fabricsOf(const Pattern& pattern, const Fabric& own);

/// Everything of a garment that is flat, in its own coordinates. Pieces whose names give the same
/// slug get "-2", "-3" in order.
/// @param results  one per piece; null where there is none
/// @param lines     by which they were drawn, and what is added to them
/// @param symmetry  by which they were mirrored; null: by none
/// Cost: that of `findSegments`, `findNotches`, `findInternalRuns` and `cuttingLine`. Pure.
Pattern makePattern(const Garment& garment, const PieceResults& results,
                    const LineSettings& lines = {}, std::shared_ptr<const Symmetry> symmetry = {});

/// The outline as it is drawn, then the rims of the holes; closed, first point not repeated.
std::vector<Points2> flatLoops(const Piece& piece, const FlatPiece& flat);

}  // namespace toile
