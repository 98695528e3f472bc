// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/marker/cloth_view.h"

#include <QLineF>
#include <QPainter>
#include <algorithm>

#include "app/marker/marker_desk.h"
#include "app/render/colour_map.h"
#include "app/render/render_style.h"
#include "app/text/figures.h"
#include "app/views/ruler.h"
#include "app/views/view_text.h"

namespace toile::app {

namespace {

constexpr double kHandleAway = 22, kHandle = 6;
constexpr Camera2D::Margins kAround{kRulerBreadth + 16, kRulerBreadth + 26, 34};

QColor clothColour(const RenderStyle& style) {
    return style.onDark ? QColor(74, 78, 86) : QColor(255, 255, 255);
}

}  // namespace

ClothView::ClothView(MarkerDesk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
    setObjectName("clothView");
    setAccessibleName(tr("Cloth"));
    setMinimumSize(320, 240);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    connect(&desk_, &MarkerDesk::changed, this, &ClothView::refresh);
    connect(&desk_, &MarkerDesk::clothChanged, this, &ClothView::frameAll);
    refresh();
}

void ClothView::refresh() {
    shapes_.clear();
    const ClothMarker* marker = desk_.marker();
    if (!marker) {
        if (isDragging()) {
            cancelDrag();
        }
        update();
        return;
    }
    const Pattern& pattern = *desk_.pattern();
    for (const LaidCopy& copy : marker->copies) {
        const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(copy.piece)];
        ClothShape& shape = shapes_.emplace_back();
        shape.edge = laidOutline(pattern, copy);
        if (piece.cuttingLine.rows() > 0) {
            shape.seam = piece.outline * copy.placement.linear().transpose();
            shape.seam.rowwise() += copy.placement.offset.transpose();
        }
        shape.label = copy.placement.applied(labels_.of(desk_.pattern(), copy.piece));
        const double grain = grainOf(piece);
        shape.grain = copy.placement.linear() * Eigen::Vector2d(std::cos(grain), std::sin(grain));
        const int garmentPiece = pieceOf(copy);
        const int number = garmentPiece < 0 ? copy.piece : desk_.document().colourOf(garmentPiece);
        const Rgb colour = pieceColour(number);
        shape.colour = QColor(colour.r, colour.g, colour.b);
        shape.name = QString::fromStdString(piece.name);
        shape.isKept = copy.isKept;
        shape.isStated = piece.grain.has_value();
        shape.isSelected = selected_ && *selected_ == copy.key;
    }
    for (const int copy : desk_.misplaced()) {
        shapes_[static_cast<std::size_t>(copy)].isMisplaced = true;
    }
    if (followsAll_ && !isDragging()) {
        follow();
    }
    update();
}

void ClothView::follow() {
    if (const ClothMarker* marker = desk_.marker()) {
        camera_.setViewport(width(), height());
        Eigen::AlignedBox2d box(
            Eigen::Vector2d::Zero(),
            Eigen::Vector2d(std::max(marker->length, 1.0), std::max(marker->width, 1.0)));
        for (const ClothPart& part : marker->parts) {
            box.extend(geometry::boxAround(part.outline));
        }
        camera_.frame(box, kAround);
    }
}

void ClothView::frameAll() {
    followsAll_ = true;
    follow();
    update();
}

QPointF ClothView::placeOf(int copy) const {
    return map()(shapes_[static_cast<std::size_t>(copy)].label);
}

int ClothView::selected() const {
    const auto found = std::ranges::find(shapes_, true, &ClothShape::isSelected);
    return found == shapes_.end() ? -1 : static_cast<int>(found - shapes_.begin());
}

std::optional<QPointF> ClothView::handle() const {
    const int copy = selected();
    if (copy < 0 || !desk_.marker() || !turnsByDegrees(desk_.settings())) {
        return std::nullopt;
    }
    const QRectF box = map()(geometry::boxAround(shapes_[static_cast<std::size_t>(copy)].edge));
    return QPointF(box.center().x(), box.top() - kHandleAway);
}

bool ClothView::isOnHandle(const QPointF& at) const {
    const auto hand = handle();
    return hand && QLineF(*hand, at).length() <= 2 * kHandle;
}

Eigen::Vector2d ClothView::onCloth(const QPointF& at) const {
    return camera_.toWorld(at.x(), at.y());
}

/// The one that is painted last.
int ClothView::copyAt(const QPointF& at) const {
    const Eigen::Vector2d place = onCloth(at);
    int found = -1;
    for (std::size_t c = 0; c < shapes_.size(); ++c) {
        if (geometry::isInside(shapes_[c].edge, place) &&
            (found < 0 || shapes_[c].isSelected ||
             (shapes_[c].isMisplaced && !shapes_[static_cast<std::size_t>(found)].isSelected))) {
            found = static_cast<int>(c);
        }
    }
    return found;
}

void ClothView::select(int copy) {
    selected_.reset();
    if (copy >= 0) {
        const LaidCopy& laid = desk_.marker()->copies[static_cast<std::size_t>(copy)];
        selected_ = laid.key;
        if (const int piece = pieceOf(laid); piece >= 0) {
            desk_.document().setSelection({piece});
        }
    }
    refresh();
}

/// In the garment as it is now, of which the marker may not be yet; -1: it is no more there.
int ClothView::pieceOf(const LaidCopy& copy) const {
    const auto& garment = desk_.document().garment();
    if (!garment) {
        return -1;
    }
    const auto found = std::ranges::find(garment->pieces, copy.key.piece,
                                         [](const auto& piece) { return piece->id; });
    return found == garment->pieces.end() ? -1 : static_cast<int>(found - garment->pieces.begin());
}

void ClothView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    camera_.setViewport(width(), height());
    if (followsAll_) {
        follow();
    }
}

void ClothView::paintHands(QPainter& painter, const RenderStyle& style) const {
    const SheetMap onScreen = map();
    painter.save();
    if (drag_) {
        painter.setPen(QPen(style.selection, 1.2, Qt::DashLine));
        for (const SnapLine& line : drag_->snapped().lines) {
            painter.drawLine(onScreen(line.from), onScreen(line.to));
        }
        if (const auto& vertex = drag_->snapped().vertex) {
            painter.setPen(QPen(style.selection, 2));
            painter.drawEllipse(onScreen(*vertex), kHandle, kHandle);
        }
    }
    if (const auto at = handle(); at && !drag_) {
        painter.setPen(QPen(style.selection, 1.5));
        painter.drawLine(*at, *at + QPointF(0, kHandleAway));
        painter.setBrush(style.labelFill);
        painter.drawEllipse(*at, kHandle, kHandle);
    }
    painter.restore();
}

void ClothView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const RenderStyle style = renderStyle(palette());
    QLinearGradient ground(0, 0, 0, height());
    ground.setColorAt(0, style.top);
    ground.setColorAt(1, style.bottom);
    painter.fillRect(rect(), ground);
    const ClothMarker* marker = desk_.marker();
    if (!marker) {
        paintProblem(painter, style, rect(), desk_.problem());
        return;
    }
    const SheetMap onScreen = map();
    paintCloth(painter, style, onScreen, *marker, desk_.settings(), clothColour(style));
    paintCopies(painter, style, onScreen, shapes_);
    paintHands(painter, style);
    const int chosen = selected();
    paintRulers(painter, style, rect(), onScreen, camera_.visible(), camera_.pixelsPerMillimetre(),
                chosen < 0 ? Eigen::AlignedBox2d()
                           : geometry::boxAround(shapes_[static_cast<std::size_t>(chosen)].edge));
}

}  // namespace toile::app
