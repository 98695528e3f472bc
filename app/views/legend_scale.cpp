// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/legend_scale.h"

#include <QLinearGradient>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/render/colour_map.h"
#include "app/text/figures.h"
#include "app/views/colour_legend.h"

namespace toile::app {
namespace {

/// Room for the label of a tick, so that neighbours do not touch.
constexpr double kTickRoom = 42;

QColor colourAt(const ColourMap& map, double place) {
    const Rgb c = map[static_cast<std::size_t>(std::lround(place * (kColourMapSize - 1)))];
    return {c.r, c.g, c.b};
}

}  // namespace

QColor faded(QColor colour, float alpha) {
    colour.setAlphaF(alpha);
    return colour;
}

QFont legendTitleFont(QFont font) {
    font.setWeight(QFont::DemiBold);
    return font;
}

LegendScale::LegendScale(QPainter& painter, const ColourLegend& legend, const QFont& font,
                         const QPalette& palette)
    : painter_(painter),
      legend_(legend),
      font_(font),
      metrics_(font),
      ink_(palette.color(QPalette::WindowText)),
      ground_(palette.color(QPalette::Window)) {}

void LegendScale::paint(const QRectF& bar) const {
    paintHistogram(bar);
    paintColours(bar);
    paintTicks(bar);
    paintValue(bar);
}

bool LegendScale::hasCaps() const {
    return legend_.scale.limited;
}

double LegendScale::xOf(const QRectF& bar, double value) const {
    return bar.left() + bar.width() * legend_.scale.position(value);
}

void LegendScale::paintHistogram(const QRectF& bar) const {
    if (!legend_.histogram || legend_.histogram->tallest() <= 0) {
        return;
    }
    const double step = bar.width() / kHistogramBins;
    const double highest = kHistogram - 3;
    QPainterPath columns;
    for (int i = 0; i < kHistogramBins; ++i) {
        const double share =
            legend_.histogram->bins[static_cast<std::size_t>(i)] / legend_.histogram->tallest();
        if (share > 0) {
            // What is there shows, however little it is.
            const double size = std::max(1.0, share * highest);
            columns.addRect(bar.left() + i * step, bar.top() - 1 - size, step - 1, size);
        }
    }
    painter_.fillPath(columns, faded(ink_, 0.42F));
}

void LegendScale::paintColours(const QRectF& bar) const {
    const ColourMap& map = colourMap(legend_.overlay);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int kStops = 64;
    for (int i = 0; i <= kStops; ++i) {
        const double place = i / double(kStops);
        const double value = legend_.scale.low + (legend_.scale.high - legend_.scale.low) * place;
        gradient.setColorAt(place, colourAt(map, legend_.scale.shade(value)));
    }
    painter_.setPen(QPen(faded(ink_, 0.35F), 1));
    painter_.setBrush(gradient);
    painter_.drawRect(bar);
    if (hasCaps()) {
        paintCap({bar.left() - kCapGap - kCap, bar.top(), kCap, bar.height()}, false);
        paintCap({bar.right() + kCapGap, bar.top(), kCap, bar.height()}, true);
    }
}

void LegendScale::paintCap(const QRectF& cap, bool high) const {
    // Striped as the cloth is: down to the right for surplus, up to the right for stretch.
    painter_.save();
    painter_.setPen(QPen(faded(ink_, 0.35F), 1));
    painter_.setBrush(colourAt(colourMap(legend_.overlay), high ? 1 : 0));
    painter_.drawRect(cap);
    painter_.setClipRect(cap.adjusted(0.5, 0.5, -0.5, -0.5));
    painter_.setPen(QPen(QColor(247, 247, 247, 230), 1.9));
    constexpr double kPeriod = 9.9;  // 7 across the stripes, as in surface.glsl
    const int stripes = static_cast<int>((cap.width() + 2 * cap.height()) / kPeriod) + 1;
    for (int stripe = 0; stripe < stripes; ++stripe) {
        const double x = cap.left() - cap.height() + stripe * kPeriod;
        painter_.drawLine(QPointF(x, high ? cap.bottom() : cap.top()),
                          QPointF(x + cap.height(), high ? cap.top() : cap.bottom()));
    }
    painter_.restore();
    if (legend_.histogram) {
        const double share = high ? legend_.histogram->above : legend_.histogram->below;
        painter_.setPen(faded(ink_, share > 0 ? 1.0F : 0.5F));
        painter_.drawText(
            QRectF(cap.center().x() - 40, cap.top() - 3 - metrics_.height(), 80, metrics_.height()),
            Qt::AlignHCenter | Qt::AlignBottom, legend_.endShareText(high));
    }
}

void LegendScale::paintTicks(const QRectF& bar) const {
    const auto tick = [&](double value, const QString& text) {
        const double x = xOf(bar, value);
        painter_.setPen(QPen(faded(ink_, 0.5F), 1));
        painter_.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 3));
        painter_.setPen(ink_);
        painter_.drawText(QRectF(x - 60, bar.bottom() + 4, 120, metrics_.height()),
                          Qt::AlignHCenter, text);
    };
    tick(legend_.scale.low, legend_.endLabel(false));
    tick(legend_.scale.high, legend_.endLabel(true));
    const double range = legend_.scale.high - legend_.scale.low;
    const double unit = overlayUnit(legend_.overlay);
    const double step = unit * roundedUp(range / unit * kTickRoom * 1.4 / bar.width());
    for (double k = std::ceil(legend_.scale.low / step); k * step < legend_.scale.high; ++k) {
        const double x = xOf(bar, k * step);
        if (x - bar.left() >= kTickRoom && bar.right() - x >= kTickRoom) {
            tick(k * step, overlayNumber(legend_.overlay, k * step));
        }
    }
}

void LegendScale::paintValue(const QRectF& bar) const {
    const QString text = legend_.valueText();
    if (text.isEmpty()) {
        return;
    }
    const bool beyond = hasCaps() && legend_.scale.severity(*legend_.value) > 1;
    const double x = !beyond                               ? xOf(bar, *legend_.value)
                     : *legend_.value > legend_.scale.high ? bar.right() + kCapGap + kCap / 2
                                                           : bar.left() - kCapGap - kCap / 2;
    QPainterPath mark;
    mark.addPolygon(
        QPolygonF({{x - 4.5, bar.top() - 7}, {x + 4.5, bar.top() - 7}, {x, bar.top()}}));
    mark.closeSubpath();
    painter_.fillPath(mark, ink_);
    painter_.fillRect(QRectF(x - 0.75, bar.top(), 1.5, bar.height()), ink_);

    const QFont strong = legendTitleFont(font_);
    const QFontMetricsF metrics(strong);
    const double width = metrics.horizontalAdvance(text) + 10;
    QRectF box(x - width / 2, bar.top() - 8 - metrics.height(), width, metrics.height());
    box.moveTop(std::max(1.0, box.top()));
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(faded(ground_, 0.92F));
    painter_.drawRoundedRect(box, 3, 3);
    painter_.setFont(strong);
    painter_.setPen(ink_);
    painter_.drawText(box, Qt::AlignCenter, text);
    painter_.setFont(font_);
}

}  // namespace toile::app
