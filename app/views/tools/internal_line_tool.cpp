// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/internal_line_tool.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <limits>
#include <utility>

#include "app/document/line_edits.h"
#include "app/document/mirrored_edits.h"
#include "app/render/render_style.h"
#include "app/session/workspace.h"
#include "app/views/tools/tool_paint.h"
#include "core/assemble/file_space.h"
#include "core/geometry/segment.h"
#include "core/pattern/pattern.h"

namespace toile::app {

namespace {

constexpr double kLineReach = 7, kPointReach = 8;  // pixels
constexpr std::size_t kMinClosed = 3;              // points

Eigen::Vector3d wornPlace(const Document& document, int piece, const SurfacePoint& at) {
    return positionOf(document.garment()->pieces[static_cast<std::size_t>(piece)]->mesh, at);
}

/// The pattern pieces if they match the garment; the pattern may still be of the previous one.
std::span<const PatternPiece> shownPieces(const Document& document) {
    const auto& pattern = document.derived().pattern;
    return document.garment() && pattern &&
                   pattern->pieces.size() == document.garment()->pieces.size()
               ? std::span<const PatternPiece>(pattern->pieces)
               : std::span<const PatternPiece>();
}

/// True if the visible cloth at a pixel is of the same piece, near the place.
bool isSeenAt(const ToolView& view, const Document& document, const QPointF& pixel,
              const ClothPoint& at) {
    const auto hit = view.hitAt(pixel);
    if (view.kind() == ViewKind::Pattern || !hit) {
        return true;
    }
    const double reach = 4 * kPointReach / view.pixelsPerMillimetre();
    return hit->piece == at.piece &&
           (wornPlace(document, hit->piece, {hit->face, hit->barycentric}) -
            wornPlace(document, at.piece, at.at))
                   .norm() < reach;
}

}  // namespace

QString InternalLineTool::hint(ViewKind) const {
    if (moving_) {
        return tr("Drag: move the point · Esc: cancel");
    }
    if (draft_.isEmpty()) {
        return tr(
            "Click: start a line · Click a line: select it · Drag a point: move it · Del: delete "
            "the line · Esc: leave the tool");
    }
    return draft_.points().size() < kMinClosed
               ? tr("Click: next point · Double click or Enter: end the line · Backspace: remove "
                    "the last point · Esc: discard the line")
               : tr("Click: next point · Click the first point: close the line · Double click or "
                    "Enter: end it · Backspace: remove the last point · Esc: discard the line");
}

QString InternalLineTool::elsewhere() const {
    return tr("a line must stay on one piece");
}

const std::vector<InternalLine>& InternalLineTool::lines() const {
    return workspace_.document().state().lines.internalLines;
}

std::optional<std::size_t> InternalLineTool::selected() const {
    const auto found = selected_ ? std::ranges::find(lines(), *selected_) : lines().end();
    return found == lines().end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - lines().begin()));
}

std::optional<std::size_t> InternalLineTool::imageOf(std::size_t line) const {
    const Document& document = workspace_.document();
    const Symmetry* symmetry = editSymmetry(document);
    return symmetry ? imageOfInternalLine(document.state().lines, *document.garment(),
                                          document.results(), *symmetry, line)
                    : std::nullopt;
}

void InternalLineTool::select(std::optional<std::size_t> line) {
    selected_ = line && *line < lines().size() ? std::optional(lines()[*line]) : std::nullopt;
    emit changed();
}

std::optional<std::size_t> InternalLineTool::lineAt(const ToolView& view, const QPointF& at) const {
    const Document& document = workspace_.document();
    std::optional<std::size_t> nearest;
    double least = kLineReach;
    int index = 0;
    for (const PatternPiece& piece : shownPieces(document)) {
        const int p = index++;
        for (const PieceInternal& internal : piece.internals) {
            std::optional<QPointF> before;
            for (const SurfacePoint& point : internal.way) {
                const auto here = view.onScreen(p, point.face, point.barycentric);
                if (here) {
                    const double distance = geometry::distanceToSegment(
                        pixels(at), pixels(before.value_or(*here)), pixels(*here));
                    if (distance < least &&
                        isSeenAt(view, document, *here, {p, point, ClothPoint::On::Cloth})) {
                        least = distance;
                        nearest = static_cast<std::size_t>(internal.line);
                    }
                }
                before = here;
            }
        }
    }
    return nearest;
}

std::vector<InternalLineTool::LinePoint> InternalLineTool::points() const {
    const Document& document = workspace_.document();
    const std::span<const PatternPiece> pieces = shownPieces(document);
    std::vector<LinePoint> found;
    for (std::size_t k = 0; k < lines().size() && !pieces.empty(); ++k) {
        const ClothPoints points = inPieceSpace(lines()[k].points, *document.garment());
        for (std::size_t i = 0; i < points.size(); ++i) {
            LinePoint nearest{k, i, {}};
            double least = std::numeric_limits<double>::infinity();
            for (int p = 0; p < static_cast<int>(pieces.size()); ++p) {
                for (const PieceInternal& internal :
                     pieces[static_cast<std::size_t>(p)].internals) {
                    for (const SurfacePoint& point : internal.way) {
                        const double distance = (wornPlace(document, p, point) - points[i]).norm();
                        if (internal.line == static_cast<int>(k) && distance < least) {
                            least = distance;
                            nearest.at = {p, point, ClothPoint::On::Cloth};
                        }
                    }
                }
            }
            if (nearest.at.piece >= 0) {
                found.push_back(nearest);
            }
        }
    }
    return found;
}

