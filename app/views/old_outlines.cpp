// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/old_outlines.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

#include "app/document/document.h"
#include "app/render/render_style.h"
#include "app/views/tool.h"

namespace toile::app {
namespace {

/// The context of the translations.
class OutlineWords {
    Q_DECLARE_TR_FUNCTIONS(OldOutlines)
};

}  // namespace

void OldOutlines::follow(const Document& document, const SheetPlaces& sheet) {
    if (!document.garment()) {
        outlines_.clear();
        return;
    }
    if (!document.isFlattened()) {
        return;
    }
    outlines_.clear();
    for (int i = 0; i < document.pieceCount(); ++i) {
        const PieceResult* result = document.result(i);
        if (!result || !result->flat || placeOf(sheet, i).hidden) {
            continue;
        }
        const Placement& placement = placeOf(sheet, i).placement;
        Points2 points = result->flat->Q(result->piece->boundary, Eigen::all);
        for (Eigen::Index k = 0; k < points.rows(); ++k) {
            points.row(k) = placement.applied(points.row(k).transpose()).transpose();
        }
        outlines_.push_back({result->piece, std::move(points)});
    }
}

std::vector<const OldOutlines::Outline*> OldOutlines::shown(const Document& document) const {
    std::vector<const Outline*> old;
    if (document.garment() && !document.isFlattened()) {
        for (const Outline& outline : outlines_) {
            if (std::ranges::find(document.garment()->pieces, outline.piece) ==
                document.garment()->pieces.end()) {
                old.push_back(&outline);
            }
        }
    }
    return old;
}

bool OldOutlines::isAny(const Document& document) const {
    return !shown(document).empty();
}

void OldOutlines::paint(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                        const Document& document) const {
    for (const Outline* outline : shown(document)) {
        QPolygonF line;
        for (Eigen::Index k = 0; k < outline->points.rows(); ++k) {
            line << onScreen(Eigen::Vector2d(outline->points.row(k).transpose()));
        }
        QColor pale = style.faintText;
        pale.setAlphaF(0.5F);
        painter.setPen(QPen(pale, 1));
        pale.setAlphaF(0.08F);
        painter.setBrush(pale);
        painter.drawPolygon(line);
        painter.setPen(style.faintText);
        painter.drawText(
            line.boundingRect(), Qt::AlignCenter,
            OutlineWords::tr("%1\nout of date")
                .arg(QString::fromStdString(nameOf(document.state().labels, *outline->piece))));
    }
}

}  // namespace toile::app
