// SPDX-License-Identifier: GPL-3.0-or-later
// Longer than a file mostly is: what each overlay is called and means, what of it is said in words
// and how that is painted belong to one small picture, which pictures without a window draw too.
#include "app/views/colour_legend.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QStringList>
#include <QTextLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/render/colour_map.h"
#include "app/text/figures.h"
#include "app/views/corner_legend.h"

namespace toile::app {

namespace {

/// The context of the translations.
class LegendWords {
    Q_DECLARE_TR_FUNCTIONS(ColourBar)
};

constexpr int kBarMargin = 14;
constexpr int kTop = 7;
constexpr int kHistogramHeight = 22;
constexpr int kBarHeight = 12;
constexpr int kFoot = 9;  ///< with the marks between the colours and their numbers
constexpr int kLongestBar = 460;
constexpr int kCornerAir = 10, kCornerGap = 4;
constexpr int kMostWordLines = 2;  ///< below the title
constexpr float kFaint = 0.72F;
/// Samples of the hatching beside the bar, and the gap between.
constexpr double kCapWidth = 34, kCapGap = 3;
/// Room for the label of a tick, so that neighbours do not touch.
constexpr double kTickRoom = 42;

QColor withAlpha(QColor colour, float alpha) {
    colour.setAlphaF(alpha);
    return colour;
}

QColor colourAt(const ColourMap& map, double place) {
    const Rgb c = map[static_cast<std::size_t>(std::lround(place * (kColourMapSize - 1)))];
    return {c.r, c.g, c.b};
}

/// Whole percents of what lies beyond the ends, such that both ends add up to the whole.
struct EndPercents {
    explicit EndPercents(const Histogram& histogram)
        : all(std::lround(100 * histogram.beyond())),
          below(std::lround(100 * std::min(histogram.below, histogram.above))),
          above(all - below) {
        // Of the two the larger one takes what rounding leaves over.
        if (histogram.below > histogram.above) {
            std::swap(below, above);
        }
    }

    long all, below, above;
};

/// "12 %", and "<1 %" for what is there but rounds to nothing.
QString shareText(double share, long percent) {
    const QString number =
        share > 0 && percent <= 0 ? LegendWords::tr("<1") : QLocale().toString(int(percent));
    return LegendWords::tr("%1 %").arg(number);
}

/// What is said of cloth beyond the fabric, and where there is none.
struct LimitWords {
    Overlay overlay;
    const char *beyond, *within;
};

constexpr LimitWords kLimitWords[] = {
    {Overlay::Warp,
     QT_TRANSLATE_NOOP("ColourBar", "%1 of the cloth is beyond the fabric along the warp"),
     QT_TRANSLATE_NOOP("ColourBar", "all of the cloth is within the fabric along the warp")},
    {Overlay::Weft,
     QT_TRANSLATE_NOOP("ColourBar", "%1 of the cloth is beyond the fabric along the weft"),
     QT_TRANSLATE_NOOP("ColourBar", "all of the cloth is within the fabric along the weft")},
    {Overlay::Bias,
     QT_TRANSLATE_NOOP("ColourBar", "%1 of the cloth is beyond the fabric on the bias"),
     QT_TRANSLATE_NOOP("ColourBar", "all of the cloth is within the fabric on the bias")},
    {Overlay::Strain,
     QT_TRANSLATE_NOOP("ColourBar", "%1 of the cloth has an edge beyond the tightest limit"),
     QT_TRANSLATE_NOOP("ColourBar", "no edge is beyond the tightest limit")},
    {Overlay::Principal,  // and what else is limited
     QT_TRANSLATE_NOOP("ColourBar", "%1 of the cloth is beyond the tightest limit"),
     QT_TRANSLATE_NOOP("ColourBar", "all of the cloth is within the tightest limit")},
};

const LimitWords& limitWords(Overlay overlay) {
    const auto* found = std::ranges::find(kLimitWords, overlay, &LimitWords::overlay);
    return found == std::end(kLimitWords) ? kLimitWords[std::size(kLimitWords) - 1] : *found;
}

QString endLabel(const ColourLegend& legend, bool high) {
    const bool clamped = high ? legend.scale.above : legend.scale.below;
    QString text = overlayNumber(legend.overlay, high ? legend.scale.high : legend.scale.low);
    if (!clamped || legend.scale.limited) {
        return text;
    }
    return (high ? QString(QChar(0x2265)) : QString(QChar(0x2264))) + ' ' + text;
}

/// Words broken into lines of this width; of more than `kMostWordLines` the last ends in "…".
QStringList wordLines(const QString& words, const QFont& font, int width) {
    QStringList lines;
    QTextLayout layout(words, font);
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width);
        if (lines.size() + 1 == kMostWordLines) {
            lines << QFontMetrics(font).elidedText(words.mid(line.textStart()), Qt::ElideRight,
                                                   width);
            break;
        }
        lines << words.mid(line.textStart(), line.textLength()).trimmed();
    }
    layout.endLayout();
    return lines;
}

