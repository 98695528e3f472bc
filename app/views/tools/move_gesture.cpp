// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/move_gesture.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

#include "app/document/document.h"
#include "app/render/pattern_renderer.h"
#include "app/settings/length_display.h"
#include "app/views/tools/sheet_map.h"
#include "app/views/tools/tool_paint.h"

namespace toile {

namespace {

constexpr double kReach = 8;          // pixels
constexpr double kGridReaches = 2.5;  // that grid lines are apart at least: else all is near one

/// The finest grid that is drawn and wide enough to leave room between its lines.
double gridStep(double pixelsPerMillimetre) {
    const GridSteps steps = gridSteps(pixelsPerMillimetre, LengthDisplay::instance().format().unit);
    return steps.minor() * pixelsPerMillimetre >= kGridReaches * kReach ? steps.minor()
                                                                        : steps.major;
}

}  // namespace

Points2 cornersOnSheet(const Document& document, const std::vector<int>& pieces) {
    std::vector<Points2> outlines;
    Eigen::Index count = 0;
    for (const int piece : pieces) {
        Points2 outline = snapPoints(flatOutline(document, piece));
        const Placement placement = placementOf(document, piece);
        outline = (outline * placement.linear().transpose()).eval();
        outline.rowwise() += placement.offset.transpose();
        count += outline.rows();
        outlines.push_back(std::move(outline));
    }
    Points2 all(count, 2);
    Eigen::Index next = 0;
    for (const Points2& outline : outlines) {
        all.middleRows(next, outline.rows()) = outline;
        next += outline.rows();
    }
    return all;
}

MoveGesture::MoveGesture(Document& document, const Eigen::Vector2d& pressed)
    : document_(document), gesture_(document.newGesture()), pressed_(pressed) {
    const std::vector<int> moving = selectedFlat(document_);
    for (const int piece : moving) {
        before_[piece] = placementOf(document_, piece);
    }
    settingsBefore_ = document_.settings();
    box_ = boxOnSheet(document_, moving);
    corners_ = cornersOnSheet(document_, moving);
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
    const bool snaps = document_.view().snapping != pointer.modifiers.testFlag(Qt::AltModifier);
    targets_.gridStep = gridStep(view.pixelsPerMillimetre());
    move_ = snaps ? snappedMove(box_, corners_, way, targets_, kReach / view.pixelsPerMillimetre())
                  : SnappedMove{way};
    PiecePlacements moved = before_;
    for (auto& [piece, placement] : moved) {
        placement = movedBy(placement, move_.way);
    }
    place(document_, QCoreApplication::translate("MoveGesture", "Move"), moved, gesture_);
}

void MoveGesture::takeBack() {
    placeBack(document_, QCoreApplication::translate("MoveGesture", "Move"), before_,
              settingsBefore_, gesture_);
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

}  // namespace toile
