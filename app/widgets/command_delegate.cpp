// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/command_delegate.h"

#include <QApplication>
#include <QIcon>
#include <QPainter>
#include <QTextLayout>

namespace toile {

namespace {

constexpr int kPad = 10, kIcon = 18, kGap = 14, kAir = 12;

/// The text with marked letters, as far as there is room.
/// @return its width
double paintText(QPainter& painter, const QRectF& place, const QFont& font, const QString& text,
                 const QList<QVariant>& letters) {
    QTextLayout layout(text, font);
    QList<QTextLayout::FormatRange> marks;
    for (const QVariant& letter : letters) {
        QTextLayout::FormatRange mark;
        mark.start = letter.toInt();
        mark.length = 1;
        mark.format.setFontWeight(QFont::Bold);
        marks << mark;
    }
    layout.setFormats(marks);
    layout.beginLayout();
    QTextLine line = layout.createLine();
    layout.endLayout();
    painter.save();
    painter.setClipRect(place);
    layout.draw(&painter, {place.left(), place.center().y() - line.height() / 2});
    painter.restore();
    return line.naturalTextWidth();
}

}  // namespace

void CommandDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
    const bool enabled = index.flags().testFlag(Qt::ItemIsEnabled);
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    const auto group = enabled ? QPalette::Active : QPalette::Disabled;
    const QPalette& palette = option.palette;
    if (selected) {
        painter->fillRect(
            option.rect,
            palette.color(enabled ? QPalette::Active : QPalette::Disabled, QPalette::Highlight));
    }
    const QColor ink = palette.color(group, selected ? QPalette::HighlightedText : QPalette::Text);
    QColor faint = ink;
    faint.setAlphaF(enabled ? 0.66F : 0.9F);

    QRect row = option.rect.adjusted(kPad, 0, -kPad, 0);
    const auto icon = index.data(Qt::DecorationRole).value<QIcon>();
    const QRect iconPlace(row.left(), row.center().y() - kIcon / 2, kIcon, kIcon);
    if (!icon.isNull()) {
        icon.paint(painter, iconPlace, Qt::AlignCenter, enabled ? QIcon::Normal : QIcon::Disabled);
    }
    row.setLeft(iconPlace.right() + kPad);

    painter->setFont(option.font);
    const QString keys = index.data(KeysRole).toString();
    if (!keys.isEmpty()) {
        painter->setPen(faint);
        painter->drawText(row, Qt::AlignRight | Qt::AlignVCenter, keys);
        row.setRight(row.right() - option.fontMetrics.horizontalAdvance(keys) - kGap);
    }
    painter->setPen(ink);
    const double width =
        paintText(*painter, row, option.font, index.data(Qt::DisplayRole).toString(),
                  index.data(LettersRole).toList());
    row.setLeft(row.left() + qRound(width) + kGap);
    if (row.width() > 2 * kGap) {
        painter->setPen(faint);
        painter->drawText(row, Qt::AlignLeft | Qt::AlignVCenter,
                          option.fontMetrics.elidedText(index.data(PlaceRole).toString(),
                                                        Qt::ElideRight, row.width()));
    }
}

QSize CommandDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    return {200, option.fontMetrics.height() + kAir};
}

}  // namespace toile