/// Paints one legend.
class LegendPainter {
public:
    LegendPainter(QPainter& painter, const ColourLegend& legend, const QSize& size,
                  const QFont& font, const QPalette& palette, LegendShape shape)
        : painter_(painter),
          legend_(legend),
          size_(size),
          shape_(shape),
          font_(font),
          metrics_(font),
          ink_(palette.color(QPalette::WindowText)),
          ground_(palette.color(QPalette::Window)) {}

    void paint() { shape_ == LegendShape::Row ? paintRow() : paintCorner(); }
    /// The words of a corner below its title, line by line; none where they fit beside it.
    QStringList cornerLines() const;

private:
    void paintRow();
    void paintCorner();
    QFont strongFont() const;
    QString title() const;
    QString cornerWords() const;
    bool saysWordsAlone() const { return legend_.overlay == Overlay::Normal || legend_.isMissing; }
    bool hasCaps() const { return legend_.scale.limited; }
    double xOf(const QRectF& bar, double value) const {
        return bar.left() + bar.width() * legend_.scale.position(value);
    }
    void paintHistogram(const QRectF& bar);
    void paintBar(const QRectF& bar);
    void paintCap(const QRectF& cap, bool high);
    void paintTicks(const QRectF& bar);
    void paintValue(const QRectF& bar);
    void paintSquares(const QRectF& area);
    void paintBall(const QRectF& area);
    void paintWords(double left);

    QPainter& painter_;
    const ColourLegend& legend_;
    QSize size_;
    LegendShape shape_;
    QFont font_;
    QFontMetrics metrics_;
    QColor ink_, ground_;
};

QFont LegendPainter::strongFont() const {
    QFont strong = font_;
    strong.setWeight(QFont::DemiBold);
    return strong;
}

QString LegendPainter::title() const {
    const OverlayWords what = overlayWords(legend_.overlay);
    return what.unit.isEmpty() ? what.title : LegendWords::tr("%1 (%2)").arg(what.title, what.unit);
}

QString LegendPainter::cornerWords() const {
    const QString share = legend_.shortShare();
    return share.isEmpty() ? legend_.meaning() : share;
}

QStringList LegendPainter::cornerLines() const {
    if (saysWordsAlone()) {
        return {};
    }
    const double beside =
        size_.width() - 3.0 * kCornerAir - QFontMetricsF(strongFont()).horizontalAdvance(title());
    const QString words = cornerWords();
    if (metrics_.horizontalAdvance(words) <= beside) {
        return {};
    }
    return wordLines(words, font_, std::max(1, size_.width() - 2 * kCornerAir));
}

