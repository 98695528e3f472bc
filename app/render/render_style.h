// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>
#include <vector>

#include "app/render/colour_map.h"
#include "core/garment/seam.h"

class QPalette;

namespace toile::app {

/// Colours of a view that go with the desktop's light or dark palette.
struct RenderStyle {
    QColor top, bottom;   ///< backdrop
    bool onDark = false;  ///< what lies on the backdrop is read the better the lighter it is
    QColor grid;
    QColor outline;  ///< of pieces
    QColor wire;
    QColor selection;        ///< magenta: in no piece and on no colour bar
    QColor seam, seamHalo;   ///< the selected seam: yellow on near black reads on any cloth
    QColor freeEdge;         ///< edges that are sewn to nothing
    QColor reference;        ///< the reference panels
    QColor exactOutline;     ///< the outline as it was solved, where another is drawn
    QColor cuttingLine;      ///< notches and internal lines
    QColor text, faintText;  ///< captions over the backdrop
    QColor labelFill;        ///< behind names on the cloth
};

/// True where the palette's windows are dark (Qt 6.4 does not tell).
bool isDark(const QPalette& palette);
RenderStyle renderStyle(const QPalette& palette);
/// Colours that a person has chosen for what is selected, in all styles from now on; invalid: those
/// that go with the palette. GUI thread only.
void setMarkColours(const QColor& selection, const QColor& seam);

/// Colours of seam lines: stronger than any cloth's, told apart from each other, and neither the
/// yellow nor the magenta of what is selected.
inline constexpr int kSeamColours = 10;
/// @param onDark  the lighter ones, for a dark ground; the same hues in the same order
const std::array<Rgb, kSeamColours>& seamPalette(bool onDark = false);

/// Per seam an index into the palette, -1 for free edges. Both sides of a seam have its colour, and
/// no other seam on either of their pieces, so that one finds what an edge is sewn to; where a
/// piece has more seams than there are colours, at least no other between the same two pieces while
/// that goes. Of what is left the colours least in use, and among those the one that the seam's
/// name chooses. Cost: linear in the seams. Pure.
std::vector<int> seamColours(const SeamGraph& seams);

}  // namespace toile::app
