// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/pattern_view.h"

#include <QPainter>
#include <algorithm>

#include "app/document/document.h"
#include "app/render/pattern_renderer.h"
#include "app/render/picking.h"
#include "app/views/view_text.h"

namespace toile {

namespace {

/// Room for the caption above and the scale bar below.
constexpr Camera2D::Margins kMargins{26, 44, 66};

}  // namespace

PatternView::PatternView(Document& document, QWidget* parent)
    : SceneView(document, std::make_unique<PatternRenderer>(), parent) {
    setObjectName("patternView");
}

void PatternView::setCameraViewport(double width, double height) {
    camera_.setViewport(width, height);
}

void PatternView::framePieces(const std::set<int>& pieces) {
    Eigen::AlignedBox2d box;
    for (const int piece : pieces) {
        box.extend(scene()->pieces[static_cast<std::size_t>(piece)].placedBox());
    }
    camera_.frame(box, kMargins);
}

bool PatternView::frameLines(const SeamScene& seam) {
    if (seam.flatBox.isEmpty()) {
        return false;
    }
    camera_.frame(seam.flatBox, kMargins);
    return true;
}

void PatternView::drag(Drag, const QPointF& delta) {
    camera_.pan(delta.x(), delta.y());
}

void PatternView::zoom(const QPointF& at, double factor) {
    camera_.zoomAt(at.x(), at.y(), factor);
}

std::optional<int> PatternView::pieceAt(const QPointF& at) const {
    return scene() ? pickPattern(*scene(), camera_.toWorld(at.x(), at.y())) : std::nullopt;
}

void PatternView::paintScene(const RenderStyle& style, int width, int height, double ratio) {
    static_cast<PatternRenderer&>(renderer())
        .paint(camera_, document_.view(), style, width, height, ratio);
}

void PatternView::paintText(QPainter& painter, const RenderStyle& style) {
    paintCaption(painter, style, tr("Pattern"), tr("right side of the fabric up, net outlines"));
    if (!scene() || scene()->sheetBox.isEmpty()) {
        painter.setPen(style.faintText);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         emptyText());
        return;
    }
    paintNames(painter, style);
    paintScaleBar(painter, style, rect(), camera_.pixelsPerMillimetre());
}

void PatternView::paintNames(QPainter& painter, const RenderStyle& style) const {
    for (std::size_t i = 0; i < scene()->pieces.size(); ++i) {
        const PieceScene& piece = scene()->pieces[i];
        if (!piece.flat) {
            continue;
        }
        const Eigen::Vector2d at = camera_.toScreen(piece.label + piece.offset);
        // A name may stand out a little on either side before it is shortened.
        const double room = 1.25 * piece.flatBox.sizes().x() * camera_.pixelsPerMillimetre();
        paintPlate(painter, style, {at.x(), at.y()}, room,
                   QString::fromStdString(document_.garment()->pieces[i]->name),
                   document_.isSelected(static_cast<int>(i)));
    }
}

QString PatternView::emptyText() const {
    if (document_.pieceCount() == 0) {
        return {};
    }
    if (document_.results().empty()) {
        return tr("The flat pieces appear here.");
    }
    return tr("None of the pieces could be flattened. The list of pieces says why.");
}

}  // namespace toile
