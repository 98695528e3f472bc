// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/select_tool.h"

#include <QApplication>
#include <QKeyEvent>
#include <cmath>
#include <utility>

#include "app/actions/cut_proposals.h"
#include "app/actions/workspace.h"
#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/settings/length_display.h"
#include "app/text/figures.h"
#include "app/views/feature_at.h"
#include "app/views/feature_text.h"
#include "app/views/navigation.h"
#include "app/views/tools/sheet_gestures.h"
#include "app/views/tools/tool_paint.h"
#include "core/base/units.h"

namespace toile::app {

namespace {

/// How far arrow keys move, mm: round in the person's unit.
double nudgeLength(bool large) {
    return LengthDisplay::instance().format().unit == LengthUnit::Inch
               ? millimetresPer(LengthUnit::Inch) / (large ? 2 : 16)
               : (large ? 10 : 1);
}

std::optional<Eigen::Vector2d> arrowOf(const QKeyEvent& event) {
    Qt::KeyboardModifiers others = event.modifiers() & ~Qt::KeyboardModifiers(Qt::ShiftModifier);
    if (kArrowsAreKeypad) {
        others &= ~Qt::KeyboardModifiers(Qt::KeypadModifier);
    }
    if (others) {
        return std::nullopt;  // of the keypad too: those choose a view
    }
    switch (event.key()) {
        case Qt::Key_Left:
            return Eigen::Vector2d(-1, 0);
        case Qt::Key_Right:
            return Eigen::Vector2d(1, 0);
        case Qt::Key_Up:
            return Eigen::Vector2d(0, 1);
        case Qt::Key_Down:
            return Eigen::Vector2d(0, -1);
        default:
            return std::nullopt;
    }
}

}  // namespace

SelectTool::SelectTool(Workspace& workspace)
    : workspace_(workspace),
      document_(workspace.document()),
      proposals_(workspace.proposals(), document_) {
    for (const auto signal : {&CutProposals::changed, &CutProposals::selectionChanged,
                              &CutProposals::opened, &CutProposals::closed}) {
        connect(&workspace.proposals(), signal, this, &Tool::changed);
    }
    connect(&document_, &Document::changed, this, [this](DocumentChanges what) {
        // The hint tells the lengths of the edge that is selected.
        if ((what & (DocumentChange::Mark | DocumentChange::SeamSelection)) ||
            (document_.mark() && what.testFlag(DocumentChange::Results))) {
            emit changed();
        }
    });
}

SelectTool::~SelectTool() = default;

QString SelectTool::hint(ViewKind view) const {
    const QString keys =
        view == ViewKind::Garment
            ? tr("Click: select a piece or a seam · Double click: frame a piece, or take an edge "
                 "from corner to corner · Esc: select nothing")
            : tr("Click: select a piece or a seam · Drag a piece: move it · Drag the sheet: select "
                 "by a box · Alt: snap the other way · Arrow keys: %1, with Shift %2 · Esc: "
                 "select nothing")
                  .arg(lengthWithUnit(nudgeLength(false)), lengthWithUnit(nudgeLength(true)));
    if (view == ViewKind::Garment && workspace_.proposals().isOpen()) {
        return tr("Click a dashed line: select the proposed cut · Drag a handle: move it · Esc: "
                  "close the proposals") +
               QStringLiteral(" · ") + keys;
    }
    const QString marked = markedText(document_);
    return marked.isEmpty() ? keys : marked + QStringLiteral(" · ") + keys;
}

Qt::CursorShape SelectTool::cursor(ViewKind view) const {
    if (view == ViewKind::Garment && (proposals_.isHeld() || proposals_.isOverHandle())) {
        return Qt::SizeAllCursor;
    }
    if (view == ViewKind::Pattern && hovered_ == Target::Handle) {
        return Qt::PointingHandCursor;
    }
    return view == ViewKind::Pattern && hovered_ == Target::Piece ? Qt::SizeAllCursor
                                                                  : Qt::ArrowCursor;
}

SelectTool::Target SelectTool::targetAt(const ToolView& view, const QPointF& at) const {
    if (isOnTurnHandle(document_, view, at)) {
        return Target::Handle;
    }
    return view.hitAt(at) ? Target::Piece : Target::Sheet;
}

bool SelectTool::press(ToolView& view, const Pointer& pointer) {
    if (view.kind() != ViewKind::Pattern) {
        return proposals_.press(view, pointer.at);
    }
    pressed_ = pointer;
    return true;
}

std::unique_ptr<SheetGesture> SelectTool::begin(ToolView& view, const Pointer& pressed) {
    const Eigen::Vector2d place = view.onSheet(pressed.at);
    const Target target = targetAt(view, pressed.at);
    if (target == Target::Handle) {
        return std::make_unique<RotateGesture>(document_, place);
    }
    if (target == Target::Sheet) {
        return std::make_unique<BoxGesture>(document_, place, pressed.adds());
    }
    const int piece = view.hitAt(pressed.at)->piece;
    if (!document_.isSelected(piece)) {
        Document::Selection selection =
            pressed.adds() ? document_.selection() : Document::Selection{};
        selection.insert(piece);
        document_.setSelection(std::move(selection));
    }
    return std::make_unique<MoveGesture>(document_, place);
}

void SelectTool::drag(ToolView& view, const Pointer& pointer) {
    if (proposals_.isHeld()) {
        proposals_.drag(view, pointer.at);
        return;
    }
    if (!pressed_) {
        return;
    }
    if (!gesture_) {
        if ((pointer.at - pressed_->at).manhattanLength() < QApplication::startDragDistance()) {
            return;
        }
        gesture_ = begin(view, *pressed_);
    } else if (gesture_->isStale()) {
        cancel();
        return;
    }
    gesture_->drag(view, pointer);
    emit changed();
}

void SelectTool::release(ToolView& view, const Pointer& pointer) {
    proposals_.release();
    const bool clicked = pressed_ && !gesture_;
    pressed_.reset();
    if (gesture_) {
        gesture_.reset();
        emit changed();
    } else if (clicked) {
        click(view, pointer);
    }
}

void SelectTool::click(ToolView& view, const Pointer& pointer) {
    if (!pointer.adds() && proposals_.select(view, pointer.at)) {
        return;
    }
    if (view.kind() == ViewKind::Pattern && isOnTurnHandle(document_, view, pointer.at)) {
        return;
    }
    if (pointer.adds() || !selectLineAt(view, document_, pointer.at)) {
        selectPieceAt(view, document_, pointer);
    }
}

void SelectTool::doubleClick(ToolView& view, const Pointer& pointer) {
    if (selectRunAt(view, document_, pointer.at)) {
        return;
    }
    if (const auto hit = view.hitAt(pointer.at)) {
        document_.setSelection({hit->piece});
        view.frameSelection();
    } else {
        view.frameAll();
    }
}

void SelectTool::hover(ToolView& view, const Pointer& pointer) {
    if (proposals_.hover(view, pointer.at)) {
        emit changed();
    }
    const Target target =
        view.kind() == ViewKind::Pattern ? targetAt(view, pointer.at) : Target::Sheet;
    if (target != hovered_) {
        hovered_ = target;
        emit changed();
    }
}

void SelectTool::leave(ToolView&) {
    const bool hasLeft = proposals_.leave();
    if (std::exchange(hovered_, Target::Sheet) != Target::Sheet || hasLeft) {
        emit changed();
    }
}

bool SelectTool::wants(const QKeyEvent& event) const {
    if (pressed_ || proposals_.isHeld()) {
        return event.key() == Qt::Key_Escape;
    }
    if (event.key() == Qt::Key_Escape && event.modifiers() == Qt::NoModifier) {
        // While something runs, the key stops that.
        return !workspace_.jobs().isBusy() && (!document_.selection().empty() || document_.seam() ||
                                               document_.mark() || workspace_.proposals().isOpen());
    }
    return arrowOf(event) && !document_.selection().empty();
}

void SelectTool::key(ToolView&, const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape) {
        if (pressed_ || proposals_.isHeld()) {
            cancel();
        } else if (workspace_.proposals().isOpen()) {
            workspace_.proposals().close();
        } else {
            selectNothing();
        }
    } else if (!pressed_) {
        nudge(event);
    }
}

