// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

class QPalette;

namespace toile {

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
    QColor designer;         ///< the designer's own outline
    QColor text, faintText;  ///< captions over the backdrop
    QColor plate;            ///< behind names on the cloth
};

/// True where the palette's windows are dark (Qt 6.4 does not tell).
bool isDark(const QPalette& palette);
RenderStyle renderStyle(const QPalette& palette);
/// Colours that a person has chosen for what is selected, in all styles from now on; invalid: those
/// that go with the palette. GUI thread only.
void setMarkColours(const QColor& selection, const QColor& seam);

}  // namespace toile
