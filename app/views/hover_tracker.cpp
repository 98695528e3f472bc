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

/// From the pointer to the plate's corner: clear of the arrow.
constexpr int kRight = 16, kBelow = 18;
constexpr double kDot = 5.5;

/// Of the face that the vertex is told by.
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
    : document_(document), widget_(widget), plate_(new QLabel(&widget)) {
    plate_->setObjectName("hoverText");
    plate_->setAttribute(Qt::WA_TransparentForMouseEvents);
    plate_->setAutoFillBackground(true);
    plate_->setPalette(QToolTip::palette());
    plate_->setForegroundRole(QPalette::ToolTipText);
    plate_->setBackgroundRole(QPalette::ToolTipBase);
    plate_->setFrameShape(QFrame::Box);
    plate_->setContentsMargins(6, 3, 6, 3);
    plate_->hide();
}

std::optional<SurfaceHit> HoverTracker::move(const ToolView& view, const QPointF& at, bool tells) {
    const auto feature = featureAt(view, document_, at);
    auto hit = view.hitAt(at);
    if (hit && feature && feature->kind == Feature::Kind::Vertex) {
        hit->barycentric = cornerOf(document_, *feature);
    }
    const bool same = feature == shown_ && feature == document_.hover() && !plate_->isHidden();
    shown_ = feature;
    place_ = hit;
    document_.setHover(feature);
    if (!feature || !tells) {
        hidePlate();
        return hit;
    }
    const QRect before = plate_->geometry();
    // The value is another at every place.
    if (!same || isMeasured(document_.view().overlay)) {
        write();
    }
    placePlate(at.toPoint());
    if (plate_->isHidden()) {
        plate_->show();
    } else if (plate_->geometry() != before) {
        uncover(before);
    }
    plate_->raise();
    return hit;
}

void HoverTracker::write() {
    plate_->setText(featureText(document_, *shown_, place_));
    plate_->adjustSize();
}

void HoverTracker::writeAgain() {
    if (shown_ && !plate_->isHidden()) {
        const QRect before = plate_->geometry();
        write();
        uncover(before);
    }
}

void HoverTracker::forget() {
    shown_.reset();
    place_.reset();
    hidePlate();
}

void HoverTracker::hidePlate() {
    if (!plate_->isHidden()) {
        plate_->hide();
        uncover(plate_->geometry());
    }
}

void HoverTracker::uncover(const QRect& left) {
    // Qt leaves the picture of a widget behind where it has lain over an OpenGL view, until that is
    // painted again. Asked through the widget beneath, it composes that part anew without painting
    // the whole scene.
    if (QWidget* beneath = widget_.parentWidget()) {
        beneath->update(left.translated(widget_.pos()));
    }
}

void HoverTracker::placePlate(const QPoint& pointer) {
    int x = pointer.x() + kRight, y = pointer.y() + kBelow;
    if (y + plate_->height() > widget_.height()) {
        y = pointer.y() - kBelow / 2 - plate_->height();
    }
    x = std::max(0, std::min(x, widget_.width() - plate_->width()));
    plate_->move(x, std::max(0, y));
}

void HoverTracker::follow() {
    if (document_.hover() != shown_) {
        hidePlate();
    }
}

void HoverTracker::leave() {
    forget();
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
