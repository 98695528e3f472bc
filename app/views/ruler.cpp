// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/ruler.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/render/colour_map.h"
#include "app/render/render_style.h"
#include "app/settings/length_display.h"
#include "app/text/figures.h"
#include "app/views/tool.h"
#include "core/base/units.h"

namespace toile::app {

namespace {

/// Space for the caption above and the scale bar below, not counting the rulers.
constexpr Camera2D::Margins kMargins{26, 50, 118};

constexpr double kMajorPixels = 56;  // between labelled ticks, minimum
constexpr double kTickPixels = 5;    // between ticks, minimum
constexpr int kFinestFraction = 64;  // of an inch; finer values are written as decimals

struct Ticks {
    double step;  ///< mm between neighbours
    int perMajor;
    long first, last;  ///< whole steps from the origin
};

Ticks ticksBetween(const RulerSteps& steps, double low, double high) {
    const double step = steps.major / steps.parts;
    return {step, steps.parts, std::lround(std::floor(low / step)),
            std::lround(std::ceil(high / step))};
}

/// Length of a tick: full breadth if labelled, less at halves, least in between.
double lengthOf(const Ticks& ticks, long tick) {
    if (tick % ticks.perMajor == 0) {
        return kRulerBreadth;
    }
    if (ticks.perMajor % 2 == 0 && tick % (ticks.perMajor / 2) == 0) {
        return 8;
    }
    const bool isQuarter = ticks.perMajor == 8 && tick % 2 == 0;  // of an inch
    return isQuarter ? 6 : 4.5;
}

/// The smallest of 1, 1/2, 1/4 ... 1/64 that is at least `least`.
double halvedDownTo(double least) {
    double size = 1;
    while (size / 2 >= least * (1 - 1e-9) && size * kFinestFraction > 1) {
        size /= 2;
    }
    return size;
}

/// The possible divisions of a step, finest first.
std::array<int, 3> partsOf(double major, bool inHalves) {
    if (inHalves) {
        return {8, 4, 2};
    }
    const double digits = major / std::pow(10.0, std::floor(std::log10(major) + 1e-9));
    const bool isTwo = std::abs(digits - 2) < 0.1;
    return {isTwo ? 20 : 10, isTwo ? 4 : 5, 2};
}

}  // namespace

RulerSteps rulerSteps(double pixelsPerMillimetre, LengthUnit unit) {
    const bool isInch = unit == LengthUnit::Inch;
    const double one = isInch ? millimetresPer(unit) : 1;
    const double least = kMajorPixels / pixelsPerMillimetre / one;
    const bool isFraction = isInch && least <= 1 && least * kFinestFraction > 0.5;
    const double major = isFraction ? halvedDownTo(least) : roundedUp(least);
    for (const int parts : partsOf(major, isInch && major <= 1)) {
        if (major * one / parts * pixelsPerMillimetre >= kTickPixels) {
            return {major * one, parts};
        }
    }
    return {major * one, 1};
}

RulerUnit rulerUnit(const RulerSteps& steps, LengthUnit unit) {
    switch (unit) {
        case LengthUnit::Inch:
            return {QCoreApplication::translate("Ruler", "in"), millimetresPer(unit), true};
        case LengthUnit::Centimetre:
            if (steps.major < 1000) {
                return {QCoreApplication::translate("Ruler", "cm"), millimetresPer(unit)};
            }
            break;
        case LengthUnit::Millimetre:
            if (steps.major < 1000) {
                return {QCoreApplication::translate("Ruler", "mm"), millimetresPer(unit)};
            }
            break;
        case LengthUnit::Decimetre:
        case LengthUnit::Metre:
            break;
    }
    return {QCoreApplication::translate("Ruler", "m"), 1000};
}

QString rulerText(double millimetres, const RulerUnit& unit) {
    const double value = millimetres / unit.millimetres;
    const double finest = value * kFinestFraction;
    if (unit.inFractions && std::abs(finest - std::round(finest)) < 1e-6) {
        return QString::fromStdString(
                   toile::lengthNumber(millimetres, {LengthUnit::Inch, kFinestFraction, "."}))
            .replace('-', kMinus);
    }
    return ungrouped().toString(std::abs(value) < 1e-9 ? 0.0 : value, 'g', 7).replace('-', kMinus);
}

void paintRulers(QPainter& painter, const RenderStyle& style, const QRect& view,
                 const SheetMap& onScreen, const Eigen::AlignedBox2d& visible,
                 double pixelsPerMillimetre, const Eigen::AlignedBox2d& marked) {
    const LengthUnit display = LengthDisplay::instance().format().unit;
    const RulerSteps steps = rulerSteps(pixelsPerMillimetre, display);
    const RulerUnit unit = rulerUnit(steps, display);
    const double width = view.width(), height = view.height();
    painter.save();
    QFont font = painter.font();
    font.setPointSizeF(std::max(6.0, font.pointSizeF() * 0.72));
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    QColor ground = style.bottom, band = style.selection;
    band.setAlpha(60);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillRect(QRectF(0, 0, width, kRulerBreadth), ground);
    painter.fillRect(QRectF(0, 0, kRulerBreadth, height), ground);
    if (!marked.isEmpty()) {
        const QRectF box = onScreen(marked);
        painter.fillRect(QRectF(box.left(), 0, box.width(), kRulerBreadth), band);
        painter.fillRect(QRectF(0, box.top(), kRulerBreadth, box.height()), band);
    }

    const Ticks across = ticksBetween(steps, visible.min().x(), visible.max().x());
    for (long tick = across.first; tick <= across.last; ++tick) {
        const double place = static_cast<double>(tick) * across.step;
        const double x = std::round(onScreen(Eigen::Vector2d(place, 0)).x());
        painter.setPen(style.faintText);
        painter.drawLine(QPointF(x, kRulerBreadth - lengthOf(across, tick)),
                         QPointF(x, kRulerBreadth));
        if (tick % across.perMajor == 0) {
            painter.setPen(style.text);
            painter.drawText(QPointF(x + 3, metrics.ascent()), rulerText(place, unit));
        }
    }
    const Ticks upwards = ticksBetween(steps, visible.min().y(), visible.max().y());
    for (long tick = upwards.first; tick <= upwards.last; ++tick) {
        const double place = static_cast<double>(tick) * upwards.step;
        const double y = std::round(onScreen(Eigen::Vector2d(0, place)).y());
        painter.setPen(style.faintText);
        painter.drawLine(QPointF(kRulerBreadth - lengthOf(upwards, tick), y),
                         QPointF(kRulerBreadth, y));
        if (tick % upwards.perMajor == 0) {
            painter.save();
            painter.translate(metrics.ascent(), y - 3);
            painter.rotate(-90);
            painter.setPen(style.text);
            painter.drawText(QPointF(0, 0), rulerText(place, unit));
            painter.restore();
        }
    }
    const QRectF corner(0, 0, kRulerBreadth, kRulerBreadth);
    painter.fillRect(corner, ground);
    painter.setPen(style.faintText);
    painter.drawText(corner, Qt::AlignCenter, unit.symbol);
    painter.setPen(style.grid);
    painter.drawLine(QPointF(0, kRulerBreadth), QPointF(width, kRulerBreadth));
    painter.drawLine(QPointF(kRulerBreadth, 0), QPointF(kRulerBreadth, height));
    painter.restore();
}

Camera2D::Margins patternMargins(bool rulers) {
    Camera2D::Margins margins = kMargins;
    margins.sides += rulers ? kRulerBreadth : 0;
    margins.top += rulers ? kRulerBreadth : 0;
    return margins;
}

void framePattern(Camera2D& camera, const Scene& scene, const SheetPlaces& places,
                  const std::set<int>& pieces, bool rulers, const Eigen::AlignedBox2d& also) {
    Eigen::AlignedBox2d box = also;
    for (const int piece : pieces) {
        box.extend(placedBox(scene.edgeBoxes[static_cast<std::size_t>(piece)],
                             placeOf(places, piece).placement));
    }
    camera.frame(box, patternMargins(rulers));
}

}  // namespace toile::app
