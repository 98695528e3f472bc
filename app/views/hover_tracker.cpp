// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/hover_tracker.h"

#include <QLabel>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "app/document/document.h"
#include "app/render/render_style.h"
#include "app/views/feature_at.h"
#include "app/views/feature_text.h"
#include "app/views/tool.h"

namespace toile::app {

namespace {

/// Offset of the label from the pointer, clear of the cursor arrow.
constexpr int kRight = 16, kBelow = 18;
constexpr double kDot = 5.5;

/// Barycentric weights of the vertex in the face that refers to it.
Eigen::Vector3d cornerOf(const Document& document, const Feature& vertex) {
    const Piece& piece = *document.garment()->pieces[static_cast<std::size_t>(vertex.piece)];
    int corner = 0;
    while (corner < 2 && piece.mesh.F(vertex.face, corner) != vertex.vertex) {
        ++corner;
    }
    return Eigen::Vector3d::Unit(corner);
}

void paintDot(QPainter& painter, const RenderStyle& style, const ToolView& view,
              const Document& document, const Feature& feature, double radius) {
    if (const auto at = view.onScreen(feature.piece, feature.face, cornerOf(document, feature))) {
        painter.setPen(QPen(style.seamHalo, 2));
        painter.setBrush(style.seam);
        painter.drawEllipse(*at, radius, radius);
    }
}

}  // namespace

HoverTracker::HoverTracker(Document& document, QWidget& widget)
    : document_(document), widget_(widget), label_(new QLabel(&widget)) {
    label_->setObjectName("hoverText");
    label_->setAttribute(Qt::WA_TransparentForMouseEvents);
    label_->setAutoFillBackground(true);
    label_->setPalette(QToolTip::palette());
    label_->setForegroundRole(QPalette::ToolTipText);
    label_->setBackgroundRole(QPalette::ToolTipBase);
    label_->setFrameShape(QFrame::Box);
    label_->setContentsMargins(6, 3, 6, 3);
    label_->hide();
}

std::optional<SurfaceHit> HoverTracker::move(const ToolView& view, const QPointF& at, bool tells) {
    const auto feature = featureAt(view, document_, at);
    auto hit = view.hitAt(at);
    if (hit && feature && feature->kind == Feature::Kind::Vertex) {
        hit->barycentric = cornerOf(document_, *feature);
    }
    const bool same = feature == shown_ && feature == document_.hover() && !label_->isHidden();
    shown_ = feature;
    place_ = hit;
    document_.setHover(feature);
    if (!feature || !tells) {
        hideLabel();
        return hit;
    }
    const QRect before = label_->geometry();
    // A measured overlay has a different value at every place.
    if (!same || isMeasured(document_.view().overlay)) {
        write();
    }
    placeLabel(at.toPoint());
    if (label_->isHidden()) {
        label_->show();
    } else if (label_->geometry() != before) {
        uncover(before);
    }
    label_->raise();
    return hit;
}

void HoverTracker::write() {
    label_->setText(featureText(document_, *shown_, place_));
    label_->adjustSize();
}

void HoverTracker::writeAgain() {
    if (shown_ && !label_->isHidden()) {
        const QRect before = label_->geometry();
        write();
        uncover(before);
    }
}

void HoverTracker::reset() {
    shown_.reset();
    place_.reset();
    hideLabel();
}

void HoverTracker::hideLabel() {
    if (!label_->isHidden()) {
        label_->hide();
        uncover(label_->geometry());
    }
}

void HoverTracker::uncover(const QRect& left) {
    // When a child widget over a QOpenGLWidget moves, Qt leaves its old image until that view is
    // repainted. Updating the parent recomposes the area without rendering the scene again.
    if (QWidget* beneath = widget_.parentWidget()) {
        beneath->update(left.translated(widget_.pos()));
    }
}

void HoverTracker::placeLabel(const QPoint& pointer) {
    int x = pointer.x() + kRight, y = pointer.y() + kBelow;
    if (y + label_->height() > widget_.height()) {
        y = pointer.y() - kBelow / 2 - label_->height();
    }
    x = std::max(0, std::min(x, widget_.width() - label_->width()));
    label_->move(x, std::max(0, y));
}

void HoverTracker::follow() {
    if (document_.hover() != shown_) {
        hideLabel();
    }
}

void HoverTracker::leave() {
    reset();
    document_.setHover({});
}

void paintVertexDots(QPainter& painter, const RenderStyle& style, const ToolView& view,
                     const Document& document) {
    const auto paint = [&](const std::optional<Feature>& feature, double radius) {
        if (feature && feature->kind == Feature::Kind::Vertex) {
            painter.save();
            paintDot(painter, style, view, document, *feature, radius);
            painter.restore();
        }
    };
    paint(document.mark(), kDot);
    paint(document.hover(), kDot - 0.5);
}

}  // namespace toile::app
