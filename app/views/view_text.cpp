// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/view_text.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "app/render/colour_map.h"
#include "app/render/render_style.h"
#include "app/settings/length_display.h"

namespace toile::app {

namespace {

constexpr double kMargin = 14;
constexpr double kCaptionGap = 10;  ///< between title and note
constexpr double kScaleBar = 150;   ///< approximate length in pixels
constexpr double kScaleTick = 5;

QFont scaled(QFont font, double factor, bool bold) {
    if (font.pixelSize() > 0) {
        font.setPixelSize(std::max(9, qRound(font.pixelSize() * factor)));
    } else {
        font.setPointSizeF(std::max(6.5, font.pointSizeF() * factor));
    }
    font.setWeight(bold ? QFont::DemiBold : QFont::Normal);
    return font;
}

/// Round lengths in inches: below one inch, halves of halves as on a tape measure.
double roundInches(double millimetres) {
    const double inches = millimetres / millimetresPer(LengthUnit::Inch);
    constexpr double kRound[] = {144, 72, 36, 24, 12, 6, 4, 2, 1, 0.5, 0.25, 0.125};
    const auto* fits = std::find_if(std::begin(kRound), std::end(kRound),
                                    [inches](double length) { return length <= inches; });
    return (fits == std::end(kRound) ? kRound[std::size(kRound) - 1] : *fits) *
           millimetresPer(LengthUnit::Inch);
}

}  // namespace

QRectF captionBox(const QFont& font, const QPointF& corner, const QString& title,
                  const QString& note) {
    constexpr double kPadX = 7, kPadY = 3;
    const QFontMetricsF strong(scaled(font, 1.0, true));
    double width = strong.horizontalAdvance(title);
    if (!note.isEmpty()) {
        width += kCaptionGap + QFontMetricsF(scaled(font, 0.88, false)).horizontalAdvance(note);
    }
    return QRectF(corner + QPointF(kMargin, kMargin), QSizeF(width, strong.height()))
        .adjusted(-kPadX, -kPadY, kPadX, kPadY);
}

void paintCaption(QPainter& painter, const RenderStyle& style, const QPointF& corner,
                  const QString& title, const QString& note, bool onLabel) {
    painter.save();
    if (onLabel) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(style.labelFill);
        painter.drawRoundedRect(captionBox(painter.font(), corner, title, note), 5, 5);
    }
    const QFont strong = scaled(painter.font(), 1.0, true);
    const QFontMetricsF metrics(strong);
    const QPointF base = corner + QPointF(kMargin, kMargin + metrics.ascent());
    const QFont small = scaled(painter.font(), 0.88, false);
    painter.setFont(strong);
    painter.setPen(style.text);
    painter.drawText(base, title);
    painter.setFont(small);
    painter.setPen(onLabel ? style.text : style.faintText);
    painter.drawText(base + QPointF(metrics.horizontalAdvance(title) + kCaptionGap, 0), note);
    painter.restore();
}

QFont labelFont(const QFont& font, bool selected, double size) {
    return scaled(font, 0.9 * size, selected);
}

QSizeF labelSize(const QFont& font, const QString& text, bool selected, double size) {
    const bool isUsual = size >= 1;
    const double padX = isUsual ? 7 : 4, padY = isUsual ? 2.5 : 0;
    const QFontMetricsF metrics(labelFont(font, selected, size));
    return {metrics.horizontalAdvance(text) + 2 * padX, metrics.height() + 2 * padY};
}

void paintLabel(QPainter& painter, const RenderStyle& style, const QRectF& box, const QString& text,
                bool selected, double size) {
    painter.save();
    painter.setFont(labelFont(painter.font(), selected, size));
    painter.setPen(selected ? QPen(style.selection, 1.5) : QPen(Qt::NoPen));
    painter.setBrush(style.labelFill);
    painter.drawRoundedRect(box, box.height() / 2, box.height() / 2);
    painter.setPen(style.text);
    painter.drawText(box, Qt::AlignCenter, text);
    painter.restore();
}

