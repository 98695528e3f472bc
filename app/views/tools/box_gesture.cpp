// SPDX-License-Identifier: GPL-3.0-or-later
#include <QPainter>
#include <algorithm>

#include "app/views/tools/sheet_gestures.h"
#include "app/views/tools/sheet_map.h"

namespace toile {

namespace {

Points2 outlineOnSheet(const Document& document, int piece) {
    const Placement placement = placementOf(document, piece);
    Points2 outline = flatOutline(document, piece) * placement.linear().transpose();
    outline.rowwise() += placement.offset.transpose();
    return outline;
}

/// Whether some point of the segment is in the box: it is cut at each of the four sides in turn.
bool meets(const Eigen::AlignedBox2d& box, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    double from = 0, to = 1;
    for (int k = 0; k < 2; ++k) {
        const double way = b[k] - a[k];
        if (way == 0) {
            if (a[k] < box.min()[k] || a[k] > box.max()[k]) {
                return false;
            }
            continue;
        }
        const double low = (box.min()[k] - a[k]) / way, high = (box.max()[k] - a[k]) / way;
        from = std::max(from, std::min(low, high));
        to = std::min(to, std::max(low, high));
    }
    return from <= to;
}

bool isInside(const Points2& outline, const Eigen::Vector2d& point) {
    bool inside = false;
    for (Eigen::Index i = 0, j = outline.rows() - 1; i < outline.rows(); j = i++) {
        const Eigen::Vector2d a = outline.row(j).transpose(), b = outline.row(i).transpose();
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
            inside = !inside;
        }
    }
    return inside;
}

/// Whether box and piece have a point in common: their edges meet, or the box lies on the cloth.
bool touches(const Eigen::AlignedBox2d& box, const Points2& outline) {
    for (Eigen::Index i = 0, j = outline.rows() - 1; i < outline.rows(); j = i++) {
        if (meets(box, outline.row(j).transpose(), outline.row(i).transpose())) {
            return true;
        }
    }
    return isInside(outline, box.center());
}

}  // namespace

BoxGesture::BoxGesture(Document& document, const Eigen::Vector2d& pressed, bool adds)
    : document_(document),
      before_(document.selection()),
      adds_(adds),
      from_(pressed),
      to_(pressed) {}

void BoxGesture::drag(ToolView& view, const Pointer& pointer) {
    to_ = view.onSheet(pointer.at);
    Eigen::AlignedBox2d box(from_);
    box.extend(to_);
    Document::Selection selection = adds_ ? before_ : Document::Selection{};
    for (const int piece : allFlat(document_)) {
        if (box.intersects(boxOnSheet(document_, piece)) &&
            touches(box, outlineOnSheet(document_, piece))) {
            selection.insert(piece);
        }
    }
    document_.setSelection(std::move(selection));
    view.repaintSoon();
}

void BoxGesture::takeBack() {
    document_.setSelection(before_);
}

void BoxGesture::paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const {
    QColor fill = style.selection;
    fill.setAlpha(28);
    painter.save();
    painter.setPen(QPen(style.selection, 1, Qt::DashLine));
    painter.setBrush(fill);
    const SheetMap onScreen(view);
    painter.drawRect(QRectF(onScreen(from_), onScreen(to_)).normalized());
    painter.restore();
}

}  // namespace toile
