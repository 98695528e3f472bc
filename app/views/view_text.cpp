// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/view_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/render/overlay_scale.h"
#include "app/render/render_style.h"

namespace toile {

namespace {

constexpr double kMargin = 14;

QFont scaled(QFont font, double factor, bool bold) {
    font.setPointSizeF(std::max(6.5, font.pointSizeF() * factor));
    font.setWeight(bold ? QFont::DemiBold : QFont::Normal);
    return font;
}

}  // namespace

void paintCaption(QPainter& painter, const RenderStyle& style, const QString& title,
                  const QString& note) {
    painter.save();
    const QFont strong = scaled(painter.font(), 1.0, true);
    const QFontMetricsF metrics(strong);
    const double base = kMargin + metrics.ascent();
    painter.setFont(strong);
    painter.setPen(style.text);
    painter.drawText(QPointF(kMargin, base), title);
    const double next = kMargin + metrics.horizontalAdvance(title) + 10;
    painter.setFont(scaled(painter.font(), 0.88, false));
    painter.setPen(style.faintText);
    painter.drawText(QPointF(next, base), note);
    painter.restore();
}

void paintPlate(QPainter& painter, const RenderStyle& style, const QPointF& middle, double room,
                const QString& text, bool selected) {
    const QFont font = scaled(painter.font(), 0.9, selected);
    const QFontMetricsF metrics(font);
    constexpr double kPadX = 7, kPadY = 2.5, kLeast = 26;
    const double available = room - 2 * kPadX;
    if (available < kLeast) {
        return;
    }
    const QString shown = metrics.elidedText(text, Qt::ElideMiddle, available);
    const double width = metrics.horizontalAdvance(shown) + 2 * kPadX;
    const double height = metrics.height() + 2 * kPadY;
    const QRectF plate(middle.x() - width / 2, middle.y() - height / 2, width, height);
    painter.save();
    painter.setFont(font);
    painter.setPen(selected ? QPen(style.selection, 1.5) : QPen(Qt::NoPen));
    painter.setBrush(style.plate);
    painter.drawRoundedRect(plate, height / 2, height / 2);
    painter.setPen(style.text);
    painter.drawText(plate, Qt::AlignCenter, shown);
    painter.restore();
}

ScaleBar scaleBarFor(double pixels, double pixelsPerMillimetre) {
    const double wanted = pixels / pixelsPerMillimetre;
    // The largest round length not longer than what is wanted.
    double length = roundedUp(wanted);
    if (length > wanted * (1 + 1e-9)) {
        length = roundedUp(length / 2.6);
    }
    const QLocale locale;
    if (length >= 1000) {
        return {length, QCoreApplication::translate("ScaleBar", "%1 m")
                            .arg(locale.toString(length / 1000, 'g', 4))};
    }
    if (length >= 10) {
        return {length, QCoreApplication::translate("ScaleBar", "%1 cm")
                            .arg(locale.toString(length / 10, 'g', 4))};
    }
    return {length,
            QCoreApplication::translate("ScaleBar", "%1 mm").arg(locale.toString(length, 'g', 4))};
}

void paintScaleBar(QPainter& painter, const RenderStyle& style, const QRect& view,
                   double pixelsPerMillimetre) {
    const ScaleBar bar = scaleBarFor(150, pixelsPerMillimetre);
    const double length = bar.millimetres * pixelsPerMillimetre;
    const double left = kMargin + 2, base = view.height() - kMargin - 2;
    constexpr double kTick = 5;
    painter.save();
    const QFont font = scaled(painter.font(), 0.88, false);
    const QFontMetricsF metrics(font);
    const QRectF plate(left - 8, base - kTick - metrics.height() - 6, length + 16,
                       metrics.height() + kTick + 12);
    painter.setPen(Qt::NoPen);
    painter.setBrush(style.plate);
    painter.drawRoundedRect(plate, 5, 5);
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

}  // namespace toile
