// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPalette>
#include <QRectF>
#include <QString>
#include <optional>

#include "app/render/overlay_figures.h"
#include "core/prove/proof_settings.h"

class QPainter;

namespace toile::app {

/// Legend of an overlay: colour scale in numbers, share of the cloth per colour, and the value
/// under the pointer. Shown by the colour bar and below pictures. A value type.
struct ColourLegend {
    Overlay overlay = Overlay::None;
    OverlayScale scale{};
    std::optional<Histogram> histogram{};  ///< of a measured overlay only
    std::optional<double> value{};
    bool isMissing = false;               ///< shows sewn cloth, but none is sewn and measured yet
    bool isOnItsWay = false;              ///< is being sewn now
    SewnPattern sewn = SewnPattern::Own;  ///< the sewn pattern shown

    /// "Strain along warp (%)".
    QString title() const;
    /// What the colours mean, or what to do first.
    QString meaning() const;

    /// Text for tests and screen readers: "Strain along warp: −1 % to +2 %; 12 % of the cloth is
    /// beyond the fabric along the warp".
    QString summary() const;
    /// "all cloth is within the warp limits". Names the counted strain, because
    /// other directions can differ. Equals the sum of the displayed end shares. Empty if the fabric
    /// has no limits or nothing is flat yet.
    QString shareSentence() const;
    /// The same for a visible legend: adds "(hatched)" if any cloth is beyond the limits.
    QString markedShareSentence() const;
    /// Short form: "12 % beyond the fabric (hatched)".
    QString shortShare() const;
    /// "+15", or "≥ +15" if cloth lies beyond and nothing else marks it.
    QString endLabel(bool high) const;
    /// "12 %": share of the cloth beyond the lower or higher end; empty if no cloth was counted.
    QString endShareText(bool high) const;
    /// "+2.4 %"; empty without a value.
    QString valueText() const;
};

/// Makes the legend of these figures; its ends tell whether drawn values lie beyond them.
ColourLegend legendOf(const OverlayFigures& figures);

/// Layout of a legend.
enum class LegendShape {
    Row,     ///< words beside the colours, for a strip below the views
    Corner,  ///< fewer words, above the colours, for a corner of a view
};

/// Height of a legend, logical pixels.
int legendHeight(const QFont& font, LegendShape shape = LegendShape::Row);
/// Height of a LegendShape::Corner legend of this width: words that do not fit beside the title go
/// below it, in at most two lines.
int cornerLegendHeight(const ColourLegend& legend, const QFont& font, int width);

void paintLegend(QPainter& painter, const ColourLegend& legend, const QSize& size,
                 const QFont& font, const QPalette& palette, LegendShape shape = LegendShape::Row);

}  // namespace toile::app
