// SPDX-License-Identifier: GPL-3.0-or-later
#include <QColor>
#include <QFont>
#include <QFontMetrics>
#include <QFontMetricsF>
#include <QImage>
#include <QLinearGradient>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QRectF>
#include <QStringList>
#include <QTextLayout>
#include <algorithm>
#include <cmath>

#include "app/render/colour_map.h"
#include "app/text/figures.h"
#include "app/views/colour_legend.h"

// Layout of the parts of a legend.

namespace toile::app {
namespace {

/// The drawn scale of a legend: the colours from end to end, above them a histogram of the cloth,
/// below them numbers. Logical pixels.
class LegendScale {
public:
    static constexpr int kHistogram = 22;  ///< height above the colours
    static constexpr int kColours = 12;    ///< height of the colours
    /// Hatched end caps beside the colours, and the gap between.
    static constexpr double kCap = 34, kCapGap = 3;

    LegendScale(QPainter& painter, const ColourLegend& legend, const QFont& font,
                const QPalette& palette);

    /// @param bar  the colours; caps go to its sides, numbers below it
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

/// Space per tick label, so that neighbours do not touch.
constexpr double kTickRoom = 42;

QColor colourAt(const ColourMap& map, double place) {
    const Rgb c = map[static_cast<std::size_t>(std::lround(place * (kColourMapSize - 1)))];
    return {c.r, c.g, c.b};
}

/// @param alpha  1: opaque
QColor faded(QColor colour, float alpha) {
    colour.setAlphaF(alpha);
    return colour;
}

/// For titles and the value under the pointer.
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
            // Show even the smallest share.
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
    // Hatched like the cloth: down to the right for surplus, up to the right for stretch.
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

constexpr int kBarMargin = 14;
constexpr int kTop = 7;
constexpr int kFoot = 9;  ///< including the marks between the colours and their numbers
constexpr int kLongestBar = 460;
constexpr int kCornerAir = 10, kCornerGap = 4;
constexpr int kMaxWordLines = 2;   ///< below the title
constexpr double kHighest = 1000;  ///< available height when measuring words
constexpr float kFaint = 0.72F;

/// Breaks words into lines of this width; beyond `kMaxWordLines` the last line ends in "…".
QStringList wordLines(const QString& words, const QFont& font, int width) {
    QStringList lines;
    QTextLayout layout(words, font);
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width);
        if (lines.size() + 1 == kMaxWordLines) {
            lines << QFontMetrics(font).elidedText(words.mid(line.textStart()), Qt::ElideRight,
                                                   width);
            break;
        }
        lines << words.mid(line.textStart(), line.textLength()).trimmed();
    }
    layout.endLayout();
    return lines;
}

class LegendPainter {
public:
    LegendPainter(QPainter& painter, const ColourLegend& legend, const QSize& size,
                  const QFont& font, const QPalette& palette, LegendShape shape)
        : painter_(painter),
          legend_(legend),
          size_(size),
          shape_(shape),
          font_(font),
          strong_(legendTitleFont(font)),
          metrics_(font),
          scale_(painter, legend, font, palette),
          ink_(palette.color(QPalette::WindowText)) {}

    void paint() { shape_ == LegendShape::Row ? paintRow() : paintCorner(); }
    /// Height of words and scale; words without a scale may need more.
    int cornerHeight() const;

private:
    void paintRow();
    void paintCorner();
    QString cornerWords() const;
    /// The lines below the title; none if the words fit next to it.
    QStringList cornerLines() const;
    /// Area of words without a scale, below the title.
    QRectF wordsAlone(double height) const;
    bool saysWordsAlone() const { return legend_.overlay == Overlay::Normal || legend_.isMissing; }
    void paintSquares(const QRectF& area);
    void paintBall(const QRectF& area);
    void paintWords(double left);

