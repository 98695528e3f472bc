// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/hint_label.h"

#include <QPainter>
#include <QStringList>

namespace toile::app {

namespace {

constexpr auto kBetween = " · ";
constexpr auto kMore = " …";

}  // namespace

QString fittingClauses(const QString& text, const QFontMetrics& metrics, int width) {
    if (metrics.horizontalAdvance(text) <= width) {
        return text;
    }
    QStringList clauses = text.split(QString::fromUtf8(kBetween));
    while (clauses.size() > 1) {
        clauses.removeLast();
        QString shorter = clauses.join(QString::fromUtf8(kBetween)) + QString::fromUtf8(kMore);
        if (metrics.horizontalAdvance(shorter) <= width) {
            return shorter;
        }
    }
    return metrics.elidedText(clauses.first(), Qt::ElideRight, width);
}

HintLabel::HintLabel(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void HintLabel::setHint(const QString& text) {
    setText(text);
    setToolTip(text);
}

void HintLabel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRect line = contentsRect();
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                     fittingClauses(text(), fontMetrics(), line.width()));
}

}  // namespace toile::app
