// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/colour_bar.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/render/colour_map.h"

namespace toile {

namespace {

constexpr int kHeight = 46;
constexpr int kMargin = 14;
constexpr int kBarHeight = 12;
constexpr int kLongestBar = 460;
constexpr QChar kMinus(0x2212);

}  // namespace

ColourBar::ColourBar(QWidget* parent) : QWidget(parent) {
    setObjectName("colourBar");
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

QSize ColourBar::sizeHint() const {
    return {640, std::max(kHeight, fontMetrics().height() * 3)};
}

QSize ColourBar::minimumSizeHint() const {
    return {320, sizeHint().height()};
}

void ColourBar::show(Overlay overlay, const OverlayScale& scale) {
    overlay_ = overlay;
    scale_ = scale;
    setAccessibleName(summary());
    setToolTip(words().meaning);
    update();
}

ColourBar::Words ColourBar::words() const {
    switch (overlay_) {
        case Overlay::None:
            return {tr("Piece colours"), {}, tr("each piece in its own colour")};
        case Overlay::Checker:
            return {tr("Checkerboard"), {}, tr("squares of 1 cm on the flat cloth")};
        case Overlay::Area:
            return {tr("Area change"), tr("%"),
                    tr("flat against worn: blue has lost area, orange has gained")};
        case Overlay::Angle:
            return {tr("Angle change"), tr("°"),
                    tr("largest change of a corner, flat against worn")};
        case Overlay::Strain:
            return {tr("Edge strain"), tr("%"),
                    tr("what the cloth must do: orange stretches, blue has surplus")};
    }
    return {};
}

QString ColourBar::number(double value) const {
    QString text = QLocale().toString(std::abs(value), 'g', 4);
    if (value < 0) {
        text.prepend(kMinus);
    } else if (value > 0 && overlay_ != Overlay::Angle) {
        text.prepend('+');
    }
    return text;
}

QString ColourBar::endLabel(bool high) const {
    const bool clamped = high ? scale_.above : scale_.below;
    const QString text = number(high ? scale_.high : scale_.low);
    if (!clamped) {
        return text;
    }
    return (high ? QString(QChar(0x2265)) : QString(QChar(0x2264))) + ' ' + text;
}

QString ColourBar::summary() const {
    const Words what = words();
    if (!isMeasured(overlay_)) {
        return what.title + ": " + what.meaning;
    }
    return tr("%1: %2 %4 to %3 %4").arg(what.title, endLabel(false), endLabel(true), what.unit);
}

void ColourBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    const Words what = words();
    QFont strong = font();
    strong.setWeight(QFont::DemiBold);
    const QFontMetricsF strongMetrics(strong);
    const QString title =
        what.unit.isEmpty() ? what.title : tr("%1 (%2)").arg(what.title, what.unit);

    // Every title gets the same room, so that the bar keeps its place when the overlay changes.
    const double titleWidth = std::max(strongMetrics.horizontalAdvance(title),
                                       strongMetrics.horizontalAdvance(tr("Angle change (%)")));
    painter.setFont(strong);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(kMargin, 0, titleWidth + 4, height()), Qt::AlignVCenter, title);
    painter.setFont(font());

    const double left = kMargin + titleWidth + 28;
    double end = left;
    if (isMeasured(overlay_)) {
        const double length = std::clamp(width() * 0.42, 160.0, double(kLongestBar));
        const double block = kBarHeight + 4 + fontMetrics().height();
        const QRectF bar(left, (height() - block) / 2, length, kBarHeight);
        paintBar(painter, bar);
        end = bar.right() + 34;
    } else if (overlay_ == Overlay::Checker) {
        const QRectF area(left, (height() - 16) / 2.0, 32, 16);
        paintSquares(painter, area);
        end = area.right() + 12;
    }
    QColor faint = palette().color(QPalette::WindowText);
    faint.setAlphaF(0.72F);
    painter.setPen(faint);
    const QRectF rest(end, 0, width() - end - kMargin, height());
    painter.drawText(rest, Qt::AlignVCenter,
                     fontMetrics().elidedText(what.meaning, Qt::ElideRight, int(rest.width())));
}

void ColourBar::paintBar(QPainter& painter, const QRectF& bar) const {
    const ColourMap& map = colourMap(overlay_);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int kStops = 32;
    for (int i = 0; i <= kStops; ++i) {
        const Rgb c = map[static_cast<std::size_t>(i * (kColourMapSize - 1) / kStops)];
        gradient.setColorAt(i / double(kStops), QColor(c.r, c.g, c.b));
    }
    QColor frame = palette().color(QPalette::WindowText);
    frame.setAlphaF(0.35F);
    painter.setPen(QPen(frame, 1));
    painter.setBrush(gradient);
    painter.drawRoundedRect(bar, 2.5, 2.5);

    constexpr int kParts = 4;
    for (int i = 0; i <= kParts; ++i) {
        const double x = bar.left() + bar.width() * i / kParts;
        const double value = scale_.low + (scale_.high - scale_.low) * i / kParts;
        const QString text = i == 0        ? endLabel(false)
                             : i == kParts ? endLabel(true)
                                           : number(value);
        painter.setPen(QPen(frame, 1));
        painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 3));
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QRectF(x - 60, bar.bottom() + 4, 120, fontMetrics().height()),
                         Qt::AlignHCenter, text);
    }
}

void ColourBar::paintSquares(QPainter& painter, const QRectF& area) const {
    const Rgb cloth = pieceColour(0);
    const QColor dark = QColor(cloth.r, cloth.g, cloth.b).darker(120);
    const QColor light = QColor(cloth.r, cloth.g, cloth.b).lighter(145);
    const double side = area.height() / 2;
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 4; ++column) {
            painter.fillRect(
                QRectF(area.left() + column * side, area.top() + row * side, side, side),
                (row + column) % 2 == 0 ? dark : light);
        }
    }
}

}  // namespace toile
