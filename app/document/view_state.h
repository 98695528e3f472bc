// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iterator>
#include <numbers>
#include <optional>

#include "core/base/wording.h"

namespace toile::app {

/// What is painted on the cloth, in both views alike. The shaders know them by number: see
/// resources/shaders/surface.glsl.
enum class Overlay {
    None,        ///< the piece's colour alone
    Checker,     ///< true-scale squares
    Area,        ///< A3D / A2D - 1
    Angle,       ///< largest change of a corner angle
    Strain,      ///< L3D / L2D - 1 of the edges: what the cloth must do
    Warp,        ///< strain along the grain
    Weft,        ///< strain across it
    Bias,        ///< strain at 45 degrees to it, the worse of both diagonals
    Principal,   ///< largest and least strain and their directions, as glyphs
    Dirichlet,   ///< symmetric Dirichlet energy, above that of cloth that keeps its shape
    Normal,      ///< where the worn cloth faces, as a colour ([Wan05], figures)
    Gap,         ///< how far outside of the design the pattern lies, sewn back together, mm
    WornStrain,  ///< strain of the cloth that is sewn so, the larger of both principal ones
};

inline constexpr int kOverlayCount = 13;

/// What the overlays are called on the command line and in project files. Once released they stay.
inline constexpr Word<Overlay> kOverlayWords[] = {
    {Overlay::None, "none"},
    {Overlay::Checker, "checker"},
    {Overlay::Area, "area"},
    {Overlay::Angle, "angle"},
    {Overlay::Strain, "strain"},
    {Overlay::Warp, "warp"},
    {Overlay::Weft, "weft"},
    {Overlay::Bias, "bias"},
    {Overlay::Principal, "principal"},
    {Overlay::Dirichlet, "dirichlet"},
    {Overlay::Normal, "normal"},
    {Overlay::Gap, "gap"},
    {Overlay::WornStrain, "worn-strain"},
};
static_assert(std::size(kOverlayWords) == kOverlayCount, "each overlay needs a word");

/// True where the overlay shows a number and so needs a colour bar.
constexpr bool isMeasured(Overlay overlay) {
    return overlay != Overlay::None && overlay != Overlay::Checker && overlay != Overlay::Normal;
}

/// True where the number is of the pattern sewn back together: there is none before it is proved.
constexpr bool isOfProof(Overlay overlay) {
    return overlay == Overlay::Gap || overlay == Overlay::WornStrain;
}

/// True where the number depends on how the grain runs.
constexpr bool followsGrain(Overlay overlay) {
    return overlay == Overlay::Warp || overlay == Overlay::Weft || overlay == Overlay::Bias;
}

/// True where the number is of either sign, with 0 in the middle of the colours.
constexpr bool isSigned(Overlay overlay) {
    return overlay != Overlay::Angle && overlay != Overlay::Dirichlet;
}

/// The lists below the views, from left to right, and the panels beside them.
enum class Panel {
    Pieces,
    Seams,
    ProblemList,
    History,
    Lines,
    Symmetry,
    Proof,
    Properties,
    Fabric
};

/// Of the two views: in pictures of them.
enum class ViewsShown { Garment, Pattern, Both };

/// From where the garment is looked at, radians: yaw around the upright axis from the front, to the
/// garment's right side as it is seen (+x), pitch upwards.
struct ViewDirection {
    double yaw = 0, pitch = 0;

    bool operator==(const ViewDirection&) const = default;
};

/// Along the axes.
inline constexpr ViewDirection kFrontView{0, 0};
inline constexpr ViewDirection kBackView{std::numbers::pi, 0};
inline constexpr ViewDirection kRightView{std::numbers::pi / 2, 0};
inline constexpr ViewDirection kLeftView{-std::numbers::pi / 2, 0};
inline constexpr ViewDirection kTopView{0, std::numbers::pi / 2};
inline constexpr ViewDirection kBottomView{0, -std::numbers::pi / 2};

/// How the garment is shown; not part of what is saved with a garment.
struct ViewState {
    Overlay overlay = Overlay::Checker;
    bool wireframe = false;
    bool referencePanels = false;    ///< the reference panels over the pattern
    bool exactOutline = false;       ///< the outline as it was solved, where another is drawn
    bool valuesPerTriangle = false;  ///< a measured overlay is not smoothed over the vertices
    bool worstSpots = true;          ///< the worst places of a measured overlay carry a number
    bool seams = true;               ///< seam lines, each pair in its colour
    bool cuttingLine = true;         ///< round the allowances, in the pattern
    bool notches = true;             ///< in the pattern
    bool internalLines = true;       ///< in the pattern with the marks of darts
    bool grain = true;               ///< arrows of the grain, in the pattern
    bool labels = true;              ///< names of the pieces, in the pattern
    bool xray = false;               ///< the garment's cloth lets what is behind it be seen
    bool shaded = true;              ///< light falls on the garment
    bool pieceColours = true;        ///< else all cloth is of one plain colour
    bool rulers = true;              ///< along the edges of the pattern view
    bool grid = true;                ///< on the sheet
    bool snapping = true;            ///< whether pieces catch at the grid and at each other
    /// See mirrored_edits.h; none: as long as the mesh is symmetric.
    std::optional<bool> mirrorsEdits{};

    bool operator==(const ViewState&) const = default;
};

/// How a garment that is opened after another one is shown: as the first one was, but for the aids
/// of the sheet, which are the user's.
inline ViewState viewOfNext(const ViewState& before) {
    ViewState view;
    view.rulers = before.rulers;
    view.grid = before.grid;
    view.snapping = before.snapping;
    return view;
}

/// Something of the garment that a pointer can be on and that can be highlighted in both views.
struct Feature {
    enum class Kind {
        Piece,   ///< `piece`
        Seam,    ///< `seam`, or a free edge: both sides
        Run,     ///< of the outline of `piece`: `count` edges from edge `first`
        Vertex,  ///< `vertex` of `piece`, a corner of `face`
    };

    Kind kind = Kind::Piece;
    int piece = -1;
    int seam = -1;    ///< index into Garment::seams
    int first = -1;   ///< an edge of the outline: from Piece::boundary[first] to the next
    int count = 0;    ///< counts on past the outline's beginning
    int vertex = -1;  ///< of the piece's mesh
    int face = -1;    ///< one of the triangles around the vertex

    bool operator==(const Feature&) const = default;
};

}  // namespace toile::app
