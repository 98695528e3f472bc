// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/grain_tool.h"

#include <QApplication>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/document/document.h"
#include "app/document/mirrored_edits.h"
#include "app/text/figures.h"
#include "app/views/feature_at.h"
#include "app/views/grain_arrow.h"
#include "app/views/tool.h"
#include "app/views/tools/tool_paint.h"
#include "core/base/units.h"
#include "core/geometry/segment.h"
#include "core/layout/snapping.h"

namespace toile::app {

namespace {

constexpr double kSnappingAngle = 3 * kDegree;
constexpr double kArrowGrab = 8;  // pixels around an arrow that is longer than its piece

double distanceToArrow(const SheetMap& onScreen, const GrainArrow& arrow, const QPointF& at) {
    return geometry::distanceToSegment(pixels(at), pixels(onScreen(arrow.end(-0.5))),
                                       pixels(onScreen(arrow.end(0.5))));
}

}  // namespace

QString GrainTool::hint(ViewKind view) const {
    if (view == ViewKind::Garment) {
        return tr("Turn the grain in the pattern view · Esc: leave the tool");
    }
    return turning_ ? tr("Drag: turn the grain · Alt: toggle snapping · Esc: cancel")
                    : tr("Drag on a piece: turn its grain · Alt: toggle snapping · Click: select · "
                         "Esc: leave the tool");
}

Qt::CursorShape GrainTool::cursor(ViewKind view) const {
    return view == ViewKind::Pattern ? Qt::CrossCursor : Qt::ArrowCursor;
}

std::optional<int> GrainTool::pieceAt(const ToolView& view, const QPointF& at) const {
    // Prefer an arrow over the cloth below it.
    const SheetMap onScreen(view);
    for (const int piece : allFlat(document_)) {
        const auto arrow = grainArrow(document_, piece, onScreen.pixelsPerMillimetre());
        if (arrow && distanceToArrow(onScreen, *arrow, at) < kArrowGrab) {
            return piece;
        }
    }
    const auto hit = view.hitAt(at);
    return hit ? std::optional(hit->piece) : std::nullopt;
}

bool GrainTool::press(ToolView& view, const Pointer& pointer) {
    if (view.kind() != ViewKind::Pattern) {
        return false;
    }
    const auto piece = pieceAt(view, pointer.at);
    const auto arrow =
        piece ? grainArrow(document_, *piece, view.pixelsPerMillimetre()) : std::nullopt;
    if (!arrow) {
        return false;
    }
    PieceGrains before;
    for (const int turned : withCounterparts(document_, {*piece})) {
        before[turned] = document_.settings()[static_cast<std::size_t>(turned)].grain;
    }
    turning_ = Turning{*piece,
                       document_.newGesture(),
                       std::move(before),
                       arrow->middle,
                       arrow->length,
                       std::atan2(arrow->direction.y(), arrow->direction.x()),
                       directionTo(arrow->middle, view.onSheet(pointer.at)),
                       pointer.at,
                       pointer.at};
    turning_->now = turning_->start;
    turning_->of = document_.garment();
    turning_->results = document_.results();
    const Placement placement = placementOf(document_, *piece);
    const Points2 outline = flatOutline(document_, *piece);
    std::vector<double> directions = straightDirections(outline);
    if (const auto nearest = nearestEdgeDirection(outline, placement.undone(arrow->middle))) {
        directions.push_back(*nearest);
    }
    for (const double direction : directions) {
        turning_->edges.push_back(directionOnSheet(placement, direction));
    }
    emit changed();
    return true;
}

void GrainTool::drag(ToolView& view, const Pointer& pointer) {
    if (!turning_) {
        return;
    }
    if (isStale(*turning_)) {
        cancel();
        return;
    }
    Turning& turning = *turning_;
    turning.pointer = pointer.at;
    if (!turning.moved &&
        (pointer.at - turning.pressed).manhattanLength() < QApplication::startDragDistance()) {
        return;
    }
    turning.moved = true;
    double angle =
        turning.start + directionTo(turning.middle, view.onSheet(pointer.at)) - turning.from;
    if (document_.view().snapping != pointer.modifiers.testFlag(Qt::AltModifier)) {
        angle =
            snappedAngle(wrappedAngle(angle), std::numbers::pi / 4, turning.edges, kSnappingAngle);
    }
    turning.now = wrappedAngle(angle);
    setGrain(document_, tr("Turn grain of %1"),
             {{turning.piece, directionOnPiece(placementOf(document_, turning.piece), angle)}},
             turning.gesture);
}

void GrainTool::release(ToolView& view, const Pointer& pointer) {
    const bool clicked = turning_ && !turning_->moved;
    turning_.reset();
    emit changed();
    if (clicked) {
        selectPieceAt(view, document_, pointer);
    }
}

void GrainTool::click(ToolView& view, const Pointer& pointer) {
    selectPieceAt(view, document_, pointer);
}

void GrainTool::hover(ToolView& view, const Pointer& pointer) {
    const int now = view.kind() == ViewKind::Pattern ? pieceAt(view, pointer.at).value_or(-1) : -1;
    if (now != hovered_) {
        hovered_ = now;
        emit changed();
    }
}

void GrainTool::leave(ToolView&) {
    if (hovered_ != -1) {
        hovered_ = -1;
        emit changed();
    }
}

void GrainTool::key(ToolView&, const QKeyEvent&) {
    if (turning_) {
        cancel();
    } else {
        emit finished();
    }
}

bool GrainTool::isStale(const Turning& turning) const {
    return turning.of != document_.garment() || turning.results != document_.results();
}

void GrainTool::cancel() {
    hovered_ = -1;
    if (!turning_) {
        return;
    }
    const Turning turning = std::move(*turning_);
    turning_.reset();
    // For another garment there is nothing to undo. Besides, the document may be in the middle of
    // an undo step when this is called.
    if (turning.moved && !isStale(turning)) {
        setGrain(document_, tr("Turn grain of %1"), turning.before, turning.gesture);
    }
    emit changed();
}

void GrainTool::paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const {
    if (view.kind() == ViewKind::Garment) {
        garmentArrows_.paint(painter, style, view, document_,
                             turning_ ? turning_->piece : hovered_);
        return;
    }
    if (turning_ && !isStale(*turning_)) {
        const Eigen::Vector2d direction(std::cos(turning_->now), std::sin(turning_->now));
        paintMarkedArrow(painter, style, view, {turning_->middle, direction, turning_->length});
    } else if (hovered_ >= 0 && hovered_ < document_.pieceCount()) {
        if (const auto arrow = grainArrow(document_, hovered_, view.pixelsPerMillimetre())) {
            paintMarkedArrow(painter, style, view, *arrow);
        }
    }
    if (turning_ && turning_->moved) {
        paintNote(painter, style, turning_->pointer, {angleWithUnit(turning_->now)});
    }
}

}  // namespace toile::app
