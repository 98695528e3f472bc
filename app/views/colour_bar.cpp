// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/colour_bar.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>

#include "app/render/render_style.h"
#include "app/text/figures.h"

namespace toile::app {

namespace {

/// Logical pixels, including the space of the scale bar in the other corner.
constexpr int kCornerWidth = 440, kCornerMargin = 12, kBesideCorner = 212;
/// If less than this is left beside the scale bar, the legend moves above it. There it uses the
/// whole width minus the margins for a ruler.
constexpr int kMinWidth = 260, kAtSides = 40, kAboveCorner = 52;
constexpr int kMinGround = 238;  ///< of 255: hides the drawing below, so that the words are legible

}  // namespace

ColourBar::ColourBar(QWidget* parent) : QWidget(parent) {
    setObjectName("colourBar");
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

ColourBar* ColourBar::inCorner(QWidget& view) {
    auto* bar = new ColourBar(&view);
    bar->shape_ = LegendShape::Corner;
    bar->setCursor(Qt::ArrowCursor);
    bar->setAttribute(Qt::WA_NoMousePropagation);
    bar->hide();
    view.installEventFilter(bar);
    return bar;
}

void ColourBar::placeInCorner() {
    const QWidget& view = *parentWidget();
    const bool isAbove = view.width() - kBesideCorner < kMinWidth;
    const int taken = isAbove ? kAtSides : kBesideCorner;
    const int width = std::clamp(view.width() - taken, 1, kCornerWidth);
    const int height = cornerLegendHeight(legend_, font(), width);
    const int below = isAbove ? kAboveCorner : kCornerMargin;
    setGeometry(view.width() - width - kCornerMargin, std::max(0, view.height() - height - below),
                width, height);
}

bool ColourBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize) {
        placeInCorner();
    }
    return QWidget::eventFilter(watched, event);
}

QSize ColourBar::sizeHint() const {
    return {640, legendHeight(font(), shape_)};
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
    const QString meaning = legend_.meaning();
    setToolTip(share.isEmpty() ? meaning : tr("%1; %2").arg(meaning, share));
    if (shape_ == LegendShape::Corner) {
        setVisible(isMeasured(legend_.overlay) || legend_.overlay == Overlay::Normal);
        placeInCorner();
    }
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
    if (shape_ == LegendShape::Corner) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        QColor ground = renderStyle(palette()).labelFill;
        ground.setAlpha(std::max(ground.alpha(), kMinGround));
        painter.setBrush(ground);
        painter.drawRoundedRect(rect(), 7, 7);
    }
    paintLegend(painter, legend_, size(), font(), palette(), shape_);
}

}  // namespace toile::app
