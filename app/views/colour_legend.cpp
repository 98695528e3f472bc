// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/colour_legend.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/base/text.h"
#include "app/text/figures.h"

namespace toile::app {
namespace {

/// Translation context.
class LegendWords {
    Q_DECLARE_TR_FUNCTIONS(ColourBar)
};

/// Whole percentages of the cloth beyond each end; together they add up to the rounded total.
struct EndPercents {
    explicit EndPercents(const Histogram& histogram)
        : all(std::lround(100 * histogram.beyond())),
          below(std::lround(100 * std::min(histogram.below, histogram.above))),
          above(all - below) {
        // The larger share absorbs the rounding.
        if (histogram.below > histogram.above) {
            std::swap(below, above);
        }
    }

    long all, below, above;
};

/// "12 %", or "<1 %" for a positive share that rounds to zero.
QString shareText(double share, long percent) {
    const QString number =
        share > 0 && percent <= 0 ? LegendWords::tr("<1") : QLocale().toString(int(percent));
    return LegendWords::tr("%1 %").arg(number);
}

const char* limitSentence(Overlay overlay, bool isBeyond) {
    const char* own = isBeyond ? traits(overlay).beyond : traits(overlay).within;
    return own        ? own
           : isBeyond ? TR("%1 of the cloth exceeds the tightest limit")
                      : TR("all cloth is within the tightest limit");
}

}  // namespace

QString ColourLegend::title() const {
    const OverlayWords what = overlayWords(overlay);
    return what.unit.isEmpty() ? what.title : LegendWords::tr("%1 (%2)").arg(what.title, what.unit);
}

QString ColourLegend::endLabel(bool high) const {
    const bool clamped = high ? scale.above : scale.below;
    QString text = overlayNumber(overlay, high ? scale.high : scale.low);
    if (!clamped || scale.limited) {
        return text;
    }
    return (high ? QString(QChar(0x2265)) : QString(QChar(0x2264))) + ' ' + text;
}

QString ColourLegend::meaning() const {
    if (isMissing) {
        return isOnItsWay ? LegendWords::tr("sewing in progress")
                          : LegendWords::tr("no current proof; prove by sewing first");
    }
    QString meaning = overlayWords(overlay).meaning;
    switch (sewn) {
        case SewnPattern::Own:
            break;
        case SewnPattern::Designer:
            return LegendWords::tr("designer's panels · %1").arg(meaning);
        case SewnPattern::Reference:
            return LegendWords::tr("reference pattern · %1").arg(meaning);
    }
    return meaning;
}

QString ColourLegend::valueText() const {
    return value && isMeasured(overlay) ? overlayValueText(overlay, *value) : QString();
}

QString ColourLegend::endShareText(bool high) const {
    if (!histogram || histogram->isEmpty()) {
        return {};
    }
    const EndPercents percents(*histogram);
    return high ? shareText(histogram->above, percents.above)
                : shareText(histogram->below, percents.below);
}

QString ColourLegend::shareSentence() const {
    if (!scale.limited || !histogram || histogram->isEmpty()) {
        return {};
    }
    const double share = histogram->beyond();
    const QString sentence = tr(limitSentence(overlay, share > 0));
    return share > 0 ? sentence.arg(shareText(share, EndPercents(*histogram).all)) : sentence;
}

QString ColourLegend::markedShareSentence() const {
    const QString share = shareSentence();
    return !share.isEmpty() && histogram->beyond() > 0 ? LegendWords::tr("%1 (hatched)").arg(share)
                                                       : share;
}

QString ColourLegend::shortShare() const {
    if (shareSentence().isEmpty()) {
        return {};
    }
    const double share = histogram->beyond();
    return share > 0 ? LegendWords::tr("%1 beyond the limits (hatched)")
                           .arg(shareText(share, EndPercents(*histogram).all))
                     : LegendWords::tr("all within the limits");
}

QString ColourLegend::summary() const {
    const OverlayWords what = overlayWords(overlay);
    if (!isMeasured(overlay)) {
        return what.title + ": " + what.meaning;
    }
    const QString unit = what.unit.isEmpty() ? QString() : ' ' + what.unit;
    const QString range =
        LegendWords::tr("%1: %2%4 to %3%4").arg(what.title, endLabel(false), endLabel(true), unit);
    const QString share = shareSentence();
    if (isMissing) {
        return LegendWords::tr("%1; %2").arg(what.title, meaning());
    }
    if (sewn != SewnPattern::Own) {
        return LegendWords::tr("%1; %2").arg(range, meaning());
    }
    return share.isEmpty() ? range : LegendWords::tr("%1; %2").arg(range, share);
}

ColourLegend legendOf(const OverlayFigures& figures) {
    ColourLegend legend{figures.overlay, figures.scale, figures.histogram, std::nullopt};
    legend.isMissing = isOfProof(figures.overlay) && !(figures.sewn && figures.sewn->isMeasured);
    legend.isOnItsWay = legend.isMissing && figures.sewn;
    legend.sewn = figures.sewn ? figures.sewn->of : SewnPattern::Own;
    if (figures.histogram) {  // drawn values can exceed those at the vertices
        legend.scale.below = figures.histogram->below > 0;
        legend.scale.above = figures.histogram->above > 0;
    }
    return legend;
}

}  // namespace toile::app