void LegendPainter::paintCorner() {
    const double line = metrics_.height(), room = size_.width() - 2 * kCornerAir;
    double left = kCornerAir;
    if (legend_.overlay == Overlay::Normal) {
        const double size = size_.height() - 2 * kCornerAir;
        paintBall({left, kCornerAir, size, size});
        left += size + kCornerAir;
    }
    const QFontMetricsF strong(strongFont());
    const QString name =
        strong.elidedText(title(), Qt::ElideRight, size_.width() - left - kCornerAir);
    painter_.setFont(strongFont());
    painter_.setPen(ink_);
    painter_.drawText(QRectF(left, kTop, room, line), Qt::AlignVCenter, name);
    painter_.setFont(font_);
    if (saysWordsAlone()) {
        painter_.setPen(withAlpha(ink_, kFaint));
        painter_.drawText(QRectF(left, kTop + line, size_.width() - left - kCornerAir,
                                 size_.height() - kTop - line - kCornerAir),
                          Qt::AlignTop | Qt::TextWordWrap, legend_.meaning());
        return;
    }
    painter_.setPen(withAlpha(ink_, kFaint));
    if (const QStringList lines = cornerLines(); !lines.isEmpty()) {
        for (qsizetype i = 0; i < lines.size(); ++i) {
            painter_.drawText(QRectF(left, kTop + static_cast<double>(i + 1) * line, room, line),
                              Qt::AlignLeft | Qt::AlignVCenter, lines[i]);
        }
    } else {
        const double said = left + strong.horizontalAdvance(name) + kCornerAir;
        painter_.drawText(QRectF(said, kTop, size_.width() - said - kCornerAir, line),
                          Qt::AlignVCenter | Qt::AlignRight, cornerWords());
    }
    const double side = kCornerAir + kCapWidth + kCapGap;
    const QRectF bar(side, size_.height() - kBarHeight - line - kFoot, size_.width() - 2 * side,
                     kBarHeight);
    paintHistogram(bar);
    paintBar(bar);
    paintTicks(bar);
    paintValue(bar);
}

void LegendPainter::paintRow() {
    const QFont strong = strongFont();
    const QFontMetricsF strongMetrics(strong);
    const QString title = this->title();

    // Every title gets the same room, so that the bar keeps its place when the overlay changes.
    const double titleWidth =
        std::max(strongMetrics.horizontalAdvance(title),
                 strongMetrics.horizontalAdvance(LegendWords::tr("Strain on the bias (%)")));
    painter_.setFont(strong);
    painter_.setPen(ink_);
    painter_.drawText(QRectF(kBarMargin, 0, titleWidth + 4, size_.height()), Qt::AlignVCenter,
                      title);
    painter_.setFont(font_);

    const double left = kBarMargin + titleWidth + 28;
    double end = left;
    if (isMeasured(legend_.overlay) && !legend_.isMissing) {
        const double length = std::clamp(size_.width() * 0.36, 160.0, double(kLongestBar));
        const QRectF bar(left + kCapWidth + kCapGap, kTop + kHistogramHeight, length, kBarHeight);
        paintHistogram(bar);
        paintBar(bar);
        paintTicks(bar);
        paintValue(bar);
        end = bar.right() + kCapGap + kCapWidth + 30;
    } else if (legend_.overlay == Overlay::Checker) {
        const QRectF area(left, (size_.height() - 16) / 2.0, 32, 16);
        paintSquares(area);
        end = area.right() + 12;
    } else if (legend_.overlay == Overlay::Normal) {
        const double size = std::min(40.0, size_.height() - 8.0);
        const QRectF area(left, (size_.height() - size) / 2, size, size);
        paintBall(area);
        end = area.right() + 12;
    }
    paintWords(end);
}

void LegendPainter::paintWords(double left) {
    const double room = size_.width() - left - kBarMargin;
    if (room < 20) {
        return;
    }
    const QString share = legend_.shareSentence();
    const double line = metrics_.height();
    const double top = (size_.height() - (share.isEmpty() ? line : 2 * line + 2)) / 2;
    const auto write = [&](const QString& text, double y, float alpha) {
        painter_.setPen(withAlpha(ink_, alpha));
        painter_.drawText(QRectF(left, y, room, line), Qt::AlignVCenter,
                          metrics_.elidedText(text, Qt::ElideRight, int(room)));
    };
    write(legend_.meaning(), top, kFaint);
    if (!share.isEmpty()) {
        const QString hatched =
            legend_.histogram->beyond() > 0 ? LegendWords::tr("%1 (hatched)").arg(share) : share;
        write(hatched, top + line + 2, 1.0F);
    }
}

