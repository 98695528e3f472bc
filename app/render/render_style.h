// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

class QPalette;

namespace toile {

/// Colours of a view that go with the desktop's light or dark palette.
struct RenderStyle {
    QColor top, bottom;  ///< backdrop
    QColor grid;
    QColor outline;  ///< of pieces
    QColor wire;
    QColor selection;        ///< magenta: in no piece and on no colour bar
    QColor seam, seamHalo;   ///< the selected seam: yellow on near black reads on any cloth
    QColor designer;         ///< the designer's own outline
    QColor text, faintText;  ///< captions over the backdrop
    QColor plate;            ///< behind names on the cloth
};

/// True where the palette's windows are dark (Qt 6.4 does not tell).
bool isDark(const QPalette& palette);
RenderStyle renderStyle(const QPalette& palette);

}  // namespace toile
