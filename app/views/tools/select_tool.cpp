// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/select_tool.h"

#include <QApplication>
#include <QFontMetricsF>
#include <QKeyEvent>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <limits>
#include <utility>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/render/render_style.h"
#include "app/session/cut_proposals.h"
#include "app/session/workspace.h"
#include "app/settings/length_display.h"
#include "app/text/figures.h"
#include "app/views/feature_at.h"
#include "app/views/feature_text.h"
#include "app/views/navigation.h"
#include "app/views/tools/sheet_gestures.h"
#include "app/views/tools/tool_paint.h"
#include "core/base/units.h"
#include "core/geometry/segment.h"

namespace toile::app {
namespace {

constexpr double kSpacing = 6;                   // mm, between points of drawn lines
constexpr double kReach = 7, kHandleReach = 10;  // pixels
constexpr double kHair = 1.4, kThin = 2, kThick = 3.4, kHalo = 2.4;
constexpr double kRound = 4.5;                              // radius of a handle
constexpr int kFaint = 190, kFaintHalo = 55, kBehind = 70;  // of 255
constexpr double kBesideName = 10;

using Screen = std::optional<ToolView::WornPlace>;

double distanceTo(const QPointF& at, const QPointF& a, const QPointF& b) {
    const auto vector = [](const QPointF& p) { return Eigen::Vector2d(p.x(), p.y()); };
    return geometry::distanceToSegment(vector(at), vector(a), vector(b));
}

/// Step of the arrow keys, mm: round in the user's unit.
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
        return std::nullopt;  // arrow keys of the number pad select a view
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

bool ProposalLines::areShown(const ToolView& view) const {
    return proposals_.state() == CutProposals::State::Known && view.kind() == ViewKind::Garment;
}

const std::vector<ProposalLines::Line>& ProposalLines::lines() const {
    const auto& cuts = proposals_.lines();
    lines_.resize(cuts.size());
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        if (lines_[k].points != cuts[k].points) {
            lines_[k] = {cuts[k].points, proposals_.shaper()->drawn(cuts[k], kSpacing)};
        }
    }
    return lines_;
}

std::optional<ProposalLines::Handle> ProposalLines::handleAt(const ToolView& view,
                                                             const QPointF& at) const {
    const auto selected = proposals_.selected();
    if (!areShown(view) || !selected) {
        return std::nullopt;
    }
    std::optional<Handle> nearest;
    double least = kHandleReach;
    for (const int point : handlesOf(proposals_.lines(), *selected)) {
        const Screen place =
            view.wornPlace(proposals_.lines()[*selected].points[static_cast<std::size_t>(point)]);
        const double distance = place && !place->isHidden ? QLineF(place->at, at).length() : least;
        if (distance < least) {
            least = distance;
            nearest = Handle{*selected, point};
        }
    }
    return nearest;
}

std::optional<std::size_t> ProposalLines::lineAt(const ToolView& view, const QPointF& at) const {
    std::optional<std::size_t> nearest;
    double least = kReach;
    for (std::size_t k = 0; areShown(view) && k < lines().size(); ++k) {
        Screen before;
        for (const Eigen::Vector3d& point : lines_[k].drawn) {
            const Screen place = view.wornPlace(point);
            if (before && place && !before->isHidden && !place->isHidden) {
                const double distance = distanceTo(at, before->at, place->at);
                if (distance < least) {
                    least = distance;
                    nearest = k;
                }
            }
            before = place;
        }
    }
    return nearest;
}

bool ProposalLines::isHeld() const {
    return held_ && proposals_.isMoving();
}

bool ProposalLines::press(const ToolView& view, const QPointF& at) {
    held_ = handleAt(view, at);
    if (held_) {
        proposals_.beginMove(held_->cut, held_->point);
    }
    return isHeld();
}

void ProposalLines::drag(const ToolView& view, const QPointF& at) {
    const CutShaper& shaper = *proposals_.shaper();
    const Eigen::Vector3d from =
        proposals_.lines()[held_->cut].points[static_cast<std::size_t>(held_->point)];
    // An end on a rim slides along the rim, even if the pointer is beside the cloth.
    if (const auto rim = shaper.rimThrough(from, kSpacing); !rim.empty()) {
        std::optional<Eigen::Vector3d> nearest;
        double least = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector3d& point : rim) {
            const Screen place = view.wornPlace(point);
            const double distance = place ? QLineF(place->at, at).length() : least;
            if (distance < least) {
                least = distance;
                nearest = point;
            }
        }
        if (nearest) {
            proposals_.moveTo(*nearest);
        }
    } else if (const auto hit = view.hitAt(at)) {
        const auto& piece = document_.garment()->pieces[static_cast<std::size_t>(hit->piece)];
        proposals_.moveTo(positionOf(piece->mesh, {hit->face, hit->barycentric}));
    }
}

void ProposalLines::release() {
    if (std::exchange(held_, std::nullopt)) {
        proposals_.endMove();
    }
}