    QPainter& painter_;
    const ColourLegend& legend_;
    QSize size_;
    LegendShape shape_;
    QFont font_, strong_;
    QFontMetrics metrics_;
    LegendScale scale_;
    QColor ink_;
};

QString LegendPainter::cornerWords() const {
    const QString share = legend_.shortShare();
    return share.isEmpty() ? legend_.meaning() : share;
}

QStringList LegendPainter::cornerLines() const {
    const double beside = size_.width() - 3.0 * kCornerAir -
                          QFontMetricsF(strong_).horizontalAdvance(legend_.title());
    const QString words = cornerWords();
    if (metrics_.horizontalAdvance(words) <= beside) {
        return {};
    }
    return wordLines(words, font_, std::max(1, size_.width() - 2 * kCornerAir));
}

QRectF LegendPainter::wordsAlone(double height) const {
    const double ball = legendHeight(font_, LegendShape::Corner) - 2 * kCornerAir;
    const double left = kCornerAir + (legend_.overlay == Overlay::Normal ? ball + kCornerAir : 0);
    const double top = kTop + metrics_.height();
    return {left, top, std::max(1.0, size_.width() - left - kCornerAir), height - top - kCornerAir};
}

int LegendPainter::cornerHeight() const {
    const int least = legendHeight(font_, LegendShape::Corner);
    if (!saysWordsAlone()) {
        return least + static_cast<int>(cornerLines().size()) * metrics_.height();
    }
    const QRect words = metrics_.boundingRect(wordsAlone(kHighest).toAlignedRect(),
                                              Qt::AlignTop | Qt::TextWordWrap, legend_.meaning());
    return std::max(least, words.bottom() + 1 + kCornerAir);
}

void LegendPainter::paintCorner() {
    const double line = metrics_.height(), room = size_.width() - 2 * kCornerAir;
    double left = kCornerAir;
    if (saysWordsAlone()) {
        left = wordsAlone(size_.height()).left();
    }
    if (legend_.overlay == Overlay::Normal) {
        const double size = left - 2 * kCornerAir;
        paintBall({kCornerAir, kCornerAir, size, size});
    }
    const QFontMetricsF strong(strong_);
    const QString name =
        strong.elidedText(legend_.title(), Qt::ElideRight, size_.width() - left - kCornerAir);
    painter_.setFont(strong_);
    painter_.setPen(ink_);
    painter_.drawText(QRectF(left, kTop, room, line), Qt::AlignVCenter, name);
    painter_.setFont(font_);
    if (saysWordsAlone()) {
        painter_.setPen(faded(ink_, kFaint));
        painter_.drawText(wordsAlone(size_.height()), Qt::AlignTop | Qt::TextWordWrap,
                          legend_.meaning());
        return;
    }
    painter_.setPen(faded(ink_, kFaint));
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
    const double side = kCornerAir + LegendScale::kCap + LegendScale::kCapGap;
    const QRectF bar(side, size_.height() - LegendScale::kColours - line - kFoot,
                     size_.width() - 2 * side, LegendScale::kColours);
    scale_.paint(bar);
}

void LegendPainter::paintRow() {
    const QFontMetricsF strong(strong_);
    const QString title = legend_.title();

    // Reserve the same width for every title, so that the bar stays put when the overlay changes.
    const double titleWidth =
        std::max(strong.horizontalAdvance(title),
                 strong.horizontalAdvance(ColourLegend{Overlay::Bias}.title()));
    painter_.setFont(strong_);
    painter_.setPen(ink_);
    painter_.drawText(QRectF(kBarMargin, 0, titleWidth + 4, size_.height()), Qt::AlignVCenter,
                      title);
    painter_.setFont(font_);

    const double left = kBarMargin + titleWidth + 28;
    double end = left;
    if (isMeasured(legend_.overlay) && !legend_.isMissing) {
        const double length = std::clamp(size_.width() * 0.36, 160.0, double(kLongestBar));
        const QRectF bar(left + LegendScale::kCap + LegendScale::kCapGap,
                         kTop + LegendScale::kHistogram, length, LegendScale::kColours);
        scale_.paint(bar);
        end = bar.right() + LegendScale::kCapGap + LegendScale::kCap + 30;
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
    const QString share = legend_.markedShareSentence();
    const double line = metrics_.height();
    const double top = (size_.height() - (share.isEmpty() ? line : 2 * line + 2)) / 2;
    const auto write = [&](const QString& text, double y, float alpha) {
        painter_.setPen(faded(ink_, alpha));
        painter_.drawText(QRectF(left, y, room, line), Qt::AlignVCenter,
                          metrics_.elidedText(text, Qt::ElideRight, int(room)));
    };
    write(legend_.meaning(), top, kFaint);
    if (!share.isEmpty()) {
        write(share, top + line + 2, 1.0F);
    }
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

/// Paints a lit ball seen from the garment's front, coloured as in surface.glsl.
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

int legendHeight(const QFont& font, LegendShape shape) {
    const int line = QFontMetrics(font).height();
    const int row = kTop + LegendScale::kHistogram + LegendScale::kColours + line + kFoot;
    return shape == LegendShape::Row ? row : row + line + kCornerGap;
}

int cornerLegendHeight(const ColourLegend& legend, const QFont& font, int width) {
    QImage none(1, 1, QImage::Format_RGB32);
    QPainter painter(&none);
    const LegendPainter measured(painter, legend, {width, 1}, font, {}, LegendShape::Corner);
    return measured.cornerHeight();
}

void paintLegend(QPainter& painter, const ColourLegend& legend, const QSize& size,
                 const QFont& font, const QPalette& palette, LegendShape shape) {
    painter.save();
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    LegendPainter(painter, legend, size, font, palette, shape).paint();
    painter.restore();
}

}  // namespace toile::app
