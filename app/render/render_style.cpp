// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/render_style.h"

#include <QPalette>

namespace toile {

namespace {

struct MarkColours {
    QColor selection, seam;
};

/// For the whole window, as its palette is.
MarkColours& markColours() {
    static MarkColours colours;
    return colours;
}

RenderStyle usualStyle(const QPalette& palette) {
    const bool dark = isDark(palette);
    const auto tone = [dark](const QColor& onLight, const QColor& onDark) {
        return dark ? onDark : onLight;
    };
    return {.top = tone({250, 250, 251}, {52, 55, 61}),
            .bottom = tone({232, 235, 239}, {36, 38, 43}),
            .onDark = dark,
            .grid = tone({196, 203, 212}, {82, 87, 96}),
            .outline = tone({52, 58, 68}, {14, 15, 18}),
            .wire = tone({40, 46, 56}, {10, 11, 14}),
            .selection = tone({214, 16, 118}, {255, 92, 178}),
            .seam = QColor(255, 214, 10),
            .seamHalo = QColor(18, 20, 24),
            .freeEdge = tone({128, 136, 148}, {150, 156, 166}),
            .designer = tone({0, 92, 230}, {92, 214, 255}),
            .text = tone({40, 45, 53}, {226, 229, 234}),
            .faintText = tone({104, 112, 123}, {158, 164, 174}),
            .plate = tone({255, 255, 255, 200}, {24, 26, 30, 200})};
}

}  // namespace

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() < 128;
}

void setMarkColours(const QColor& selection, const QColor& seam) {
    markColours() = {selection, seam};
}

RenderStyle renderStyle(const QPalette& palette) {
    RenderStyle style = usualStyle(palette);
    const auto& [selection, seam] = markColours();
    style.selection = selection.isValid() ? selection : style.selection;
    style.seam = seam.isValid() ? seam : style.seam;
    return style;
}

}  // namespace toile
