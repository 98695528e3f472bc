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

/// What the colours of an overlay mean, in numbers, how much of the cloth has which, and the value
/// under the pointer: what the colour bar shows and what pictures have below them. A value.
struct ColourLegend {
    Overlay overlay = Overlay::None;
    OverlayScale scale{};
    std::optional<Histogram> histogram{};  ///< of a measured overlay only
    std::optional<double> value{};
    bool isMissing = false;               ///< it is of sewn cloth, and nothing is sewn and measured
    bool isOnItsWay = false;              ///< but it is being sewn
    SewnPattern sewn = SewnPattern::Own;  ///< that it is of

    /// "Strain along warp (%)".
    QString title() const;
    /// What the colours say, or what is to be done first.
    QString meaning() const;

    /// For tests and screen readers: "Strain along warp: −1 % to +2 %; 12 % of the cloth is beyond
    /// the fabric along the warp".
    QString summary() const;
    /// "all of the cloth is within the fabric along the warp": says which strain is counted, for
    /// another direction may say something else. The shares at the ends as they are shown add up to
    /// it. Empty where the fabric has no limits, or nothing is flat yet.
    QString shareSentence() const;
    /// The same where the colours are seen: "(hatched)" follows where any cloth is beyond.
    QString markedShareSentence() const;
    /// The same in few words: "12 % beyond the fabric (hatched)".
    QString shortShare() const;
    /// "+15" and, where cloth lies beyond that is marked by nothing else, "≥ +15".
    QString endLabel(bool high) const;
    /// "12 %": how much of the cloth lies beyond the lower or the higher end; empty where no cloth
    /// has been counted.
    QString endShareText(bool high) const;
    /// "+2.4 %"; empty where there is no value.
    QString valueText() const;
};

/// The legend of these figures: the ends say whether anything that is drawn lies beyond them.
ColourLegend legendOf(const OverlayFigures& figures);

/// How a legend is laid out.
enum class LegendShape {
    Row,     ///< words beside the colours: a strip below the views
    Corner,  ///< words above them, and fewer: in a corner of a view
};

/// How high a legend is, logical pixels.
int legendHeight(const QFont& font, LegendShape shape = LegendShape::Row);
/// How high one of LegendShape::Corner is where it is so wide: words that find no room beside the
/// title stand below it, in two lines at most.
int cornerLegendHeight(const ColourLegend& legend, const QFont& font, int width);

void paintLegend(QPainter& painter, const ColourLegend& legend, const QSize& size,
                 const QFont& font, const QPalette& palette, LegendShape shape = LegendShape::Row);

}  // namespace toile::app
