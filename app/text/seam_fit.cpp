// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/seam_fit.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "app/text/figures.h"

namespace toile::app {

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

struct SeamCounts {
    int seams = 0, measured = 0, nearly = 0, differ = 0;
    double worst = 0;  ///< mm
};

SeamCounts countsOf(const SeamGraph& graph,
                    const std::vector<std::optional<SeamMeasure>>& measures) {
    SeamCounts counts;
    for (std::size_t i = 0; i < measures.size(); ++i) {
        if (graph.seams[i].kind == SeamKind::Free) {
            continue;
        }
        ++counts.seams;
        if (measures[i]) {
            ++counts.measured;
            counts.worst = std::max(counts.worst, std::abs(measures[i]->errorMm));
        }
        const SeamFit fit = seamFit(graph.seams[i], measures[i]);
        counts.nearly += fit == SeamFit::Nearly;
        counts.differ += fit == SeamFit::Differs;
    }
    return counts;
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

QIcon paintedMark(const std::function<void(QPainter&)>& paint) {
    QPixmap pixmap(kMarkPixels, kMarkPixels);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(painter);
    painter.end();
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

QIcon fitMark(SeamFit fit) {
    return paintedMark([fit](QPainter& painter) { paintMark(painter, fit); });
}

QString seamSummary(const SeamGraph& graph,
                    const std::vector<std::optional<SeamMeasure>>& measures) {
    const SeamCounts counts = countsOf(graph, measures);
    if (counts.seams == 0) {
        return {};
    }
    QStringList parts = {counts.seams == 1 ? tr("1 seam") : tr("%1 seams").arg(counts.seams)};
    if (counts.measured == 0) {
        parts << tr("not measured yet");
        return parts.join(QString::fromUtf8(" · "));
    }
    if (counts.differ > 0) {
        parts << (counts.differ == 1 ? tr("1 does not match")
                                     : tr("%1 do not match").arg(counts.differ));
    }
    if (counts.nearly > 0) {
        parts << (counts.nearly == 1 ? tr("1 nearly matches")
                                     : tr("%1 nearly match").arg(counts.nearly));
    }
    parts << tr("worst %1 %2").arg(fineLength(counts.worst), lengthUnit());
    if (counts.measured < counts.seams) {
        parts << tr("%1 not measured: a piece is not flat").arg(counts.seams - counts.measured);
    }
    return parts.join(QString::fromUtf8(" · "));
}

}  // namespace toile::app