void ProposalLines::cancel() {
    if (std::exchange(held_, std::nullopt)) {
        proposals_.cancelMove();
    }
    hovered_.reset();
}

bool ProposalLines::select(const ToolView& view, const QPointF& at) {
    const auto line = lineAt(view, at);
    if (line) {
        proposals_.select(line);
    }
    return line.has_value();
}

bool ProposalLines::hover(const ToolView& view, const QPointF& at) {
    const auto now = handleAt(view, at);
    return std::exchange(hovered_, now) != now;
}

bool ProposalLines::leave() {
    return std::exchange(hovered_, std::nullopt).has_value();
}

void ProposalLines::paintLine(const ToolView& view, QPainter& painter, const RenderStyle& style,
                              std::size_t cut) const {
    const bool isSelected = proposals_.selected() == cut;
    QPainterPath seen, hidden;
    QPointF name;
    double highest = std::numeric_limits<double>::infinity();
    Screen before;
    for (const Eigen::Vector3d& point : lines_[cut].drawn) {
        const Screen place = view.wornPlace(point);
        if (place && before) {
            QPainterPath& path = place->isHidden || before->isHidden ? hidden : seen;
            if (path.isEmpty() || path.currentPosition() != before->at) {
                path.moveTo(before->at);
            }
            path.lineTo(place->at);
        }
        if (place && !place->isHidden && place->at.y() < highest) {
            highest = place->at.y();
            name = place->at;
        }
        before = place;
    }
    QColor colour = style.seam;
    QColor halo = style.seamHalo;
    const bool isFaint = !proposals_.isTaken(cut) && !isSelected;
    if (isFaint) {
        colour.setAlpha(kFaint);
        halo.setAlpha(kFaintHalo);
    }
    const double width = isSelected ? kThick : isFaint ? kHair : kThin;
    QPen pen(colour, width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    pen.setDashPattern({3.2, 2});
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(halo, width + kHalo, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(seen);
    painter.setPen(pen);
    painter.drawPath(seen);
    colour.setAlpha(kBehind);
    pen.setColor(colour);
    painter.setPen(pen);
    painter.drawPath(hidden);
    if (isSelected && std::isfinite(highest)) {
        const QString text = QString::fromStdString(proposals_.lines()[cut].name);
        const QFontMetricsF metrics(painter.font());
        QRectF box(0, 0, metrics.horizontalAdvance(text) + 12, metrics.height() + 4);
        box.moveBottomLeft(name + QPointF(kBesideName, -kBesideName / 2));
        QColor ground = style.labelFill;
        ground.setAlpha(235);
        painter.setPen(QPen(style.faintText, 1));
        painter.setBrush(ground);
        painter.drawRoundedRect(box, 5, 5);
        painter.setPen(style.text);
        painter.drawText(box, Qt::AlignCenter, text);
    }
}

void ProposalLines::paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const {
    if (!areShown(view)) {
        return;
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const auto selected = proposals_.selected();
    for (std::size_t k = 0; k < lines().size(); ++k) {
        if (selected != k) {
            paintLine(view, painter, style, k);
        }
    }
    if (selected) {
        paintLine(view, painter, style, *selected);
        for (const int point : handlesOf(proposals_.lines(), *selected)) {
            const Screen place = view.wornPlace(
                proposals_.lines()[*selected].points[static_cast<std::size_t>(point)]);
            if (place && !place->isHidden) {
                const bool isHot =
                    hovered_ == Handle{*selected, point} || held_ == Handle{*selected, point};
                painter.setPen(QPen(style.seamHalo, 4));
                painter.drawEllipse(place->at, kRound, kRound);
                painter.setPen(QPen(style.seam, 2));
                painter.setBrush(isHot ? style.seam : style.seamHalo);
                painter.drawEllipse(place->at, kRound, kRound);
            }
        }
    }
    painter.restore();
}

SelectTool::SelectTool(Workspace& workspace)
    : workspace_(workspace),
      document_(workspace.document()),
      proposals_(workspace.proposals(), document_) {
    for (const auto signal : {&CutProposals::changed, &CutProposals::selectionChanged,
                              &CutProposals::opened, &CutProposals::closed}) {
        connect(&workspace.proposals(), signal, this, &Tool::changed);
    }
    // The hint includes the lengths of the selected edge.
    connect(&document_, &Document::changed, this, &Tool::changed);
}

SelectTool::~SelectTool() = default;

QString SelectTool::hint(ViewKind view) const {
    const QString keys =
        view == ViewKind::Garment
            ? tr("Click: select a piece or a seam · Double click: frame a piece, or select an edge "
                 "from corner to corner · Esc: clear the selection")
            : tr("Click: select a piece or a seam · Drag a piece: move it · Drag the sheet: select "
                 "with a box · Alt: toggle snapping · Arrow keys: %1, with Shift %2 · Esc: clear "
                 "the selection")
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
        // While a job runs, Escape stops the job.
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