ScaleBar scaleBarFor(double pixels, double pixelsPerMillimetre) {
    const double wanted = pixels / pixelsPerMillimetre;
    const LengthUnit unit = LengthDisplay::instance().format().unit;
    if (unit == LengthUnit::Inch) {
        const double length = roundInches(wanted);
        return {length, QString::fromStdString(lengthText(length, {unit, 8, "."}))};
    }
    // The largest round length that does not exceed the wanted one.
    double length = roundedUp(wanted);
    if (length > wanted * (1 + 1e-9)) {
        length = roundedUp(length / 2.6);
    }
    const QLocale locale;
    if (length >= 1000) {
        return {length, QString("%1 m").arg(locale.toString(length / 1000, 'g', 4))};
    }
    if (length >= 10) {
        return {length, QString("%1 cm").arg(locale.toString(length / 10, 'g', 4))};
    }
    return {length, QString("%1 mm").arg(locale.toString(length, 'g', 4))};
}

bool crosses(const QLineF& line, const QRectF& box) {
    double from = 0, to = 1;  // the part of the line inside the box
    const auto clip = [&](double start, double way, double low, double high) -> bool {
        if (way == 0) {
            return start >= low && start <= high;
        }
        const auto [enters, leaves] = std::minmax({(low - start) / way, (high - start) / way});
        from = std::max(from, enters);
        to = std::min(to, leaves);
        return from <= to;
    };
    return clip(line.x1(), line.dx(), box.left(), box.right()) &&
           clip(line.y1(), line.dy(), box.top(), box.bottom());
}

QRectF scaleBarBox(const QFont& font, const QRect& view, double pixelsPerMillimetre, double taken) {
    const double length =
        scaleBarFor(kScaleBar, pixelsPerMillimetre).millimetres * pixelsPerMillimetre;
    const double left = taken + kMargin + 2, base = view.height() - kMargin - 2;
    const double text = QFontMetricsF(scaled(font, 0.88, false)).height();
    return {left - 8, base - kScaleTick - text - 6, length + 16, text + kScaleTick + 12};
}

void paintScaleBar(QPainter& painter, const RenderStyle& style, const QRect& view,
                   double pixelsPerMillimetre, double taken) {
    const ScaleBar bar = scaleBarFor(kScaleBar, pixelsPerMillimetre);
    const double length = bar.millimetres * pixelsPerMillimetre;
    const double left = taken + kMargin + 2, base = view.height() - kMargin - 2;
    constexpr double kTick = kScaleTick;
    painter.save();
    const QFont font = scaled(painter.font(), 0.88, false);
    const QFontMetricsF metrics(font);
    const QRectF box = scaleBarBox(painter.font(), view, pixelsPerMillimetre, taken);
    painter.setPen(Qt::NoPen);
    painter.setBrush(style.labelFill);
    painter.drawRoundedRect(box, 5, 5);
    painter.setPen(QPen(style.text, 1.5));
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.drawLine(QPointF(left, base), QPointF(left + length, base));
    painter.drawLine(QPointF(left, base - kTick), QPointF(left, base));
    painter.drawLine(QPointF(left + length, base - kTick), QPointF(left + length, base));
    painter.setRenderHint(QPainter::Antialiasing, true);
    painter.setFont(font);
    painter.drawText(QRectF(left, base - kTick - metrics.height() - 1, length, metrics.height()),
                     Qt::AlignCenter, bar.text);
    painter.restore();
}

OverPainter::OverPainter(const QWidget& widget) : device_(devicePixels(widget)) {
    device_.setDevicePixelRatio(widget.devicePixelRatioF());
    painter_.begin(&device_);
    painter_.setFont(widget.font());
    painter_.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
}

QSize devicePixels(const QWidget& widget) {
    const double ratio = widget.devicePixelRatioF();
    return {static_cast<int>(std::lround(widget.width() * ratio)),
            static_cast<int>(std::lround(widget.height() * ratio))};
}

void paintProblem(QPainter& painter, const RenderStyle& style, const QRect& view,
                  const QString& problem) {
    constexpr int kTextAir = 20;
    painter.fillRect(view, style.bottom);
    painter.setPen(style.text);
    painter.drawText(view.adjusted(kTextAir, kTextAir, -kTextAir, -kTextAir),
                     Qt::AlignCenter | Qt::TextWordWrap, problem);
}

}  // namespace toile::app
