// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>
#include <vector>

#include "app/render/colour_map.h"
#include "core/garment/seam.h"

class QPalette;

namespace toile::app {

/// Colours of a view for the desktop's light or dark palette.
struct RenderStyle {
    QColor top, bottom;   ///< backdrop
    bool onDark = false;  ///< lighter content is more legible
    QColor grid;
    QColor outline;  ///< of pieces
    QColor wire;
    QColor selection;        ///< magenta: used by no piece and no colour bar
    QColor seam, seamHalo;   ///< the selected seam: yellow on near black reads on any cloth
    QColor freeEdge;         ///< edges without a seam
    QColor reference;        ///< the reference panels
    QColor exactOutline;     ///< the solved outline, if another is drawn
    QColor cuttingLine;      ///< notches and internal lines
    QColor text, faintText;  ///< captions on the backdrop
    QColor labelFill;        ///< behind names on the cloth
};

/// True if the palette's windows are dark (Qt 6.4 has no query for that).
bool isDark(const QPalette& palette);
RenderStyle renderStyle(const QPalette& palette);
/// Sets the user's selection colours for all later styles; invalid: those of the palette. GUI
/// thread only.
void setMarkColours(const QColor& selection, const QColor& seam);

/// Colours of seam lines: stronger than any cloth's, distinguishable, and different from the yellow
/// and magenta of the selection.
inline constexpr int kSeamColours = 10;
/// @param onDark  lighter versions for a dark background, in the same order
const std::array<Rgb, kSeamColours>& seamPalette(bool onDark = false);

/// The palette index of each seam, -1 for free edges. Both sides of a seam share a colour that no
/// other seam on either piece has, so that the user can find an edge's partner. If a piece has
/// more seams than there are colours, at least seams of the same two pieces differ if possible.
/// Ties go to the least used colours, then to a hash of the seam's name. Cost: linear in the seams.
/// Pure.
std::vector<int> seamColours(const SeamGraph& seams);

}  // namespace toile::app
