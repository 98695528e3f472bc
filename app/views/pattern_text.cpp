// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/pattern_text.h"

#include <QCoreApplication>
#include <QLineF>
#include <QPainter>
#include <QPen>
#include <QPolygonF>
#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/document/piece_edits.h"
#include "app/render/picking.h"
#include "app/render/render_style.h"
#include "app/render/scene.h"
#include "app/text/error_text.h"
#include "app/views/callouts.h"
#include "app/views/grain_arrow.h"
#include "app/views/name_labels.h"
#include "app/views/ruler.h"
#include "app/views/tool.h"
#include "app/views/view_text.h"
#include "core/pattern/half_pattern.h"

namespace toile::app {
namespace {

constexpr double kFoldWidth = 1.6, kFoldHalo = 1.8;  // pixels
constexpr double kFoldWordAt = 0.2;     // share of the fold; its middle has the piece's name
constexpr double kRoomForFoldWord = 3;  // of the word's height

/// Paints the fold line of every piece stored as a half: dash-dotted over the whole piece, with the
/// word "fold".
/// @return the areas of the words, logical pixels
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

/// Translation context.
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
    if (std::ranges::find(document.results(), nullptr) != document.results().end()) {
        return PatternWords::tr("The pieces have changed and are not flattened yet.");
    }
    return PatternWords::tr("No piece could be flattened. See the list of pieces for the reasons.");
}

/// Collects a piece's name, cloth outline and bounding box on the screen.
NamedPiece namedPiece(const PatternText& text, int piece, const SheetMap& onScreen,
                      const DrawingWords& words) {
    const Document& document = text.document;
    const PatternPiece& flat = *document.patternPiece(piece);
    const Placement& placement = placeOf(text.places, piece).placement;
    NamedPiece named;
    named.name = pieceName(document, piece);
    if (placement.mirrored) {
        named.note = PatternWords::tr("%1 · wrong side up").arg(QString());
    }
    if (cutAsOf(document, piece) == CutAs::Image) {
        named.note = PatternWords::tr("%1 · cut with %2")
                         .arg(named.note, pieceName(document, flat.mirror.counterpart));
    }
    // At the label position from the files.
    const PieceMarks& marks = document.marks().of(document, piece, words);
    named.at = onScreen(placement.offset + marks.label.position);
    for (Eigen::Index i = 0; i < flat.outline.rows(); ++i) {
        named.outline << onScreen(placement.applied(flat.outline.row(i).transpose()));
    }
    const Scene& scene = *document.scene();
    const auto at = static_cast<std::size_t>(piece);
    named.box = onScreen(placedBox(
        document.view().cuttingLine ? scene.edgeBoxes[at] : scene.pieces[at].flatBox, placement));
    named.selected = document.isSelected(piece);
    return named;
}

/// @return the placed names; valid until the next call
const std::vector<NameLabel>& paintNames(QPainter& painter, const RenderStyle& style,
                                         const PatternText& text, NameRoom room,
                                         const std::vector<DrawnArrow>& arrows) {
    const Scene& scene = *text.document.scene();
    const SheetMap onScreen(text.camera);
    const DrawingWords words = drawingWords();
    std::vector<NamedPiece> pieces;
    for (int piece = 0; piece < static_cast<int>(scene.pieces.size()); ++piece) {
        if (scene.pieces[static_cast<std::size_t>(piece)].flat &&
            !placeOf(text.places, piece).hidden && text.document.patternPiece(piece)) {
            pieces.push_back(namedPiece(text, piece, onScreen, words));
            const auto arrow = std::ranges::find(arrows, piece, &DrawnArrow::piece);
            if (arrow != arrows.end()) {
                pieces.back().arrow = arrow->line;
            }
        }
    }
    for (const DrawnArrow& arrow : arrows) {
        room.arrows.push_back(arrow.line);
    }
    const std::vector<NameLabel>& names = text.names.of(painter.font(), pieces, std::move(room));
    for (const NameLabel& name : names) {
        paintNameLabel(painter, style, name, pieces[static_cast<std::size_t>(name.piece)].selected);
    }
    return names;
}

/// The outlines and cutting lines of the visible pieces.
std::vector<QPolygonF> linesOf(const PatternText& text, const SheetMap& onScreen) {
    const Scene& scene = *text.document.scene();
    std::vector<QPolygonF> drawn;
    for (const auto* runs : {&scene.patternLines.outlines, &scene.patternLines.cutting}) {
        for (const VertexRun& run : *runs) {
            QPolygonF line;
            for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
                const LineVertex& vertex = scene.lineVertices[i];
                const SheetPlace& place = placeOf(text.places, static_cast<int>(vertex.piece));
                if (!place.hidden) {
                    line << onScreen(place.placement.applied(flatPoint(vertex)));
                }
            }
            drawn.push_back(std::move(line));
        }
    }
    return drawn;
}

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
    const bool isCut = document.scene() && document.view().cuttingLine &&
                       !document.scene()->patternLines.cutting.empty();
    const QString note =
        isCut ? PatternWords::tr("right side of the fabric up, cutting and seam lines")
              : PatternWords::tr("right side of the fabric up, seam lines");
    if (!document.scene() || sheetBox(*document.scene(), text.places).isEmpty()) {
        paintCaption(painter, style, corner, title, note, false);
        painter.setPen(style.faintText);
        if (!text.isElse) {
            painter.drawText(text.view.adjusted(24, 24, -24, -24),
                             Qt::AlignCenter | Qt::TextWordWrap, emptyText(document));
        }
        return;
    }
    const SheetMap onScreen(text.camera);
    const double scale = text.camera.pixelsPerMillimetre();
    const QRectF caption = captionBox(painter.font(), corner, title, note);
    std::vector<QRectF> taken = text.covered;
    taken.push_back(caption);
    taken.push_back(scaleBarBox(painter.font(), text.view, scale, ruler));
    std::vector<QRectF> words = paintFolds(painter, style, onScreen, document);
    words.insert(words.end(), taken.begin(), taken.end());
    const QRectF free(text.view.adjusted(ruler, ruler, 0, 0));
    std::ranges::copy(text.gaps.paint(painter, style, onScreen, text.places, free, words),
                      std::back_inserter(words));
    std::vector<DrawnArrow> arrows;
    if (document.view().grain || text.strongGrain) {
        arrows = paintGrainArrows(painter, style, onScreen, document, text.strongGrain);
    }
    CalloutRoom room{free, std::move(taken)};
    if (!text.spots.spots.empty()) {
        room.lines = linesOf(text, onScreen);
    }
    for (const DrawnArrow& arrow : arrows) {
        room.lines.push_back(QPolygonF({arrow.line.p1(), arrow.line.p2()}));
    }
    if (document.view().labels) {
        for (const NameLabel& name :
             paintNames(painter, style, text, {free, std::move(words)}, arrows)) {
            room.taken.push_back(name.bounds());
            if (name.leader) {
                room.lines.push_back(QPolygonF({name.leader->p1(), name.leader->p2()}));
            }
        }
    }
    paintSpotCallouts(painter, style, room, document, text.spots, [&text](const WorstSpot& spot) {
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
