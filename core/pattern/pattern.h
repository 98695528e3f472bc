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
#include "core/pattern/segments.h"

namespace toile {

struct Garment;
struct FlatPiece;
struct Piece;
struct PieceResult;
struct Symmetry;
using PieceResults = std::vector<std::shared_ptr<const PieceResult>>;

/// Warp direction if it is unset: the piece's own y axis, radians.
inline constexpr double kGrainUpwards = 1.5707963267948966;

/// Settings for cutting a piece.
struct Cutting {
    /// Direction of the warp, radians anti-clockwise from the x axis of the piece's own
    /// coordinates; empty: unset (kGrainUpwards).
    std::optional<double> grain{};
    int quantity = 1;           ///< number of copies
    bool mirroredPair = false;  ///< each copy also mirrored: left and right
    /// Draw only half of a mirror image: for a piece that is symmetric in itself the half beside
    /// the fold of the cloth, for two that mirror each other one of them, cut as a pair.
    bool byHalf = false;
    std::string material{};  ///< its Material; empty: the garment's own fabric

    bool operator==(const Cutting&) const = default;
};

inline double grainOf(const Cutting& cutting) {
    return cutting.grain.value_or(kGrainUpwards);
}

/// One side of a seam, or a free edge, along a piece's outline or the rim of a hole in it.
struct SeamLine {
    int number = 0;    ///< of the seam in the garment, starting at 1: the same on both sides
    std::string name;  ///< "front / sleeve left"
    Points2 line;      ///< #n x 2, along the outline, from end to end
    bool closed = false;
    SeamKind kind = SeamKind::Seam;
    bool isRight = false;  ///< of the two sides of the seam
    SeamId seam{};
    /// Its place on `PatternPiece::outline`, as for a segment; 0 and 0 on the rim of a hole.
    double from = 0, to = 0;
    /// Whether the seam continues at its start, its end beyond the fold of a half pattern.
    std::array<bool, 2> isAtFold{};
    double length3d = 0;  ///< of this side in the garment, mm
};

/// Why an allowance is narrower than usual (`limitAllowances`).
enum class AllowanceLimit {
    None,
    Width,  ///< the piece is narrow there
    Curve,  ///< turned in, the edge of a wider one would be too long or too short
    Size,   ///< the piece is too small for any
};

/// Their names in reports.
inline constexpr Word<AllowanceLimit> kAllowanceLimitWords[] = {{AllowanceLimit::None, ""},
                                                                {AllowanceLimit::Width, "width"},
                                                                {AllowanceLimit::Curve, "curve"},
                                                                {AllowanceLimit::Size, "size"}};

/// A stretch of a piece's seam line from one turn point to the next (segments.h).
struct PatternSegment {
    /// Arc lengths along `PatternPiece::outline` in the plane, mm: `from` within the first turn,
    /// `to` counted on past the outline's first point.
    double from = 0, to = 0;
    bool isCorner = false;  ///< the line has a corner where the segment starts
    int seam = 0;           ///< SeamLine::number; 0: none
    bool isRight = false;   ///< side of that seam
    SeamKind kind = SeamKind::Free;
    LineStretch place{};   ///< identifies it in settings
    double length = 0;     ///< required length, mm: to - from if lengths are kept
    bool isFaced = false;  ///< a facing is sewn to it (`facingsOf`)
    bool isFold = false;   ///< of a half pattern: the edge on the fold, not a seam line
    EdgeKind edge = EdgeKind::Unknown;       ///< of a free edge: its kind, set or found
    EdgeKind foundEdge = EdgeKind::Unknown;  ///< as found, whatever is set
    int opening = -1;             ///< of a free edge: number of the opening that it belongs to
    double allowance = 0;         ///< width of the adjacent allowance, mm
    double usualAllowance = 0;    ///< the same by its kind alone, before `limitAllowances`
    bool isAllowanceSet = false;  ///< the user has set `allowance`
    AllowanceLimit limit = AllowanceLimit::None;
    double extension = 0;  ///< width by which a free edge is extended, mm
    /// Of the allowances where it starts; empty: mitred, or mirrored at the end of a hem.
    std::optional<CornerRule> corner{};
};

/// A notch on a piece's seam line, or on the rim of a hole (findNotches).
struct PieceNotch {
    int seam = 0;      ///< SeamLine::number
    double share = 0;  ///< of that seam's length, from its start
    int hole = -1;     ///< index of the hole; -1: on the outline
    double at = 0;     ///< length in the plane along that line from its first point, mm
    int count = 1;     ///< 2: a double notch
    NotchReason reason = NotchReason::Balance;
};

/// The part of an internal line on a piece, or a drill point (findInternalRuns).
struct PieceInternal {
    int line = -1;  ///< index into LineSettings::internalLines
    std::string name{};
    /// In flat coordinates; a drill point has one, the first is not repeated; empty: not flat.
    Points2 points = Points2(0, 2);
    bool closed = false;
    double length = 0;  ///< along them, mm
    /// On the mesh of the piece, with all points between; a closed line repeats its first point.
    std::vector<SurfacePoint> way{};
};

/// A straight line between two points, mm.
struct Chord {
    Eigen::Vector2d from, to;
};

/// A dart of the pattern.
struct PieceDart {
    int seam = 0;  ///< SeamLine::number
    /// Arc lengths along `PatternPiece::outline`, from the mouth over the tip to the mouth: `from`
    /// within the first turn, `to` counted on.
    double from = 0, to = 0;
    Eigen::Vector2d tip{0, 0};
    Chord mouth{{0, 0}, {0, 0}};  ///< start of the first leg, end of the second
    double intake = 0;            ///< width of the mouth, mm
    bool isTyped = false;         ///< the user has set the intake
    /// Angle at the tip between the chords of both legs, radians; below 0 if the legs cross.
    double angle = 0;
    double leg = 0;  ///< length of the first leg along the line, mm; equals the second when sewn
    DartLay lay = DartLay::First;
    /// The line on which the cloth between the legs ends, from the mouth's first end to the second.
    /// Empty if there is no such cloth or no room: the dart stays open.
    Points2 cap{};
    /// From the tip to the point where the fold leaves the cap; both the tip if there is no cap.
    Chord fold{{0, 0}, {0, 0}};
    /// On the fold, in the dart's cloth; the tip if there is no cap.
    Eigen::Vector2d drill{0, 0};
};

/// Mirror relation of a piece in the drawn pattern (`Mirror`).
struct DrawnMirror {
    /// It is its own image: row k of the outline mirrors row #n - k, modulo #n, and the mirror line
    /// runs straight from row 0 to row #n / 2 through the cloth.
    bool isSymmetric = false;
    int counterpart = -1;  ///< the other piece that is its image; -1: none
    bool leads = false;    ///< whether it leads the other piece

