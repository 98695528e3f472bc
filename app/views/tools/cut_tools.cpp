// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/cut_tools.h"

#include <QApplication>
#include <algorithm>

#include "app/actions/workspace.h"
#include "core/geometry/segment.h"

namespace toile::app {

namespace {

/// A point this near to an edge, as a part of the edge's length, lies on it but for rounding.
constexpr double kOnRim = 1e-6;

bool liesOn(const Piece& whole, const PieceRim& rim, const Eigen::Vector3d& point) {
    return std::ranges::any_of(rim.uses, [&](int use) {
        const Eigen::Vector3d a = whole.mesh.V.row(whole.mesh.F(use / 3, use % 3));
        const Eigen::Vector3d b = whole.mesh.V.row(whole.mesh.F(use / 3, (use % 3 + 1) % 3));
        return geometry::distanceToSegment(point, a, b) <= kOnRim * (b - a).norm();
    });
}

}  // namespace

QString CutTool::hint(ViewKind) const {
    if (draft_.isEmpty()) {
        return tr(
            "Click: begin the cut, on an edge to open it there · Ctrl+click: along the "
            "mesh's edges · Esc: back to selecting");
    }
    return hasEnough()
               ? tr("Click: go on · Double click or Enter: cut · Backspace: take the last point "
                    "back · Esc: throw the cut away")
               : tr("Click: next point · Ctrl+click: along the mesh's edges · Backspace: take the "
                    "point back · Esc: throw the cut away");
}

bool LoopTool::fits(const ClothPoint& point) const {
    return point.on != ClothPoint::On::Own && PathTool::fits(point);
}

QString LoopTool::hint(ViewKind) const {
    if (draft_.isEmpty()) {
        return tr(
            "Click: begin a closed cut · Ctrl+click: along the mesh's edges · Esc: back to "
            "selecting");
    }
    return hasEnough()
               ? tr("Click: go on · Click the first point, double click or Enter: cut · "
                    "Backspace: take the last point back · Esc: throw the cut away")
               : tr("Click: next point, of three or more · Backspace: take the last point back · "
                    "Esc: throw the cut away");
}

QString DartTool::hint(ViewKind) const {
    return draft_.isEmpty() ? tr("Drag from an edge to the dart's tip, or click the edge and then "
                                 "the tip · Esc: back to selecting")
                            : tr("Click: the dart's tip · Ctrl+click: along the mesh's edges · "
                                 "Backspace or Esc: throw the dart away");
}

QString DartTool::remark(const ClothPoint& point) const {
    return draft_.isEmpty() && !point.isOnRim() ? tr("a dart begins at an edge") : QString();
}

bool DartTool::press(ToolView& view, const Pointer& pointer) {
    const auto place = placeAt(view, pointer);
    if (!draft_.isEmpty() || !place || !place->isOnRim()) {
        return false;
    }
    pressed_ = pointer.at;
    add(*place);
    return true;
}

void DartTool::drag(ToolView& view, const Pointer& pointer) {
    if (draft_.isEmpty()) {
        return;  // Escape was pressed meanwhile
    }
    draft_.setAlongEdges(pointer.modifiers.testFlag(Qt::ControlModifier));
    follow(view, pointer, placeAt(view, pointer));
}

void DartTool::release(ToolView& view, const Pointer& pointer) {
    if (draft_.isEmpty() ||
        (pointer.at - pressed_).manhattanLength() < QApplication::startDragDistance()) {
        return;  // no drag: the tip follows with the next click
    }
    const auto place = placeAt(view, pointer);
    if (place && fits(*place)) {
        add(*place);
        finish();
    } else {
        cancel();
    }
}

void DartTool::click(ToolView& view, const Pointer& pointer) {
    PathTool::click(view, pointer);
    if (hasEnough()) {
        finish();
    }
}

UserCut::Kind DartTool::kindFor(const std::vector<ClothPoint>& points) {
    // A dart's beginning is moved onto the rim of the piece as it was before other cuts. One that
    // begins at such a cut must stay there.
    const Eigen::Vector3d begin = positionOf(draft_.piece()->mesh, points.front().at);
    const auto& uncut = workspace_.document().garment()->uncut;
    const bool isAtRim = std::ranges::any_of(uncut, [&](const auto& whole) {
        return whole == draft_.piece() || liesOn(*whole, snapper_.rim(whole), begin);
    });
    return isAtRim ? UserCut::Kind::Dart : UserCut::Kind::Path;
}

}  // namespace toile::app
