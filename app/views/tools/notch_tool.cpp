// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/notch_tool.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/render/render_style.h"
#include "app/text/figures.h"
#include "app/views/tools/tool_paint.h"
#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/notch_mark.h"
#include "core/pattern/pattern.h"
#include "core/pattern/piece_allowance.h"
#include "core/pattern/walk.h"

namespace toile::app {

namespace {

/// Picking distances of a seam, of a notch, and of the seam of a dragged notch, pixels.
constexpr double kSeamReach = 8, kNotchReach = 9, kDragReach = 400;
constexpr double kSpot = 4.5;        // pixels, radius
constexpr double kSameNotch = 1e-6;  // as a share of the seam
constexpr Qt::KeyboardModifier kRemoves = Qt::ControlModifier;

const Seam* sewnSeam(const Document& document, int seam) {
    // For a moment, the scene may belong to the previous garment.
    if (!document.garment() || seam < 0 || seam >= document.seamCount()) {
        return nullptr;
    }
    const Seam& there = document.garment()->seams.seams[static_cast<std::size_t>(seam)];
    return there.kind == SeamKind::Free || there.matches.empty() ? nullptr : &there;
}

double shareAt(const Seam& seam, const SeamHit& hit) {
    const SeamSide& side = hit.side == 0 ? seam.left : seam.right;
    const double arc = side.start + hit.along * (side.end - side.start);
    return shareOf(seam, placeOnSide(seam, hit.side == 1, arc));
}

/// Converts a share of a seam to a position along one side.
double alongSide(const Seam& seam, int side, double share) {
    const SeamMatch at = placeAtShare(seam, share);
    const SeamSide& on = side == 0 ? seam.left : seam.right;
    return ((side == 0 ? at.left : at.right) - on.start) / (on.end - on.start);
}

bool isSameNotch(const NotchAt& one, const NotchAt& other) {
    return one.seam == other.seam && std::abs(one.share - other.share) < kSameNotch;
}

/// Text with the distances to both ends of the seam, along its left side.
QStringList noteOf(const QString& name, const Seam& seam, double share) {
    const double from = std::abs(placeAtShare(seam, share).left - seam.left.start);
    return {name, QString("%1 | %2").arg(lengthWithUnit(from),
                                         lengthWithUnit(seam.left.length() - from))};
}

}  // namespace

QString NotchTool::hint(ViewKind) const {
    return moving_ ? tr("Drag: move the notch along its seam · Esc: cancel")
                   : tr("Click a seam: add a notch · Drag a notch: move it · Ctrl+click or Del: "
                        "delete it · Esc: leave the tool");
}

Qt::CursorShape NotchTool::cursor(ViewKind) const {
    return moving_ || (hovered_ && hovered_->isNotch) ? Qt::PointingHandCursor : Qt::CrossCursor;
}

void NotchTool::find() const {
    const std::shared_ptr<const Pattern>& pattern = document_.derived().pattern;
    if (pattern == of_.lock() && (pattern || notches_.empty())) {
        return;
    }
    of_ = pattern;
    marks_.clear();
    notches_ = pattern ? notchesOf(*pattern) : std::vector<SeamNotch>{};
    for (std::size_t i = 0; pattern && i < pattern->pieces.size(); ++i) {
        const PatternPiece& piece = pattern->pieces[i];
        std::optional<geometry::Line> outline;
        for (const PieceNotch& notch : piece.notches) {
            if (notch.hole >= 0) {
                continue;
            }
            if (!outline) {
                outline = geometry::Line::closed(piece.outline);
            }
            const NotchSpot spot = notchSpot(*outline, notch.at);
            const double width = allowanceAt(piece, outline->length(), notch.at);
            marks_.push_back({{notch.seam - 1, notch.share},
                              static_cast<int>(i),
                              spot.point,
                              spot.point + width * spot.outward});
        }
    }
}

const std::vector<NotchTool::Mark>& NotchTool::marks() const {
    find();
    return marks_;
}

const std::vector<SeamNotch>& NotchTool::notches() const {
    find();
    return notches_;
}

std::optional<SeamNotch> NotchTool::known(const NotchAt& at) const {
    const auto found = std::ranges::find_if(
        notches(), [&at](const SeamNotch& notch) { return isSameNotch(notch, at); });
    return found == notches().end() ? std::nullopt : std::optional(*found);
}

std::optional<NotchAt> NotchTool::markAt(const ToolView& view, const QPointF& at) const {
    const SheetMap onScreen(view);
    std::optional<NotchAt> nearest;
    double least = kNotchReach;
    for (const Mark& mark : marks()) {
        if (mark.piece >= document_.pieceCount()) {
            continue;
        }
        const Placement placement = placementOf(document_, mark.piece);
        const double distance =
            geometry::distanceToSegment(pixels(at), pixels(onScreen(placement.applied(mark.foot))),
                                        pixels(onScreen(placement.applied(mark.head))));
        if (distance < least) {
            least = distance;
            nearest = mark.at;
        }
    }
    return nearest;
}

std::optional<NotchTool::Pointed> NotchTool::pointedAt(const ToolView& view,
                                                       const QPointF& at) const {
    if (view.kind() == ViewKind::Pattern) {
        if (const auto mark = markAt(view, at); mark && sewnSeam(document_, mark->seam)) {
            return Pointed{*mark, true};
        }
    }
    const auto hit = view.seamHitAt(
        at, kSeamReach, [this](int seam) { return sewnSeam(document_, seam) != nullptr; });
    if (!hit) {
        return std::nullopt;
    }
    const Seam& seam = *sewnSeam(document_, hit->seam);
    for (const SeamNotch& notch : notches()) {
        if (notch.seam == hit->seam) {
            const auto there =
                view.onSeam(hit->seam, hit->side, alongSide(seam, hit->side, notch.share));
            if (there && QLineF(*there, at).length() < kNotchReach) {
                return Pointed{notch, true};
            }
        }
    }
    return Pointed{{hit->seam, shareAt(seam, *hit)}, false};
}

void NotchTool::show(const std::optional<Pointed>& pointed) {
    if (hovered_ != pointed) {
        hovered_ = pointed;
        emit changed();
    }
}

void NotchTool::hover(ToolView& view, const Pointer& pointer) {
    pointer_ = pointer.at;
    pointerView_ = view.kind();
    show(pointedAt(view, pointer.at));
}

void NotchTool::leave(ToolView&) {
    show(std::nullopt);
}

bool NotchTool::press(ToolView& view, const Pointer& pointer) {
    const auto pointed = pointedAt(view, pointer.at);
    const auto notch = pointed && pointed->isNotch ? known(*pointed) : std::nullopt;
    if (!notch) {
        return false;
    }
    moving_ = Moving{*notch, notch->share, pointer.at, pointer.modifiers.testFlag(kRemoves)};
    pointer_ = pointer.at;
    pointerView_ = view.kind();
    emit changed();
    return true;
}

void NotchTool::drag(ToolView& view, const Pointer& pointer) {
    if (!moving_) {
        return;
    }
    if (!moving_->moved &&
        (pointer.at - moving_->pressed).manhattanLength() < QApplication::startDragDistance()) {
        return;
    }
    moving_->moved = true;
    pointer_ = pointer.at;
    const int seam = moving_->notch.seam;
    const auto hit =
        view.seamHitAt(pointer.at, kDragReach, [seam](int other) { return other == seam; });
    if (const Seam* there = sewnSeam(document_, seam); hit && there) {
        moving_->share = shareAt(*there, *hit);
    }
    emit changed();
}

void NotchTool::release(ToolView&, const Pointer&) {
    const std::optional<Moving> moving = std::exchange(moving_, std::nullopt);
    if (!moving || !sewnSeam(document_, moving->notch.seam)) {
        return;
    }
    if (moving->moved) {
        selected_ = NotchAt{moving->notch.seam, moving->share};
        document_.setLines(
            withNotchMoved(document_.state().lines, *document_.garment(), moving->notch,
                           moving->share, document_.derived().symmetry.get()),
            tr("Move notch"));
    } else if (moving->removes) {
        remove(moving->notch);
    } else {
        selected_ = moving->notch;
    }
    emit changed();
}

void NotchTool::click(ToolView& view, const Pointer& pointer) {
    const auto pointed = pointedAt(view, pointer.at);
    selected_ = pointed;
    if (pointed && !pointed->isNotch && !pointer.modifiers.testFlag(kRemoves)) {
        document_.setView(&ViewState::notches, true);
        document_.setLines(withNotch(document_.state().lines, *document_.garment(), *pointed),
                           tr("Add notch"));
    }
    emit changed();
}

std::optional<SeamNotch> NotchTool::target() const {
    if (hovered_ && hovered_->isNotch) {
        return known(*hovered_);
    }
    return selected_ ? known(*selected_) : std::nullopt;
}

void NotchTool::remove(const SeamNotch& notch) {
    selected_.reset();
    hovered_.reset();
    document_.setLines(withoutNotch(document_.state().lines, *document_.garment(), notch,
                                    document_.derived().symmetry.get()),
                       tr("Delete notch"));
    emit changed();
}

bool NotchTool::wants(const QKeyEvent& event) const {
    const bool removes = event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace;
    return Tool::wants(event) || (removes && !moving_ && target());
}

void NotchTool::key(ToolView&, const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape) {
        if (moving_) {
            moving_.reset();
            emit changed();
        } else {
            emit finished();
        }
    } else if (const auto notch = target()) {
        remove(*notch);
    }
}

