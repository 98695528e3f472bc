// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QFontMetrics>
#include <QPalette>
#include <QRectF>

class QPainter;

namespace toile::app {

struct ColourLegend;

/// The scale of a legend as it is drawn: the colours from end to end, above them how much cloth has
/// which, below them numbers. Logical pixels.
class LegendScale {
public:
    static constexpr int kHistogram = 22;  ///< height above the colours
    static constexpr int kColours = 12;    ///< height of the colours
    /// Samples of the hatching beside the colours, and the gap between.
    static constexpr double kCap = 34, kCapGap = 3;

    LegendScale(QPainter& painter, const ColourLegend& legend, const QFont& font,
                const QPalette& palette);

    /// @param bar  of the colours; the caps stand beside it, numbers below
    void paint(const QRectF& bar) const;

private:
    bool hasCaps() const;
    double xOf(const QRectF& bar, double value) const;
    void paintHistogram(const QRectF& bar) const;
    void paintColours(const QRectF& bar) const;
    void paintCap(const QRectF& cap, bool high) const;
    void paintTicks(const QRectF& bar) const;
    void paintValue(const QRectF& bar) const;

    QPainter& painter_;
    const ColourLegend& legend_;
    QFont font_;
    QFontMetrics metrics_;
    QColor ink_, ground_;
};

/// A colour that lets through what is below it. @param alpha  1: nothing
QColor faded(QColor colour, float alpha);
/// Of titles and of the value under the pointer.
QFont legendTitleFont(QFont font);

}  // namespace toile::app
