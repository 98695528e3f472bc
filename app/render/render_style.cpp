// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/render_style.h"

#include <QPalette>

namespace toile {

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() < 128;
}

RenderStyle renderStyle(const QPalette& palette) {
    if (isDark(palette)) {
        return {QColor(52, 55, 61),    QColor(36, 38, 43),    QColor(82, 87, 96),
                QColor(14, 15, 18),    QColor(10, 11, 14),    QColor(255, 92, 178),
                QColor(226, 229, 234), QColor(158, 164, 174), QColor(24, 26, 30, 200)};
    }
    return {QColor(250, 250, 251), QColor(232, 235, 239), QColor(196, 203, 212),
            QColor(52, 58, 68),    QColor(40, 46, 56),    QColor(214, 16, 118),
            QColor(40, 45, 53),    QColor(104, 112, 123), QColor(255, 255, 255, 200)};
}

}  // namespace toile