std::optional<InternalLineTool::LinePoint> InternalLineTool::pointAt(const ToolView& view,
                                                                     const QPointF& at) const {
    std::optional<LinePoint> nearest;
    double least = kPointReach;
    for (const LinePoint& point : points()) {
        const auto there = view.onScreen(point.at.piece, point.at.at.face, point.at.at.barycentric);
        const double distance = there ? QLineF(*there, at).length() : least;
        if (distance < least && isSeenAt(view, workspace_.document(), *there, point.at)) {
            least = distance;
            nearest = point;
        }
    }
    return nearest;
}

bool InternalLineTool::press(ToolView& view, const Pointer& pointer) {
    const auto point = draft_.isEmpty() ? pointAt(view, pointer.at) : std::nullopt;
    if (!point) {
        return false;
    }
    moving_ = Moving{*point, point->at, pointer.at};
    select(point->line);
    return true;
}

void InternalLineTool::drag(ToolView& view, const Pointer& pointer) {
    if (!moving_ || (!moving_->moved && (pointer.at - moving_->pressed).manhattanLength() <
                                            QApplication::startDragDistance())) {
        return;
    }
    moving_->moved = true;
    const Garment& garment = *workspace_.document().garment();
    const auto place = snapper_.find(view, garment, pointer.at, {});
    if (place && place->piece == moving_->from.at.piece) {
        moving_->to = *place;
    }
    emit changed();
}

void InternalLineTool::release(ToolView&, const Pointer&) {
    const std::optional<Moving> moving = std::exchange(moving_, std::nullopt);
    Document& document = workspace_.document();
    if (moving && moving->moved && document.garment()) {
        const LinePoint& from = moving->from;
        const std::optional<std::size_t> image = imageOf(from.line);
        LineSettings next =
            withInternalPointMoved(document.state().lines, *document.garment(), from.line,
                                   from.point, wornPlace(document, from.at.piece, moving->to.at));
        if (image) {
            next = withInternalLineAsImage(std::move(next), *document.garment(), document.results(),
                                           *editSymmetry(document), from.line, *image);
        }
        document.setLines(std::move(next), tr("Move internal line"));
        select(from.line);
    }
    emit changed();
}

void InternalLineTool::click(ToolView& view, const Pointer& pointer) {
    if (draft_.isEmpty()) {
        select(lineAt(view, pointer.at));
        if (selected_) {
            return;
        }
    } else if (draft_.points().size() >= kMinClosed) {
        const auto place = placeAt(view, pointer);
        if (place && place->on == ClothPoint::On::Own && place->own == 0) {
            make(true);
            return;
        }
    }
    PathTool::click(view, {pointer.at, {}});
}

void InternalLineTool::hover(ToolView& view, const Pointer& pointer) {
    PathTool::hover(view, {pointer.at, {}});
}

void InternalLineTool::make(bool closed) {
    Document& document = workspace_.document();
    ClothPoints points;
    for (const ClothPoint& point : draft_.points()) {
        points.push_back(wornPlace(document, point.piece, point.at));
    }
    PathTool::cancel();
    if (points.empty()) {
        return;
    }
    const Garment& garment = *document.garment();
    const std::size_t made = document.state().lines.internalLines.size();
    const auto name = [&points, made](std::size_t number) {
        const QString text = points.size() > 1 ? tr("line %1") : tr("drill point %1");
        return text.arg(made + number).toStdString();
    };
    LineSettings next = withInternalLine(document.state().lines, garment, name(1), points, closed);
    if (const Symmetry* symmetry = editSymmetry(document)) {
        if (auto image =
                mirroredInternalLine(garment, document.results(), *symmetry, points, closed)) {
            next = withInternalLine(std::move(next), garment, name(2), std::move(*image), closed);
        }
    }
    document.setView(&ViewState::internalLines, true);
    document.setLines(std::move(next), tr("Add internal line"));
    select(made);
}

bool InternalLineTool::wants(const QKeyEvent& event) const {
    return PathTool::wants(event) ||
           (event.key() == Qt::Key_Delete && draft_.isEmpty() && !moving_ && selected());
}

void InternalLineTool::key(ToolView& view, const QKeyEvent& event) {
    if (event.key() == Qt::Key_Delete) {
        if (const auto line = selected()) {
            Document& document = workspace_.document();
            const std::optional<std::size_t> image = imageOf(*line);
            LineSettings next = withoutInternalLine(document.state().lines, *line);
            if (image) {
                next = withoutInternalLine(std::move(next), *image - (*image > *line ? 1 : 0));
            }
            select(std::nullopt);
            document.setLines(std::move(next), tr("Delete internal line"));
        }
    } else if (moving_) {
        moving_.reset();
        emit changed();
    } else {
        PathTool::key(view, event);
    }
}

void InternalLineTool::cancel() {
    moving_.reset();
    selected_.reset();
    PathTool::cancel();
}

void InternalLineTool::paint(const ToolView& view, QPainter& painter,
                             const RenderStyle& style) const {
    if (const auto line = selected()) {
        int p = 0;
        for (const PatternPiece& piece : shownPieces(workspace_.document())) {
            for (const PieceInternal& internal : piece.internals) {
                if (internal.line == static_cast<int>(*line)) {
                    paintClothLine(view, painter, style, p, internal.way, {style.selection});
                }
            }
            ++p;
        }
        for (const LinePoint& point : points()) {
            if (point.line == *line) {
                paintHandle(view, painter, style, point.at, style.selection, true);
            }
        }
    }
    if (moving_ && moving_->moved) {
        paintHandle(view, painter, style, moving_->to, style.seam, true);
    }
    PathTool::paint(view, painter, style);
}

}  // namespace toile::app
