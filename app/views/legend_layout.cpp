// SPDX-License-Identifier: GPL-3.0-or-later
// Where the parts of a legend go.
#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QStringList>
#include <QTextLayout>
#include <algorithm>
#include <cmath>

#include "app/render/colour_map.h"
#include "app/views/colour_legend.h"
#include "app/views/legend_scale.h"

namespace toile::app {
namespace {

constexpr int kBarMargin = 14;
constexpr int kTop = 7;
constexpr int kFoot = 9;  ///< with the marks between the colours and their numbers
constexpr int kLongestBar = 460;
constexpr int kCornerAir = 10, kCornerGap = 4;
constexpr int kMostWordLines = 2;  ///< below the title
constexpr double kHighest = 1000;  ///< that words are measured in
constexpr float kFaint = 0.72F;

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
          strong_(legendTitleFont(font)),
          metrics_(font),
          scale_(painter, legend, font, palette),
          ink_(palette.color(QPalette::WindowText)) {}

    void paint() { shape_ == LegendShape::Row ? paintRow() : paintCorner(); }
    /// That words and scale need; those that stand alone grow beyond.
    int cornerHeight() const;

private:
    void paintRow();
    void paintCorner();
    QString cornerWords() const;
    /// The words below the title, line by line; none where they fit beside it.
    QStringList cornerLines() const;
    /// Of words that stand alone, below the title.
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

    // Every title gets the same room, so that the bar keeps its place when the overlay changes.
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
