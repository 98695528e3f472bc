// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/sheet_gestures.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/document/piece_edits.h"
#include "app/render/pattern_renderer.h"
#include "app/settings/length_display.h"
#include "app/text/figures.h"
#include "app/views/tool.h"
#include "app/views/tools/tool_paint.h"
#include "core/base/units.h"

namespace toile::app {

namespace {

/// Points of a flat piece in sheet coordinates.
Points2 onSheet(const Document& document, int piece, const Points2& points) {
    const Placement placement = placementOf(document, piece);
    Points2 placed = points * placement.linear().transpose();
    placed.rowwise() += placement.offset.transpose();
    return placed;
}

/// Whether box and piece intersect: their edges meet, or the box lies on the cloth.
bool touches(const Eigen::AlignedBox2d& box, const Points2& outline) {
    QPolygonF polygon;
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        polygon << QPointF(outline(i, 0), outline(i, 1));
    }
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    return path.intersects(
        QRectF(QPointF(box.min().x(), box.min().y()), QPointF(box.max().x(), box.max().y())));
}

constexpr double kSnapRadius = 8;   // pixels
constexpr double kGridRadii = 2.5;  // minimum spacing of grid lines, or everything snaps
constexpr double kStep = 15 * kDegree;
constexpr double kGoodAngle = 3 * kDegree;

/// The finest drawn grid with enough space between its lines.
double gridStep(double pixelsPerMillimetre) {
    const GridSteps steps = gridSteps(pixelsPerMillimetre, LengthDisplay::instance().format().unit);
    return steps.minor() * pixelsPerMillimetre >= kGridRadii * kSnapRadius ? steps.minor()
                                                                           : steps.major;
}

/// The corners of the pieces' outlines in sheet coordinates.
Points2 cornersOnSheet(const Document& document, const std::vector<int>& pieces) {
    std::vector<Points2> outlines;
    Eigen::Index count = 0;
    for (const int piece : pieces) {
        outlines.push_back(onSheet(document, piece, snapPoints(flatOutline(document, piece))));
        count += outlines.back().rows();
    }
    Points2 all(count, 2);
    Eigen::Index next = 0;
    for (const Points2& outline : outlines) {
        all.middleRows(next, outline.rows()) = outline;
        next += outline.rows();
    }
    return all;
}

}  // namespace

BoxGesture::BoxGesture(Document& document, const Eigen::Vector2d& pressed, bool adds)
    : SheetGesture(document),
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
        if (isHidden(document_, piece)) {
            continue;
        }
        if (box.intersects(boxOnSheet(document_, piece)) &&
            touches(box, onSheet(document_, piece, cutOutline(document_, piece)))) {
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

PlacingGesture::PlacingGesture(Document& document, QString text)
    : SheetGesture(document),
      pieces_(selectedFlat(document)),
      text_(std::move(text)),
      gesture_(document.newGesture()),
      settingsBefore_(document.settings()) {
    for (const int piece : pieces_) {
        before_[piece] = placementOf(document_, piece);
    }
}

void PlacingGesture::lay(const PiecePlacements& placements) {
    place(document_, text_, placements, gesture_);
}

bool PlacingGesture::snaps(const Pointer& pointer) const {
    return document_.view().snapping != pointer.modifiers.testFlag(Qt::AltModifier);
}

void PlacingGesture::takeBack() {
    placeBack(document_, text_, before_, settingsBefore_, gesture_);
}

MoveGesture::MoveGesture(Document& document, const Eigen::Vector2d& pressed)
    : PlacingGesture(document, QCoreApplication::translate("MoveGesture", "Move %1")),
      pressed_(pressed),
      box_(boxOnSheet(document, pieces_)),
      corners_(cornersOnSheet(document, pieces_)) {
    std::vector<int> staying = allFlat(document_);
    std::erase_if(staying, [this](int piece) { return before_.contains(piece); });
    for (const int piece : staying) {
        targets_.boxes.push_back(boxOnSheet(document_, piece));
    }
    targets_.vertices = cornersOnSheet(document_, staying);
}

void MoveGesture::drag(ToolView& view, const Pointer& pointer) {
    pointer_ = pointer.at;
    const Eigen::Vector2d way = view.onSheet(pointer.at) - pressed_;
    targets_.gridStep = gridStep(view.pixelsPerMillimetre());
    move_ = snaps(pointer) ? snappedMove(box_, corners_, way, targets_,
                                         kSnapRadius / view.pixelsPerMillimetre())
                           : SnappedMove{way};
    PiecePlacements moved = before_;
    for (auto& [piece, placement] : moved) {
        placement = movedBy(placement, move_.way);
    }
    lay(moved);
}

void MoveGesture::paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const {
    const SheetMap onScreen(view);
    painter.save();
    painter.setPen(QPen(style.selection, 1.2, Qt::DashLine));
    for (const SnapLine& line : move_.lines) {
        painter.drawLine(onScreen(line.from), onScreen(line.to));
    }
    if (move_.vertex) {
        painter.setPen(QPen(style.selection, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(onScreen(*move_.vertex), 6, 6);
    }
    painter.restore();
    paintNote(painter, style, pointer_, {wayText(move_.way)});
}

RotateGesture::RotateGesture(Document& document, const Eigen::Vector2d& pressed)
    : PlacingGesture(document, QCoreApplication::translate("RotateGesture", "Turn %1")),
      centre_(boxOnSheet(document, pieces_).center()),
      from_(directionTo(centre_, pressed)) {
    if (pieces_.size() != 1) {
        return;
    }
    const int piece = pieces_.front();
    const Placement& placement = before_.at(piece);
    const double grain = grainOf(document_.settings()[static_cast<std::size_t>(piece)]);
    std::vector<double> directions = straightDirections(flatOutline(document_, piece));
    directions.push_back(grain);
    for (const double direction : directions) {
        const double now = directionOnSheet(placement, direction);
        good_.push_back(-now);
        good_.push_back(std::numbers::pi / 2 - now);
    }
    good_.push_back(-placement.turn);
    good_.push_back(std::numbers::pi / 2 - placement.turn);
}

double RotateGesture::snapped(double turn, const Pointer& pointer) const {
    if (pointer.modifiers.testFlag(Qt::ShiftModifier)) {
        // Turn a single piece to a multiple of the step, several pieces by one.
        const double begun = before_.size() == 1 ? before_.begin()->second.turn : 0.0;
        return std::round((begun + turn) / kStep) * kStep - begun;
    }
    return snaps(pointer) ? snappedAngle(turn, std::numbers::pi / 2, good_, kGoodAngle) : turn;
}

void RotateGesture::drag(ToolView& view, const Pointer& pointer) {
    pointer_ = pointer.at;
    const double turn = directionTo(centre_, view.onSheet(pointer.at)) - from_;
    turn_ = wrappedAngle(snapped(wrappedAngle(turn), pointer));
    PiecePlacements turned = before_;
    for (auto& [piece, placement] : turned) {
        placement = turnedAbout(placement, centre_, turn_);
    }
    lay(turned);
}

void RotateGesture::paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const {
    const QPointF middle = SheetMap(view)(centre_);
    painter.save();
    painter.setPen(QPen(style.selection, 1.5));
    painter.drawLine(middle - QPointF(5, 0), middle + QPointF(5, 0));
    painter.drawLine(middle - QPointF(0, 5), middle + QPointF(0, 5));
    painter.restore();
    paintNote(painter, style, pointer_, {angleWithUnit(turn_)});
}

}  // namespace toile::app
