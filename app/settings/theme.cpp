// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/theme.h"

#include <QApplication>
#include <QStyle>
#include <QStyleFactory>
#include <vector>

namespace toile::app {

namespace {

/// Palette roles that share a colour, for the light and the dark theme.
struct Tone {
    std::vector<QPalette::ColorRole> roles;
    QColor light, dark;
};

QPalette paletteOf(QColor Tone::*tone) {
    static const Tone kTones[] = {
        {{QPalette::Window}, {243, 244, 246}, {43, 45, 50}},
        {{QPalette::Base}, {255, 255, 255}, {33, 35, 39}},
        {{QPalette::AlternateBase}, {247, 248, 250}, {38, 40, 45}},
        {{QPalette::Button}, {246, 247, 249}, {54, 57, 63}},
        {{QPalette::WindowText, QPalette::Text, QPalette::ButtonText},
         {31, 35, 41},
         {226, 229, 234}},
        {{QPalette::PlaceholderText}, {104, 110, 120}, {154, 160, 170}},
        {{QPalette::Highlight}, {37, 99, 171}, {47, 111, 184}},
        {{QPalette::HighlightedText, QPalette::BrightText}, {255, 255, 255}, {255, 255, 255}},
        {{QPalette::Link}, {24, 92, 178}, {122, 178, 245}},
        {{QPalette::LinkVisited}, {110, 70, 160}, {190, 160, 235}},
        {{QPalette::ToolTipBase}, {255, 255, 255}, {58, 61, 68}},
        {{QPalette::ToolTipText}, {31, 35, 41}, {232, 235, 240}},
        // Edges of frames and buttons.
        {{QPalette::Light}, {255, 255, 255}, {78, 82, 90}},
        {{QPalette::Midlight}, {232, 234, 238}, {64, 67, 74}},
        {{QPalette::Mid}, {196, 200, 207}, {50, 53, 59}},
        {{QPalette::Dark}, {164, 169, 178}, {28, 30, 34}},
        {{QPalette::Shadow}, {110, 116, 126}, {14, 15, 18}},
    };
    static const Tone kDisabled = {{QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                                    QPalette::HighlightedText, QPalette::PlaceholderText},
                                   {158, 163, 171},
                                   {112, 117, 126}};
    QPalette palette;
    for (const Tone& colour : kTones) {
        for (const auto role : colour.roles) {
            palette.setColor(role, colour.*tone);
        }
    }
    for (const auto role : kDisabled.roles) {
        palette.setColor(QPalette::Disabled, role, kDisabled.*tone);
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, palette.color(QPalette::Mid));
    palette.setColor(QPalette::Disabled, QPalette::Base, palette.color(QPalette::Window));
    return palette;
}

}  // namespace

QPalette lightPalette() {
    return paletteOf(&Tone::light);
}

QPalette darkPalette() {
    return paletteOf(&Tone::dark);
}

void applyTheme(Theme theme) {
    // The desktop's style; it must be read before another one is set.
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

}  // namespace toile::app
