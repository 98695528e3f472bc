// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/pattern_text.h"

#include <QCoreApplication>
#include <QPainter>
#include <utility>
#include <vector>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/render/picking.h"
#include "app/render/render_style.h"
#include "app/render/scene.h"
#include "app/text/error_text.h"
#include "app/views/flags.h"
#include "app/views/grain_arrow.h"
#include "app/views/name_plates.h"
#include "app/views/ruler.h"
#include "app/views/tool_view.h"
#include "app/views/view_text.h"

namespace toile::app {

namespace {

/// The context of the translations.
class PatternWords {
    Q_DECLARE_TR_FUNCTIONS(PatternView)
};

QString emptyText(const Document& document) {
    if (document.pieceCount() == 0) {
        return {};
    }
    if (document.results().empty()) {
        return PatternWords::tr("The flat pieces appear here.");
    }
    return PatternWords::tr("None of the pieces could be flattened. The list of pieces says why.");
}

void paintNames(QPainter& painter, const RenderStyle& style, const PatternText& text,
                std::vector<QRectF> taken) {
    const Scene& scene = *text.document.scene();
    const SheetMap onScreen(text.camera);
    const DrawingWords words = drawingWords();
    std::vector<NamedPiece> pieces;
    for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
        const PieceScene& piece = scene.pieces[i];
        if (!piece.flat) {
            continue;
        }
        const Placement& placement = placeOf(text.places, static_cast<int>(i)).placement;
        const QString name = QString::fromStdString(text.document.garment()->pieces[i]->name);
        const QString whole =
            placement.mirrored ? PatternWords::tr("%1 · wrong side up").arg(name) : name;
        // Where files have its name, as it lies.
        const PieceMarks& marks =
            text.document.marks().of(text.document, static_cast<int>(i), words);
        pieces.push_back({name, whole.mid(name.size()),
                          onScreen(placement.offset + marks.label.position),
                          onScreen(placedBox(piece.flatBox, placement)),
                          text.document.isSelected(static_cast<int>(i))});
    }
    for (const NamePlate& name : namePlates(painter.font(), pieces, std::move(taken))) {
        paintPlate(painter, style, name.plate, name.text,
                   pieces[static_cast<std::size_t>(name.piece)].selected);
    }
}

/// Whether any cloth lies under a part of the view.
bool isOnCloth(const PatternText& text, const QRectF& part) {
    return anyPointIn(part, [&text](double x, double y) -> bool {
        return pickPattern(*text.document.scene(), text.places, text.camera.toWorld(x, y))
            .has_value();
    });
}

}  // namespace

void paintPatternText(QPainter& painter, const RenderStyle& style, const PatternText& text) {
    const Document& document = text.document;
    const int ruler = document.view().rulers ? kRulerBreadth : 0;
    const QPointF corner(ruler, ruler);
    const QString title = PatternWords::tr("Pattern");
    const QString note = PatternWords::tr("right side of the fabric up, net outlines");
    if (!document.scene() || sheetBox(*document.scene(), text.places).isEmpty()) {
        paintCaption(painter, style, corner, title, note, false);
        painter.setPen(style.faintText);
        painter.drawText(text.view.adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         emptyText(document));
        return;
    }
    const SheetMap onScreen(text.camera);
    const double scale = text.camera.pixelsPerMillimetre();
    const QRectF caption = captionPlate(painter.font(), corner, title, note);
    const std::vector<QRectF> taken{caption,
                                    scaleBarPlate(painter.font(), text.view, scale, ruler)};
    paintGrainArrows(painter, style, onScreen, document, text.strongGrain);
    paintNames(painter, style, text, taken);
    paintSpotFlags(painter, style, {QRectF(text.view.adjusted(ruler, ruler, 0, 0)), taken},
                   document, text.spots, [&text](const WorstSpot& spot) {
                       return placeOfSpot(spot, text.camera, text.places);
                   });
    paintCaption(painter, style, corner, title, note, isOnCloth(text, caption));
    paintScaleBar(painter, style, text.view, scale, ruler);
    if (document.view().rulers) {
        paintRulers(painter, style, text.view, onScreen, text.camera.visible(), scale,
                    boxOnSheet(document, selectedFlat(document)));
    }
}

}  // namespace toile::app