void NotchTool::cancel() {
    hovered_.reset();
    selected_.reset();
    moving_.reset();
    emit changed();
}

void NotchTool::paintSpot(const ToolView& view, QPainter& painter, const RenderStyle& style,
                          const NotchAt& at, bool filled, bool strong) const {
    const Seam& seam = *sewnSeam(document_, at.seam);
    const double radius = strong ? 1.3 * kSpot : kSpot;
    for (const int side : {0, 1}) {
        const auto there = view.onSeam(at.seam, side, alongSide(seam, side, at.share));
        if (!there) {
            continue;
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(style.seamHalo, 4));
        painter.drawEllipse(*there, radius, radius);
        const QColor colour = strong ? style.selection : style.seam;
        painter.setPen(QPen(colour, 2));
        QColor inside = filled ? colour : style.labelFill;
        inside.setAlpha(255);  // opaque on its seam
        painter.setBrush(inside);
        painter.drawEllipse(*there, radius, radius);
    }
}

void NotchTool::paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const {
    std::optional<Pointed> shown = hovered_;
    if (moving_) {
        shown = Pointed{{moving_->notch.seam, moving_->share}, true};
    }
    const Seam* seam = shown ? sewnSeam(document_, shown->seam) : nullptr;
    painter.save();
    if (seam) {
        for (const QPolygonF& line : view.seamOnScreen(shown->seam)) {
            painter.setPen(QPen(style.seamHalo, 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            painter.drawPolyline(line);
            painter.setPen(QPen(style.seam, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            painter.drawPolyline(line);
        }
        for (const SeamNotch& notch : notches()) {
            if (notch.seam == shown->seam && !(moving_ && isSameNotch(notch, moving_->notch))) {
                paintSpot(view, painter, style, notch, true, false);
            }
        }
    }
    if (selected_ && !moving_ && known(*selected_) && sewnSeam(document_, selected_->seam)) {
        paintSpot(view, painter, style, *selected_, true, true);
    }
    if (seam) {
        paintSpot(view, painter, style, *shown, shown->isNotch, shown->isNotch);
    }
    painter.restore();
    if (seam && view.kind() == pointerView_) {
        paintNote(painter, style, pointer_,
                  noteOf(seamName(document_, shown->seam), *seam, shown->share));
    }
}

}  // namespace toile::app
