// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/rotate_gesture.h"

#include <QCoreApplication>
#include <QPainter>
#include <cmath>
#include <numbers>

#include "app/document/document.h"
#include "app/text/figures.h"
#include "app/views/tools/sheet_map.h"
#include "app/views/tools/tool_paint.h"
#include "core/base/angle.h"
#include "core/sheet/snapping.h"

namespace toile {

namespace {

constexpr double kStep = 15 * kDegree;
constexpr double kGoodAngle = 3 * kDegree;

}  // namespace

RotateGesture::RotateGesture(Document& document, const Eigen::Vector2d& pressed)
    : document_(document), gesture_(document.newGesture()) {
    const std::vector<int> pieces = selectedFlat(document_);
    for (const int piece : pieces) {
        before_[piece] = placementOf(document_, piece);
    }
    settingsBefore_ = document_.settings();
    centre_ = boxOnSheet(document_, pieces).center();
    from_ = directionTo(centre_, pressed);
    if (pieces.size() != 1) {
        return;
    }
    const int piece = pieces.front();
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
        // A single piece comes to lie at a multiple, several are turned by one.
        const double begun = before_.size() == 1 ? before_.begin()->second.turn : 0.0;
        return std::round((begun + turn) / kStep) * kStep - begun;
    }
    if (document_.view().snapping == pointer.modifiers.testFlag(Qt::AltModifier)) {
        return turn;
    }
    return snappedAngle(turn, std::numbers::pi / 2, good_, kGoodAngle);
}

void RotateGesture::drag(ToolView& view, const Pointer& pointer) {
    pointer_ = pointer.at;
    const double turn = directionTo(centre_, view.onSheet(pointer.at)) - from_;
    turn_ = wrappedAngle(snapped(wrappedAngle(turn), pointer));
    PiecePlacements turned = before_;
    for (auto& [piece, placement] : turned) {
        placement = turnedAbout(placement, centre_, turn_);
    }
    place(document_, QCoreApplication::translate("RotateGesture", "Turn"), turned, gesture_);
}

void RotateGesture::takeBack() {
    placeBack(document_, QCoreApplication::translate("RotateGesture", "Turn"), before_,
              settingsBefore_, gesture_);
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

}  // namespace toile
