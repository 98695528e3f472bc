// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/fold_line.h"

#include <QCoreApplication>
#include <QLineF>
#include <QPainter>
#include <QPen>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/document/piece_edits.h"
#include "app/render/render_style.h"
#include "app/views/tool.h"
#include "app/views/view_text.h"
#include "core/pattern/half_pattern.h"

namespace toile::app {
namespace {

constexpr double kFoldWidth = 1.6, kFoldHalo = 1.8;  // pixels
constexpr double kFoldWordAt = 0.2;     // of the fold, beside the piece's name at its middle
constexpr double kRoomForFoldWord = 3;  // of the word's height

}  // namespace

std::vector<QRectF> paintFolds(QPainter& painter, const RenderStyle& style,
                               const SheetMap& onScreen, const Document& document) {
    const QString word = QCoreApplication::translate("PatternView", "fold");
    const QSizeF size = labelSize(painter.font(), word, false);
    std::vector<QRectF> words;
    painter.save();
    for (int piece = 0; piece < document.pieceCount(); ++piece) {
        if (cutAsOf(document, piece) != CutAs::OnFold || isHidden(document, piece)) {
            continue;
        }
        const Placement placement = placementOf(document, piece);
        const Chord fold = foldOf(*document.patternPiece(piece));
        const QLineF line(onScreen(placement.applied(fold.from)),
                          onScreen(placement.applied(fold.to)));
        painter.setPen(QPen(style.labelFill, kFoldWidth + kFoldHalo));
        painter.drawLine(line);
        painter.setPen(QPen(style.text, kFoldWidth, Qt::DashDotLine, Qt::FlatCap));
        painter.drawLine(line);
        if (line.length() > kRoomForFoldWord * size.height()) {
            QRectF box(QPointF(), size);
            box.moveCenter(line.pointAt(kFoldWordAt));
            words.push_back(box);
            paintLabel(painter, style, box, word, false);
        }
    }
    painter.restore();
    return words;
}

}  // namespace toile::app
