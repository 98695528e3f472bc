// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/theme.h"

#include <QApplication>
#include <QStyle>
#include <QStyleFactory>

namespace toile {

namespace {

/// The colours a palette is made of.
struct Tones {
    QColor window, base, alternate, button;
    QColor text, faint, disabled;
    QColor accent, onAccent, link, visited;
    QColor tip, onTip;
    QColor light, midlight, mid, dark, shadow;  ///< edges of frames and buttons
};

QPalette paletteOf(const Tones& tones) {
    QPalette palette;
    const std::pair<QPalette::ColorRole, QColor> roles[] = {
        {QPalette::Window, tones.window},
        {QPalette::WindowText, tones.text},
        {QPalette::Base, tones.base},
        {QPalette::AlternateBase, tones.alternate},
        {QPalette::Text, tones.text},
        {QPalette::PlaceholderText, tones.faint},
        {QPalette::Button, tones.button},
        {QPalette::ButtonText, tones.text},
        {QPalette::BrightText, tones.onAccent},
        {QPalette::Highlight, tones.accent},
        {QPalette::HighlightedText, tones.onAccent},
        {QPalette::Link, tones.link},
        {QPalette::LinkVisited, tones.visited},
        {QPalette::ToolTipBase, tones.tip},
        {QPalette::ToolTipText, tones.onTip},
        {QPalette::Light, tones.light},
        {QPalette::Midlight, tones.midlight},
        {QPalette::Mid, tones.mid},
        {QPalette::Dark, tones.dark},
        {QPalette::Shadow, tones.shadow},
    };
    for (const auto& [role, colour] : roles) {
        palette.setColor(role, colour);
    }
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                            QPalette::HighlightedText, QPalette::PlaceholderText}) {
        palette.setColor(QPalette::Disabled, role, tones.disabled);
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, tones.mid);
    palette.setColor(QPalette::Disabled, QPalette::Base, tones.window);
    return palette;
}

}  // namespace

QPalette lightPalette() {
    return paletteOf({.window = QColor(243, 244, 246),
                      .base = QColor(255, 255, 255),
                      .alternate = QColor(247, 248, 250),
                      .button = QColor(246, 247, 249),
                      .text = QColor(31, 35, 41),
                      .faint = QColor(104, 110, 120),
                      .disabled = QColor(158, 163, 171),
                      .accent = QColor(37, 99, 171),
                      .onAccent = QColor(255, 255, 255),
                      .link = QColor(24, 92, 178),
                      .visited = QColor(110, 70, 160),
                      .tip = QColor(255, 255, 255),
                      .onTip = QColor(31, 35, 41),
                      .light = QColor(255, 255, 255),
                      .midlight = QColor(232, 234, 238),
                      .mid = QColor(196, 200, 207),
                      .dark = QColor(164, 169, 178),
                      .shadow = QColor(110, 116, 126)});
}

QPalette darkPalette() {
    return paletteOf({.window = QColor(43, 45, 50),
                      .base = QColor(33, 35, 39),
                      .alternate = QColor(38, 40, 45),
                      .button = QColor(54, 57, 63),
                      .text = QColor(226, 229, 234),
                      .faint = QColor(154, 160, 170),
                      .disabled = QColor(112, 117, 126),
                      .accent = QColor(47, 111, 184),
                      .onAccent = QColor(255, 255, 255),
                      .link = QColor(122, 178, 245),
                      .visited = QColor(190, 160, 235),
                      .tip = QColor(58, 61, 68),
                      .onTip = QColor(232, 235, 240),
                      .light = QColor(78, 82, 90),
                      .midlight = QColor(64, 67, 74),
                      .mid = QColor(50, 53, 59),
                      .dark = QColor(28, 30, 34),
                      .shadow = QColor(14, 15, 18)});
}

void applyTheme(Theme theme) {
    // As the desktop has it; known only until another style is set.
    static const QString desktopStyle = QApplication::style()->name();
    QApplication::setStyle(
        QStyleFactory::create(theme == Theme::System ? desktopStyle : QString("fusion")));
    switch (theme) {
        case Theme::System:
            QApplication::setPalette(QPalette());
            return;
        case Theme::Light:
            QApplication::setPalette(lightPalette());
            return;
        case Theme::Dark:
            QApplication::setPalette(darkPalette());
            return;
    }
}

}  // namespace toile
