// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>

#include "app/document/overlay.h"

namespace toile::app {

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

/// Which views a picture shows.
enum class ViewsShown { Garment, Pattern, Both };

/// Direction from which the garment is seen, radians: yaw around the upright axis from the front to
/// its right side (+x), pitch upwards.
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

/// How the garment is shown; no part of the state.
struct ViewState {
    Overlay overlay = Overlay::Checker;
    bool wireframe = false;
    bool referencePanels = false;    ///< the reference panels over the pattern
    bool exactOutline = false;       ///< the solved outline, if another is drawn
    bool valuesPerTriangle = false;  ///< a measured overlay is not smoothed over the vertices
    bool worstSpots = true;          ///< the worst places of a measured overlay carry a number
    bool seams = true;               ///< seam lines, each pair in its colour
    bool cuttingLine = true;         ///< round the allowances, in the pattern
    bool notches = true;             ///< in the pattern
    bool internalLines = true;       ///< in the pattern with the marks of darts
    bool grain = true;               ///< arrows of the grain, in the pattern
    bool labels = true;              ///< names of the pieces, in the pattern
    bool xray = false;               ///< the garment's cloth is translucent
    bool shaded = true;              ///< the garment is lit
    bool pieceColours = true;        ///< else all cloth has one colour
    bool rulers = true;              ///< along the edges of the pattern view
    bool grid = true;                ///< on the sheet
    bool snapping = true;            ///< pieces snap to the grid and to each other
    /// See mirrored_edits.h; none: if the mesh is symmetric.
    std::optional<bool> mirrorsEdits{};

    bool operator==(const ViewState&) const = default;
};

/// The view of a garment that is opened after another one: the default, with the rulers, grid and
/// snapping that the user has chosen.
inline ViewState viewOfNext(const ViewState& before) {
    ViewState view;
    view.rulers = before.rulers;
    view.grid = before.grid;
    view.snapping = before.snapping;
    return view;
}

/// A part of the garment that can be under the pointer and highlighted in both views.
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
    int count = 0;    ///< may count past the end of the outline
    int vertex = -1;  ///< of the piece's mesh
    int face = -1;    ///< one of the triangles around the vertex

    bool operator==(const Feature&) const = default;
};

}  // namespace toile::app
