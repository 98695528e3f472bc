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
    RenderStyle style;
    style.seam = QColor(255, 214, 10);
    style.seamHalo = QColor(18, 20, 24);
    if (isDark(palette)) {
        style.onDark = true;
        style.top = QColor(52, 55, 61);
        style.bottom = QColor(36, 38, 43);
        style.grid = QColor(82, 87, 96);
        style.outline = QColor(14, 15, 18);
        style.wire = QColor(10, 11, 14);
        style.freeEdge = QColor(150, 156, 166);
        style.selection = QColor(255, 92, 178);
        style.designer = QColor(92, 214, 255);
        style.text = QColor(226, 229, 234);
        style.faintText = QColor(158, 164, 174);
        style.plate = QColor(24, 26, 30, 200);
        return style;
    }
    style.top = QColor(250, 250, 251);
    style.bottom = QColor(232, 235, 239);
    style.grid = QColor(196, 203, 212);
    style.outline = QColor(52, 58, 68);
    style.wire = QColor(40, 46, 56);
    style.freeEdge = QColor(128, 136, 148);
    style.selection = QColor(214, 16, 118);
    style.designer = QColor(0, 92, 230);
    style.text = QColor(40, 45, 53);
    style.faintText = QColor(104, 112, 123);
    style.plate = QColor(255, 255, 255, 200);
    return style;
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
