// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/proposal_lines.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <limits>
#include <utility>

#include "app/actions/cut_proposals.h"
#include "app/document/document.h"
#include "app/render/render_style.h"
#include "core/geometry/segment.h"

namespace toile::app {

namespace {

constexpr double kSpacing = 6;                   // mm, of what is drawn
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
    // An end on a rim goes along it as it is seen, with the pointer beside the cloth, too.
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

}  // namespace toile::app
