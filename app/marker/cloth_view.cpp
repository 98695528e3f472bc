// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/marker/cloth_view.h"

#include <QCoreApplication>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "app/marker/marker_desk.h"
#include "app/render/colour_map.h"
#include "app/render/render_style.h"
#include "app/text/figures.h"
#include "app/views/grain_arrow.h"
#include "app/views/ruler.h"
#include "app/views/view_text.h"
#include "core/pattern/pole.h"

namespace toile::app {
namespace {

constexpr double kSelvedge = 3;          // pixels
constexpr double kMinStripes = 4;        // minimum distance in pixels
constexpr double kArrow = 34, kPin = 5;  // pixels
constexpr double kWordsAir = 6;

QPolygonF onCloth(const SheetMap& onScreen, const Points2& line) {
    QPolygonF polygon;
    polygon.reserve(line.rows());
    for (Eigen::Index k = 0; k < line.rows(); ++k) {
        polygon << onScreen(Eigen::Vector2d(line.row(k)));
    }
    return polygon;
}

QColor faded(QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
}

/// Paints lines across a box, one every `step` from `origin`.
void paintStripes(QPainter& painter, const SheetMap& onScreen, const Eigen::AlignedBox2d& box,
                  int axis, double step, double origin) {
    if (!(step * onScreen.pixelsPerMillimetre() >= kMinStripes)) {
        return;
    }
    const double first = std::ceil((box.min()[axis] - origin) / step);
    const auto count = static_cast<int>(std::floor((box.max()[axis] - origin) / step) - first) + 1;
    for (int k = 0; k < count; ++k) {
        Eigen::Vector2d from = box.min(), to = box.max();
        from[axis] = to[axis] = origin + (first + k) * step;
        painter.drawLine(onScreen(from), onScreen(to));
    }
}

void paintRepeat(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                 const Eigen::AlignedBox2d& cloth, const ClothRepeat& repeat) {
    painter.setPen(QPen(faded(style.reference, 110), 1));
    if (repeat.warp > 0) {
        paintStripes(painter, onScreen, cloth, 0, repeat.warp, repeat.origin.x());
    }
    if (repeat.weft > 0) {
        paintStripes(painter, onScreen, cloth, 1, repeat.weft, repeat.origin.y());
    }
}

/// Paints a roll: selvedges on both sides, or a fold on the lower one. It continues beyond its end.
void paintRoll(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
               const ClothMarker& marker, bool isFolded) {
    const QPointF upperLeft = onScreen(Eigen::Vector2d(0, marker.width));
    const QPointF upperRight = onScreen(Eigen::Vector2d(marker.length, marker.width));
    const QPointF lowerLeft = onScreen(Eigen::Vector2d(0, 0));
    const QPointF lowerRight = onScreen(Eigen::Vector2d(marker.length, 0));
    painter.setPen(QPen(style.text, kSelvedge, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(upperLeft, upperRight);
    painter.setPen(
        QPen(style.text, kSelvedge, isFolded ? Qt::DashDotLine : Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(lowerLeft, lowerRight);
    painter.setPen(QPen(style.text, 1));
    painter.drawLine(upperLeft, lowerLeft);
    painter.setPen(QPen(style.text, 1.4, Qt::DashLine));
    painter.drawLine(upperRight, lowerRight);
    const QFontMetricsF metrics(painter.font());
    painter.setPen(style.faintText);
    painter.drawText(upperLeft + QPointF(0, -kWordsAir),
                     QCoreApplication::translate("ClothView", "selvedge"));
    const double below = metrics.ascent() + kWordsAir;
    painter.drawText(lowerLeft + QPointF(0, below),
                     isFolded ? QCoreApplication::translate("ClothView", "fold of the cloth")
                              : QCoreApplication::translate("ClothView", "selvedge"));
    const QString warp = QCoreApplication::translate("ClothView", "warp");
    const double width = metrics.horizontalAdvance(warp);
    const QPointF at = lowerRight + QPointF(-width - kArrow - kWordsAir, below);
    if (at.x() > lowerLeft.x() + 2 * width) {
        painter.drawText(at, warp);
        const QPointF tail = at + QPointF(width + kWordsAir, -0.35 * metrics.ascent());
        paintArrow(painter, style, tail, tail + QPointF(kArrow - kWordsAir, 0), false, true);
    }
    painter.setPen(style.text);
    const QString length = lengthWithUnit(marker.length);
    painter.drawText(upperRight + QPointF(-metrics.horizontalAdvance(length), -kWordsAir), length);
}

void paintParts(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                const ClothMarker& marker) {
    for (const ClothPart& part : marker.parts) {
        painter.setPen(QPen(style.text, 1.6));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolygon(onCloth(onScreen, part.outline));
        for (const HideZone& zone : part.zones) {
            const QPolygonF polygon = onCloth(onScreen, zone.outline);
            painter.setPen(QPen(style.text, 1));
            painter.setBrush(zone.grade == 0
                                 ? QBrush(style.bottom)
                                 : QBrush(faded(style.reference, 60), Qt::BDiagPattern));
            painter.drawPolygon(polygon);
            if (zone.grade > 0) {
                painter.drawText(
                    polygon.boundingRect(), Qt::AlignCenter,
                    QCoreApplication::translate("ClothView", "grade %1").arg(zone.grade));
            }
        }
    }
}

/// Paints the pin of a fixed piece, with its tip at the place.
void paintPin(QPainter& painter, const RenderStyle& style, const QPointF& tip) {
    const QPointF head = tip + QPointF(kPin, -2.2 * kPin);
    painter.setPen(QPen(style.text, 1.6));
    painter.drawLine(tip, head);
    painter.setPen(QPen(style.labelFill, 1));
    painter.setBrush(style.selection);
    painter.drawEllipse(head, kPin, kPin);
}

void paintShape(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                const ClothShape& shape) {
    const QPolygonF edge = onCloth(onScreen, shape.edge);
    painter.setPen(QPen(shape.isMisplaced  ? misplacedColour()
                        : shape.isSelected ? style.selection
                                           : style.outline,
                        shape.isMisplaced || shape.isSelected ? 2.4 : 1.2, Qt::SolidLine,
                        Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(shape.colour);
    painter.drawPolygon(edge);
    if (shape.isMisplaced) {
        painter.setBrush(faded(misplacedColour(), 70));
        painter.drawPolygon(edge);
        painter.setBrush(QBrush(faded(misplacedColour(), 200), Qt::BDiagPattern));
        painter.drawPolygon(edge);
    }
    if (shape.seam.rows() > 0) {
        painter.setPen(QPen(faded(style.outline, 130), 0.8));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolygon(onCloth(onScreen, shape.seam));
    }
}

/// The name, if there is space, above the grain arrow.
void paintWords(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                const ClothShape& shape) {
    const QRectF room = onCloth(onScreen, shape.edge).boundingRect();
    const QPointF at = onScreen(shape.label);
    const QSizeF size = labelSize(painter.font(), shape.name, shape.isSelected);
    const bool hasName = size.width() <= room.width() && 2 * size.height() <= room.height();
    const QPointF arrow = at + QPointF(0, hasName ? 0.95 * size.height() : 0);
    const QPointF way = 0.5 * kArrow * QPointF(shape.grain.x(), -shape.grain.y());
    const QPolygonF edge = onCloth(onScreen, shape.edge);
    if (edge.containsPoint(arrow - way, Qt::OddEvenFill) &&
        edge.containsPoint(arrow + way, Qt::OddEvenFill)) {
        paintArrow(painter, style, arrow - way, arrow + way, shape.isSelected, shape.isStated);
    }
    if (hasName) {
        paintLabel(painter, style, QRectF(at - QPointF(size.width() / 2, size.height() / 2), size),
                   shape.name, shape.isSelected);
    }
    if (shape.isKept) {
        paintPin(painter, style, at + QPointF(hasName ? size.width() / 2 : 0, -size.height() / 2));
    }
}

constexpr double kHandleAway = 22, kHandle = 6;
constexpr Camera2D::Margins kAround{kRulerBreadth + 16, kRulerBreadth + 26, 34};

QColor clothColour(const RenderStyle& style) {
    return style.onDark ? QColor(74, 78, 86) : QColor(255, 255, 255);
}

}  // namespace

QColor misplacedColour() {
    return {220, 24, 24};
}

const Eigen::Vector2d& ClothLabels::of(const std::shared_ptr<const Pattern>& pattern, int piece) {
    if (pattern != pattern_) {
        pattern_ = pattern;
        places_.assign(pattern->pieces.size(), std::nullopt);
    }
    auto& place = places_[static_cast<std::size_t>(piece)];
    if (!place) {
        const PatternPiece& laid = pattern->pieces[static_cast<std::size_t>(piece)];
        FreeCloth cloth{{laid.outline}};
        cloth.loops.insert(cloth.loops.end(), laid.holes.begin(), laid.holes.end());
        const auto pole = circlePole(cloth, {0.02, 0.3});
        place = pole ? pole->place : Eigen::Vector2d(laid.outline.colwise().mean());
    }
    return *place;
}

void paintCloth(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                const ClothMarker& marker, const MarkerSettings& settings, const QColor& ground) {
    painter.save();
    const bool isRoll = marker.isRoll;
    const Eigen::AlignedBox2d cloth(Eigen::Vector2d::Zero(),
                                    Eigen::Vector2d(marker.length, marker.width));
    QPainterPath area;
    if (isRoll) {
        area.addRect(onScreen(cloth));
    }
    for (const ClothPart& part : isRoll ? std::vector<ClothPart>() : marker.parts) {
        area.addPolygon(onCloth(onScreen, part.outline));
        area.closeSubpath();
    }
    painter.fillPath(area, ground);
    painter.save();
    painter.setClipPath(area);
    paintRepeat(painter, style, onScreen, cloth, settings.repeat);
    painter.restore();
    if (isRoll) {
        paintRoll(painter, style, onScreen, marker, settings.isFolded);
    } else {
        paintParts(painter, style, onScreen, marker);
    }
    painter.restore();
}

void paintCopies(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                 const std::vector<ClothShape>& shapes) {
    painter.save();
    std::vector<const ClothShape*> order;
    order.reserve(shapes.size());
    for (const ClothShape& shape : shapes) {
        order.push_back(&shape);
    }
    std::ranges::stable_sort(order, {}, [](const ClothShape* shape) -> int {
        return (shape->isMisplaced ? 1 : 0) + (shape->isSelected ? 2 : 0);
    });
    for (const ClothShape* shape : order) {
        paintShape(painter, style, onScreen, *shape);
    }
    for (const ClothShape* shape : order) {
        paintWords(painter, style, onScreen, *shape);
    }
    painter.restore();
}

ClothView::ClothView(MarkerDesk& desk, QWidget* parent)
    : QWidget(parent), desk_(desk), camera_(kAround), canvas_(*this, camera_, true) {
    setObjectName("clothView");
    setAccessibleName(tr("Cloth"));
    setMinimumSize(320, 240);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    connect(&desk_, &MarkerDesk::changed, this, &ClothView::refresh);
    connect(&desk_, &MarkerDesk::clothChanged, &camera_, &SheetCamera::frameAll);
    connect(&camera_, &SheetCamera::moved, this, [this] { update(); });
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
    if (!isDragging()) {
        Eigen::AlignedBox2d box(
            Eigen::Vector2d::Zero(),
            Eigen::Vector2d(std::max(marker->length, 1.0), std::max(marker->width, 1.0)));
        for (const ClothPart& part : marker->parts) {
            box.extend(geometry::boxAround(part.outline));
        }
        camera_.setBox(box);
    }
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
    return camera_.camera().toWorld(at.x(), at.y());
}

/// The topmost copy at a place.
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

/// Index in the current garment, which may be newer than the marker; -1: the piece is gone.
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
    camera_.setViewport(size());
}

void ClothView::paintHandles(QPainter& painter, const RenderStyle& style) const {
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
    paintHandles(painter, style);
    const int chosen = selected();
    paintRulers(painter, style, rect(), onScreen, camera_.camera().visible(),
                map().pixelsPerMillimetre(),
                chosen < 0 ? Eigen::AlignedBox2d()
                           : geometry::boxAround(shapes_[static_cast<std::size_t>(chosen)].edge));
}

}  // namespace toile::app
