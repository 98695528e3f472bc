// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile {

/// What is painted on the cloth, in both views alike.
enum class Overlay {
    None,     ///< the piece's colour alone
    Checker,  ///< true-scale 1 cm squares
    Area,     ///< A2D / A3D - 1
    Angle,    ///< largest change of a corner angle
    Strain,   ///< L3D / L2D - 1: what the cloth must do
};

inline constexpr int kOverlayCount = 5;

/// True where the overlay shows a number and so needs a colour bar.
constexpr bool isMeasured(Overlay overlay) {
    return overlay == Overlay::Area || overlay == Overlay::Angle || overlay == Overlay::Strain;
}

/// The lists below the views.
enum class Panel { Pieces, Seams, Messages };

/// How the garment is shown; not part of what is saved with a garment.
struct ViewState {
    Overlay overlay = Overlay::Checker;
    bool wireframe = false;
    bool designerOutline = false;  ///< the designer's own panels over the pattern

    bool operator==(const ViewState&) const = default;
};

}  // namespace toile
