// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/seam_fit.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <cmath>

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

std::optional<SeamMeasure> measured(const Garment& garment, const PieceResults& results, int seam) {
    const Seam& asked = garment.seams.seams[static_cast<std::size_t>(seam)];
    const auto result = [&results](const SeamSide& side) {
        const auto at = static_cast<std::size_t>(side.piece);
        return at < results.size() ? results[at].get() : nullptr;
    };
    const PieceResult* left = result(asked.left);
    const PieceResult* right = asked.right.piece < 0 ? left : result(asked.right);
    if (!left || !right || !left->flat || !right->flat) {
        return std::nullopt;
    }
    return measureSeam(asked, *left->piece, left->flat->Q, *right->piece, right->flat->Q);
}

SeamFit seamFit(const Seam& seam, const std::optional<SeamMeasure>& measure) {
    if (!measure || seam.kind == SeamKind::Free) {
        return SeamFit::Unknown;
    }
    const double error = std::abs(measure->errorMm);
    return error <= kMatchesMm  ? SeamFit::Matches
           : error <= kNearlyMm ? SeamFit::Nearly
                                : SeamFit::Differs;
}

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
