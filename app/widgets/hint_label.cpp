// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/hint_label.h"

#include <QPainter>
#include <QStringList>
#include <algorithm>

namespace toile::app {

namespace {

constexpr auto kBetween = " · ";
constexpr auto kAfterKeys = ": ";
const QChar kMore(0x2026);

/// Logical pixels.
constexpr int kKeyPad = 5, kAfterKey = 5, kBetweenClauses = 16;

}  // namespace

std::vector<HintClause> hintClauses(const QString& text) {
    std::vector<HintClause> clauses;
    for (const QString& clause : text.split(QString::fromUtf8(kBetween), Qt::SkipEmptyParts)) {
        const auto end = clause.indexOf(kAfterKeys);
        clauses.push_back(end < 0 ? HintClause{{}, clause}
                                  : HintClause{clause.left(end), clause.mid(end + 2)});
    }
    return clauses;
}

HintLabel::HintLabel(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void HintLabel::setHint(const QString& text) {
    setText(text);
    clauses_ = hintClauses(text);
    QString all = text;
    setToolTip(all.replace(QString::fromUtf8(kBetween), "\n"));
}

int HintLabel::widthOf(const HintClause& clause) const {
    const QFontMetrics metrics = fontMetrics();
    const int keys = clause.keys.isEmpty()
                         ? 0
                         : metrics.horizontalAdvance(clause.keys) + 2 * kKeyPad + kAfterKey;
    return keys + metrics.horizontalAdvance(clause.what);
}

std::size_t HintLabel::fitting(int width) const {
    const int more = kBetweenClauses + fontMetrics().horizontalAdvance(kMore);
    int taken = 0;
    std::size_t count = 0;
    for (; count < std::min(clauses_.size(), kMaxHintsShown); ++count) {
        const int end = taken + widthOf(clauses_[count]);
        const bool isLast = count + 1 == clauses_.size();
        if (end + (isLast ? 0 : more) > width) {
            break;
        }
        taken = end + kBetweenClauses;
    }
    return count;
}

void HintLabel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRect line = contentsRect();
    const std::size_t count = fitting(line.width());
    const QColor ink = palette().color(QPalette::WindowText);
    QColor rim = ink, ground = ink;
    rim.setAlphaF(0.35F);
    ground.setAlphaF(0.06F);
    int left = line.left();
    const auto write = [&](const QString& text) {
        const int width = fontMetrics().horizontalAdvance(text);
        painter.setPen(ink);
        painter.drawText(QRect(left, line.top(), width, line.height()),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, text);
        left += width;
    };
    for (std::size_t k = 0; k < count; ++k) {
        if (!clauses_[k].keys.isEmpty()) {
            const int height = fontMetrics().height() + 2;
            painter.setPen(QPen(rim, 1));
            painter.setBrush(ground);
            painter.drawRoundedRect(
                QRectF(left + 0.5, line.center().y() - height / 2 + 0.5,
                       fontMetrics().horizontalAdvance(clauses_[k].keys) + 2 * kKeyPad, height),
                3, 3);
            left += kKeyPad;
            write(clauses_[k].keys);
            left += kKeyPad + kAfterKey;
        }
        write(clauses_[k].what);
        left += kBetweenClauses;
    }
    if (count == 0 && !clauses_.empty()) {
        painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                         fontMetrics().elidedText(text(), Qt::ElideRight, line.width()));
    } else if (count < clauses_.size()) {
        write(kMore);
    }
}

}  // namespace toile::app