void LegendPainter::paintHistogram(const QRectF& bar) {
    if (!legend_.histogram || legend_.histogram->tallest() <= 0) {
        return;
    }
    const double step = bar.width() / kHistogramBins;
    const double highest = kHistogramHeight - 3;
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
    painter_.fillPath(columns, withAlpha(ink_, 0.42F));
}

void LegendPainter::paintBar(const QRectF& bar) {
    const ColourMap& map = colourMap(legend_.overlay);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int kStops = 64;
    for (int i = 0; i <= kStops; ++i) {
        const double place = i / double(kStops);
        const double value = legend_.scale.low + (legend_.scale.high - legend_.scale.low) * place;
        gradient.setColorAt(place, colourAt(map, legend_.scale.shade(value)));
    }
    painter_.setPen(QPen(withAlpha(ink_, 0.35F), 1));
    painter_.setBrush(gradient);
    painter_.drawRect(bar);
    if (hasCaps()) {
        paintCap({bar.left() - kCapGap - kCapWidth, bar.top(), kCapWidth, bar.height()}, false);
        paintCap({bar.right() + kCapGap, bar.top(), kCapWidth, bar.height()}, true);
    }
}

void LegendPainter::paintCap(const QRectF& cap, bool high) {
    // Striped as the cloth is: down to the right for surplus, up to the right for stretch.
    painter_.save();
    painter_.setPen(QPen(withAlpha(ink_, 0.35F), 1));
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
        painter_.setPen(withAlpha(ink_, share > 0 ? 1.0F : 0.5F));
        painter_.drawText(
            QRectF(cap.center().x() - 40, cap.top() - 3 - metrics_.height(), 80, metrics_.height()),
            Qt::AlignHCenter | Qt::AlignBottom, legend_.endShareText(high));
    }
}

void LegendPainter::paintTicks(const QRectF& bar) {
    const auto tick = [&](double value, const QString& text) {
        const double x = xOf(bar, value);
        painter_.setPen(QPen(withAlpha(ink_, 0.5F), 1));
        painter_.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 3));
        painter_.setPen(ink_);
        painter_.drawText(QRectF(x - 60, bar.bottom() + 4, 120, metrics_.height()),
                          Qt::AlignHCenter, text);
    };
    tick(legend_.scale.low, endLabel(legend_, false));
    tick(legend_.scale.high, endLabel(legend_, true));
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

void LegendPainter::paintValue(const QRectF& bar) {
    const QString text = legend_.valueText();
    if (text.isEmpty()) {
        return;
    }
    const bool beyond = hasCaps() && legend_.scale.severity(*legend_.value) > 1;
    const double x = !beyond                               ? xOf(bar, *legend_.value)
                     : *legend_.value > legend_.scale.high ? bar.right() + kCapGap + kCapWidth / 2
                                                           : bar.left() - kCapGap - kCapWidth / 2;
    QPainterPath mark;
    mark.addPolygon(
        QPolygonF({{x - 4.5, bar.top() - 7}, {x + 4.5, bar.top() - 7}, {x, bar.top()}}));
    mark.closeSubpath();
    painter_.fillPath(mark, ink_);
    painter_.fillRect(QRectF(x - 0.75, bar.top(), 1.5, bar.height()), ink_);

    const QFont strong = strongFont();
    const QFontMetricsF metrics(strong);
    const double width = metrics.horizontalAdvance(text) + 10;
    QRectF box(x - width / 2, bar.top() - 8 - metrics.height(), width, metrics.height());
    box.moveTop(std::max(1.0, box.top()));
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(withAlpha(ground_, 0.92F));
    painter_.drawRoundedRect(box, 3, 3);
    painter_.setFont(strong);
    painter_.setPen(ink_);
    painter_.drawText(box, Qt::AlignCenter, text);
    painter_.setFont(font_);
}

void LegendPainter::paintSquares(const QRectF& area) {
    const Rgb cloth = pieceColour(0);
    const QColor dark = QColor(cloth.r, cloth.g, cloth.b).darker(120);
    const QColor light = QColor(cloth.r, cloth.g, cloth.b).lighter(145);
    const double side = area.height() / 2;
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 4; ++column) {
            painter_.fillRect(
                QRectF(area.left() + column * side, area.top() + row * side, side, side),
                (row + column) % 2 == 0 ? dark : light);
        }
    }
}

