// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/colour_button.h"

#include <QColorDialog>
#include <QMenu>
#include <QPixmap>

namespace toile::app {

namespace {

constexpr QSize kSwatch(28, 16);

}  // namespace

ColourButton::ColourButton(QWidget* parent) : QToolButton(parent) {
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setPopupMode(QToolButton::InstantPopup);
    setIconSize(kSwatch);
    auto* menu = new QMenu(this);
    menu->addAction(tr("The theme's"), this, [this] { choose({}); })->setObjectName("usualColour");
    menu->addAction(tr("Another colour…"), this, [this] {
        const QColor chosen = QColorDialog::getColor(colour_, this);
        if (chosen.isValid()) {
            choose(chosen);
        }
    });
    setMenu(menu);
    setColour({});
}

void ColourButton::setColour(const QColor& colour) {
    colour_ = colour;
    setText(colour.isValid() ? colour.name() : tr("The theme's"));
    if (!colour.isValid()) {
        setIcon({});
        return;
    }
    QPixmap pixmap(kSwatch * devicePixelRatio());
    pixmap.fill(colour);
    setIcon(QIcon(pixmap));
}

void ColourButton::choose(const QColor& colour) {
    setColour(colour);
    emit colourChosen(colour);
}

}  // namespace toile::app
