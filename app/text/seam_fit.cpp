// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/seam_fit.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

namespace toile {

namespace {

constexpr int kMarkPixels = 32;

void paintMark(QPainter& painter, SeamFit fit) {
    QPainterPath shape, sign;
    switch (fit) {
        case SeamFit::Unknown:
            return;
        case SeamFit::Matches:
            shape.addEllipse(QRectF(3, 3, 26, 26));
            sign.moveTo(9.5, 16.5);
            sign.lineTo(14, 21);
            sign.lineTo(22.5, 11);
            break;
        case SeamFit::Nearly:
            shape.addPolygon(QPolygonF({{16, 3}, {30, 28}, {2, 28}, {16, 3}}));
            sign.moveTo(16, 12);
            sign.lineTo(16, 19);
            sign.moveTo(16, 23.7);
            sign.lineTo(16, 24.3);
            break;
        case SeamFit::Differs:
            shape.addRoundedRect(QRectF(4, 4, 24, 24), 4, 4);
            sign.moveTo(11, 11);
            sign.lineTo(21, 21);
            sign.moveTo(21, 11);
            sign.lineTo(11, 21);
            break;
    }
    painter.fillPath(shape, fitColour(fit));
    const QColor ink = fit == SeamFit::Nearly ? QColor(40, 28, 0) : QColor(255, 255, 255);
    painter.strokePath(sign, QPen(ink, 3.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

}  // namespace

QString fitWord(SeamFit fit) {
    switch (fit) {
        case SeamFit::Unknown:
            return {};
        case SeamFit::Matches:
            return QCoreApplication::translate("SeamFit", "matches");
        case SeamFit::Nearly:
            return QCoreApplication::translate("SeamFit", "nearly");
        case SeamFit::Differs:
            return QCoreApplication::translate("SeamFit", "does not match");
    }
    return {};
}

QColor fitColour(SeamFit fit) {
    switch (fit) {
        case SeamFit::Unknown:
            return {};
        case SeamFit::Matches:
            return {0, 146, 106};
        case SeamFit::Nearly:
            return {240, 170, 20};
        case SeamFit::Differs:
            return {196, 36, 36};
    }
    return {};
}

QIcon fitMark(SeamFit fit) {
    QPixmap pixmap(kMarkPixels, kMarkPixels);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    paintMark(painter, fit);
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);  // not tinted in a selected row
    return icon;
}

}  // namespace toile
