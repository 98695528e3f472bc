// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/colour_bar.h"

#include <QPainter>

#include "app/text/figures.h"

namespace toile::app {

ColourBar::ColourBar(QWidget* parent) : QWidget(parent) {
    setObjectName("colourBar");
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

QSize ColourBar::sizeHint() const {
    return {640, legendHeight(font())};
}

QSize ColourBar::minimumSizeHint() const {
    return {320, sizeHint().height()};
}

void ColourBar::show(const ColourLegend& legend) {
    const std::optional<double> value =
        legend.overlay == legend_.overlay ? legend_.value : std::nullopt;  // of another quantity
    legend_ = legend;
    legend_.value = value;
    if (!isMeasured(legend_.overlay)) {
        legend_.histogram.reset();
    }
    setAccessibleName(legend_.summary());
    const QString share = legend_.shareSentence();
    const QString meaning = overlayWords(legend_.overlay).meaning;
    setToolTip(share.isEmpty() ? meaning : tr("%1; %2").arg(meaning, share));
    update();
}

void ColourBar::showValue(std::optional<double> value) {
    if (value != legend_.value) {
        legend_.value = value;
        update();
    }
}

void ColourBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintLegend(painter, legend_, size(), font(), palette());
}

}  // namespace toile::app
