// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/cut_tools.h"

#include <QApplication>
#include <algorithm>
#include <limits>

#include "app/session/workspace.h"
#include "core/geometry/segment.h"

namespace toile::app {

namespace {

/// Rounding tolerance for a point on an edge, as a share of the edge's length.
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
            "Click: start the cut; on an edge, it opens there · Alt+click: cut around a tube · "
            "Ctrl+click: follow mesh edges · Esc: leave the tool");
    }
    return hasEnough() ? tr("Click: next point · Alt: no snapping · Double click or Enter: cut · "
                            "Backspace: remove the last point · Esc: discard the cut")
                       : tr("Click: next point · Alt: no snapping · Ctrl+click: follow mesh edges "
                            "· Backspace: remove the point · Esc: discard the cut");
}

bool LoopTool::fits(const ClothPoint& point) const {
    return point.on != ClothPoint::On::Own && PathTool::fits(point);
}

QString LoopTool::hint(ViewKind) const {
    if (draft_.isEmpty()) {
        return tr(
            "Click: start a closed cut · Alt+click: cut around a tube · Ctrl+click: follow mesh "
            "edges · Esc: leave the tool");
    }
    return hasEnough() ? tr("Click: next point · Click the first point, double click or Enter: cut "
                            "· Backspace: remove the last point · Esc: discard the cut")
                       : tr("Click: next point (three or more) · Backspace: remove the last point "
                            "· Esc: discard the cut");
}

QString DartTool::hint(ViewKind) const {
    if (hasEnough()) {
        return tr(
            "Enter: cut the proposed dart · Drag from an edge: draw another · Esc: discard the "
            "dart");
    }
    return draft_.isEmpty() ? tr("Drag from an edge to the dart's tip, or click the edge and then "
                                 "the tip · Esc: leave the tool")
                            : tr("Click: tip of the dart · Ctrl+click: follow mesh edges · "
                                 "Backspace or Esc: discard the dart");
}

QString DartTool::remark(const ClothPoint& point) const {
    return draft_.isEmpty() && !point.isOnRim() ? tr("a dart must start at an edge") : QString();
}

bool DartTool::press(ToolView& view, const Pointer& pointer) {
    if (hasEnough()) {
        cancel();  // a new press replaces the proposal
    }
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
        return;  // Escape was pressed during the drag
    }
    draft_.setAlongEdges(pointer.modifiers.testFlag(Qt::ControlModifier));
    follow(view, pointer, placeAt(view, pointer));
}

void DartTool::release(ToolView& view, const Pointer& pointer) {
    if (draft_.isEmpty() ||
        (pointer.at - pressed_).manhattanLength() < QApplication::startDragDistance()) {
        return;  // a click: the next one sets the tip
    }
    const auto place = placeAt(view, pointer);
    if (place && fits(*place)) {
        add(*place);
        finish();
    } else {
        cancel();
    }
}

void DartTool::propose(int piece, const Eigen::Vector2d& flat) {
    const Document& document = workspace_.document();
    const auto index = static_cast<std::size_t>(piece);
    if (index >= document.results().size() || !document.results()[index] ||
        !document.results()[index]->flat ||
        document.results()[index]->piece != document.garment()->pieces[index]) {
        return;
    }
    const Triangles& F = document.garment()->pieces[index]->mesh.F;
    const Points2& Q = document.results()[index]->flat->Q;
    const auto corner = [&](int face, int k) -> Eigen::Vector2d {
        return Q.row(F(face, k)).transpose();
    };
    ClothPoint tip{piece, {}, ClothPoint::On::Cloth, -1};
    double nearest = std::numeric_limits<double>::infinity();
    for (int face = 0; face < static_cast<int>(F.rows()); ++face) {
        const auto lifted = [&](int k) -> Eigen::Vector3d {
            return {corner(face, k).x(), corner(face, k).y(), 0};
        };
        const Eigen::Vector3d weights =
            nearestInTriangle({flat.x(), flat.y(), 0}, lifted(0), lifted(1), lifted(2));
        const double distance = (flatPositionOf(Q, F, {face, weights}).transpose() - flat).norm();
        if (distance < nearest) {
            nearest = distance;
            tip.at = {face, weights};
        }
    }
    ClothPoint begin{piece, {}, ClothPoint::On::Rim, -1};
    nearest = std::numeric_limits<double>::infinity();
    for (const int use : snapper_.rim(document.garment()->pieces[index]).uses) {
        const int face = use / 3, k = use % 3, next = (k + 1) % 3;
        const Eigen::Vector2d a = corner(face, k), b = corner(face, next);
        const double share = geometry::nearestShare(flat, a, b);
        const double distance = (a + share * (b - a) - flat).norm();
        if (distance < nearest) {
            nearest = distance;
            begin.at = {
                face, (1 - share) * Eigen::Vector3d::Unit(k) + share * Eigen::Vector3d::Unit(next)};
        }
    }
    cancel();
    draft_.setAlongEdges(false);
    add(begin);
    add(tip);
}

void DartTool::click(ToolView& view, const Pointer& pointer) {
    PathTool::click(view, pointer);
    if (hasEnough()) {
        finish();
    }
}

UserCut::Kind DartTool::kindFor(const std::vector<ClothPoint>& points) {
    // A dart's start is moved to the edge of the piece as it was before other cuts. A dart that
    // starts at one of those cuts must stay there.
    const Eigen::Vector3d begin = positionOf(draft_.piece()->mesh, points.front().at);
    const auto& uncut = workspace_.document().garment()->uncut;
    const bool isAtRim = std::ranges::any_of(uncut, [&](const auto& whole) {
        return whole == draft_.piece() || liesOn(*whole, snapper_.rim(whole), begin);
    });
    return isAtRim ? UserCut::Kind::Dart : UserCut::Kind::Path;
}

}  // namespace toile::app
