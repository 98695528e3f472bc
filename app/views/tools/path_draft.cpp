// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/path_draft.h"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "app/render/render_style.h"
#include "app/views/tools/tool_paint.h"

namespace toile::app {

PathDraft::PathDraft(PathFinder& finder, QObject* parent) : QObject(parent), finder_(finder) {}

PathDraft::~PathDraft() {
    for (const Leg& leg : legs_) {
        finder_.cancel(leg.ticket);
    }
}

void PathDraft::add(const ClothPoint& point, std::shared_ptr<const Piece> piece) {
    piece_ = std::move(piece);
    points_.push_back(point);
    refresh();
}

void PathDraft::removeLast() {
    if (!points_.empty()) {
        points_.pop_back();
        if (points_.empty()) {
            piece_ = nullptr;
        }
        refresh();
    }
}

void PathDraft::clear() {
    points_.clear();
    piece_ = nullptr;
    tip_.reset();
    refresh();
}

void PathDraft::setTip(const std::optional<ClothPoint>& tip) {
    const bool isSame = tip_.has_value() == tip.has_value() &&
                        (!tip || (tip_->piece == tip->piece && tip_->on == tip->on &&
                                  samePlace(tip_->at, tip->at)));
    if (!isSame) {
        tip_ = tip;
        refresh();
    }
}

void PathDraft::setClosed(bool closed) {
    closed_ = closed;
    refresh();
}

void PathDraft::setAlongEdges(bool alongEdges) {
    if (alongEdges_ != alongEdges) {
        alongEdges_ = alongEdges;
        refresh();
    }
}

void PathDraft::refresh() {
    std::vector<Leg> wanted;
    const auto want = [&](const ClothPoint& from, const ClothPoint& to, bool isFixed) {
        if (!samePlace(from.at, to.at)) {
            wanted.push_back({from.at, to.at, alongEdges_, isFixed});
        }
    };
    for (std::size_t i = 1; i < points_.size(); ++i) {
        want(points_[i - 1], points_[i], true);
    }
    if (!points_.empty()) {
        const ClothPoint& last = tip_ ? *tip_ : points_.back();
        if (tip_) {
            want(points_.back(), *tip_, false);
        }
        if (closed_ && points_.size() + (tip_ ? 1 : 0) > 2) {
            want(last, points_.front(), !tip_);
        }
    }
    for (Leg& leg : wanted) {
        const auto known = std::ranges::find_if(legs_, [&leg](const Leg& old) {
            return samePlace(old.from, leg.from) && samePlace(old.to, leg.to) &&
                   old.alongEdges == leg.alongEdges &&
                   (old.path || old.ticket != 0 || old.hasFailed);
        });
        if (known != legs_.end()) {
            leg.path = std::move(known->path);
            leg.ticket = std::exchange(known->ticket, 0);
            leg.hasFailed = std::exchange(known->hasFailed, false);
            known->path.reset();
        }
    }
    for (const Leg& old : legs_) {
        finder_.cancel(old.ticket);
    }
    legs_ = std::move(wanted);
    for (Leg& leg : legs_) {
        if (!leg.path && leg.ticket == 0 && !leg.hasFailed) {
            // `find` calls `done` through the event loop, so never before it has returned.
            auto ticket = std::make_shared<PathFinder::Ticket>(0);
            *ticket = leg.ticket = finder_.find({piece_, leg.from, leg.to, leg.alongEdges},
                                                [this, ticket](const Result<PathPolyline>& found) {
                                                    for (Leg& waiting : legs_) {
                                                        if (waiting.ticket == *ticket) {
                                                            waiting.ticket = 0;
                                                            waiting.hasFailed = !found;
                                                            if (found) {
                                                                waiting.path = *found;
                                                            }
                                                        }
                                                    }
                                                    emit changed();
                                                });
        }
    }
    emit changed();
}

bool PathDraft::isSearching() const {
    return std::ranges::any_of(legs_, [](const Leg& leg) -> bool { return leg.ticket != 0; });
}

std::optional<double> PathDraft::length() const {
    double sum = 0;
    for (const Leg& leg : legs_) {
        if (!leg.path) {
            return std::nullopt;
        }
        sum += leg.path->length;
    }
    return sum;
}

void PathDraft::paint(const ToolView& view, QPainter& painter, const RenderStyle& style,
                      const QColor& colour) const {
    if (points_.empty()) {
        return;
    }
    const int piece = points_.front().piece;
    for (const Leg& leg : legs_) {
        std::vector<SurfacePoint> places{leg.from, leg.to};
        paintClothLine(view, painter, style, piece, leg.path ? leg.path->points : places,
                       {colour, leg.path.has_value() && leg.isFixed});
    }
    for (const ClothPoint& point : points_) {
        paintHandle(view, painter, style, point, colour, true);
    }
}

}  // namespace toile::app