/// What faces the eye of a ball, seen from the garment's front: as in surface.glsl.
void LegendPainter::paintBall(const QRectF& area) {
    constexpr int kSize = 128;
    QImage ball(kSize, kSize, QImage::Format_ARGB32_Premultiplied);
    ball.fill(Qt::transparent);
    for (int row = 0; row < kSize; ++row) {
        for (int column = 0; column < kSize; ++column) {
            const double x = (2 * column + 1.0) / kSize - 1, y = 1 - (2 * row + 1.0) / kSize;
            if (const double rest = 1 - x * x - y * y; rest >= 0) {
                ball.setPixelColor(
                    column, row,
                    QColor::fromRgbF(static_cast<float>(0.5 + 0.5 * x),
                                     static_cast<float>(0.5 + 0.5 * y),
                                     static_cast<float>(0.5 + 0.5 * std::sqrt(rest))));
            }
        }
    }
    painter_.setRenderHint(QPainter::SmoothPixmapTransform);
    painter_.drawImage(area, ball);
}

}  // namespace

QString ColourLegend::meaning() const {
    if (isMissing) {
        return isOnItsWay
                   ? LegendWords::tr("it is being sewn")
                   : LegendWords::tr("not sewn yet, or since the last change: prove it by sewing");
    }
    QString meaning = overlayWords(overlay).meaning;
    switch (sewn) {
        case SewnPattern::Own:
            break;
        case SewnPattern::Designer:
            return LegendWords::tr("of the designer's panels · %1").arg(meaning);
        case SewnPattern::Reference:
            return LegendWords::tr("of the reference pattern · %1").arg(meaning);
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
    const LimitWords& words = limitWords(overlay);
    return share > 0
               ? LegendWords::tr(words.beyond).arg(shareText(share, EndPercents(*histogram).all))
               : LegendWords::tr(words.within);
}

QString ColourLegend::shortShare() const {
    if (shareSentence().isEmpty()) {
        return {};
    }
    const double share = histogram->beyond();
    return share > 0 ? LegendWords::tr("%1 beyond the fabric (hatched)")
                           .arg(shareText(share, EndPercents(*histogram).all))
                     : LegendWords::tr("all within the fabric");
}

QString ColourLegend::summary() const {
    const OverlayWords what = overlayWords(overlay);
    if (!isMeasured(overlay)) {
        return what.title + ": " + what.meaning;
    }
    const QString unit = what.unit.isEmpty() ? QString() : ' ' + what.unit;
    const QString range = LegendWords::tr("%1: %2%4 to %3%4")
                              .arg(what.title, endLabel(*this, false), endLabel(*this, true), unit);
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
    if (figures.histogram) {  // of what is drawn, which may reach farther than the vertices
        legend.scale.below = figures.histogram->below > 0;
        legend.scale.above = figures.histogram->above > 0;
    }
    return legend;
}

int legendHeight(const QFont& font, LegendShape shape) {
    const int line = QFontMetrics(font).height();
    const int row = kTop + kHistogramHeight + kBarHeight + line + kFoot;
    return shape == LegendShape::Row ? row : row + line + kCornerGap;
}

int cornerLegendHeight(const ColourLegend& legend, const QFont& font, int width) {
    const int height = legendHeight(font, LegendShape::Corner);
    QImage none(1, 1, QImage::Format_RGB32);
    QPainter painter(&none);
    const LegendPainter measured(painter, legend, {width, height}, font, {}, LegendShape::Corner);
    return height + static_cast<int>(measured.cornerLines().size()) * QFontMetrics(font).height();
}

void paintLegend(QPainter& painter, const ColourLegend& legend, const QSize& size,
                 const QFont& font, const QPalette& palette, LegendShape shape) {
    painter.save();
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    LegendPainter(painter, legend, size, font, palette, shape).paint();
    painter.restore();
}

}  // namespace toile::app