    bool operator==(const DrawnMirror&) const = default;
};

/// How a piece is cut from the cloth.
enum class CutAs {
    Whole,   ///< as drawn
    OnFold,  ///< half of it is drawn, and cut on the fold of the cloth
    Pair,    ///< drawn for its image too, and cut with it through two layers
    Image,   ///< cut with its counterpart, and not drawn itself
};

/// One flat piece with its pattern marks, in its own coordinates, independent of placement:
/// millimetres, y up, the fabric's right side facing the reader.
struct PatternPiece : Cutting {
    std::string name;  ///< displayed name
    std::string slug;  ///< unique in the pattern, stable for the same garment
    Points2 outline;   ///< seam line, anti-clockwise, first vertex not repeated; empty: not flat
    std::vector<Points2> holes{};  ///< closed lines inside it, clockwise
    /// Sorted by number. They cover outline and rims, except edges too short to be free edges and
    /// rims without seams.
    std::vector<SeamLine> seams{};
    PieceId id{};
    /// Of the outline, in order; the first has the smallest start.
    std::vector<PatternSegment> segments{};
    bool isFine = false;   ///< a fair line, which represents a curve; else a polygon
    DrawnMirror mirror{};  ///< of the whole piece
    CutAs cutAs = CutAs::Whole;
    /// Around the outline, its extensions and allowances, anti-clockwise; empty without these: the
    /// outline is the cutting line then. Holes have none.
    Points2 cuttingLine = Points2(0, 2);
    std::vector<Points2> extensions{};             ///< `extensionEdges`, inside the cutting line
    std::vector<PieceNotch> notches{};             ///< sorted by `hole`, then `at`
    std::vector<PieceInternal> internals{};        ///< sorted by `line`
    std::map<SeamId, DartSettings> statedDarts{};  ///< settings of its darts
    std::vector<PieceDart> darts{};                ///< `findDarts`, if it has a cutting line
    int number = 0;  ///< from 1 in the garment's order, counting drawn pieces; 0: not drawn
};

/// The line along which a piece is cut.
inline const Points2& edgeOf(const PatternPiece& piece) {
    return piece.cuttingLine.rows() > 0 ? piece.cuttingLine : piece.outline;
}

/// A facing, in the coordinates of its piece.
struct FacingPiece {
    int piece = -1;   ///< index into Pattern::pieces
    int facing = -1;  ///< index into LineSettings::facings
    PatternPiece strip{};
};

struct Pattern {
    std::string name;                  ///< of the garment
    std::vector<PatternPiece> pieces;  ///< one per piece of the garment, in its order
    /// Facings (`facingsOf`), by piece.
    std::vector<FacingPiece> facings{};
    bool hasAllowance = false, hasNotches = false;
    NotchForm notchForm = NotchForm::Slit;
    double notchDepth = 5;  ///< from the cutting line inwards, mm
    LabelTexts label{};
    MaterialList materials{};  ///< available to its pieces
    /// Segments of the exact outlines of the garment's pieces (`findSegments`).
    std::vector<OutlineSegments> exactSegments{};
    /// Symmetry by which pieces are drawn as mirror images; null: none.
    std::shared_ptr<const Symmetry> symmetry{};
};

/// The fabric of each piece. @param own  the garment's fabric
std::vector<Fabric> fabricsOf(const Pattern& pattern, const Fabric& own);

/// All flat pieces of a garment, in their own coordinates. Pieces whose names give the same slug
/// get "-2", "-3" in order.
/// @param results  one per piece; null if there is none
/// @param lines     with which they were drawn, and additions to them
/// @param symmetry  with which they were mirrored; null: none
/// Cost: that of `findSegments`, `findNotches`, `findInternalRuns` and `cuttingLine`. Pure.
Pattern makePattern(const Garment& garment, const PieceResults& results,
                    const LineSettings& lines = {}, std::shared_ptr<const Symmetry> symmetry = {});

/// The drawn outline, then the rims of the holes; closed, first point not repeated.
std::vector<Points2> flatLoops(const Piece& piece, const FlatPiece& flat);

}  // namespace toile