void SelectTool::selectNothing() {
    document_.selectNothing();
}

void SelectTool::nudge(const QKeyEvent& event) {
    const auto arrow = arrowOf(event);
    if (!arrow) {
        return;
    }
    if (!event.isAutoRepeat() || nudging_ < 0) {
        nudging_ = document_.newGesture();
    }
    const bool large = event.modifiers().testFlag(Qt::ShiftModifier);
    PiecePlacements moved;
    for (const int piece : selectedFlat(document_)) {
        moved[piece] = movedBy(placementOf(document_, piece), nudgeLength(large) * *arrow);
    }
    place(document_, tr("Nudge %1"), moved, nudging_);
}

void SelectTool::cancel() {
    proposals_.cancel();
    pressed_.reset();
    nudging_ = -1;
    if (const auto gesture = std::exchange(gesture_, nullptr)) {
        if (!gesture->isStale()) {
            gesture->takeBack();
        }
        emit changed();
    }
}

void SelectTool::paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const {
    if (view.kind() != ViewKind::Pattern) {
        proposals_.paint(view, painter, style);
        return;
    }
    paintSelectionFrame(painter, style, document_, view, hovered_ == Target::Handle);
    if (gesture_) {
        gesture_->paint(view, painter, style);
    }
}

}  // namespace toile::app
