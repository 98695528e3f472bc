// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/path_finder.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/cut/surface_paths.h"
#include "core/cut/surface_point.h"
#include "core/cut/user_cuts.h"

namespace toile::app {

/// Made by the first search that needs it, and read by those that follow.
struct PathFinder::Surface {
    std::shared_ptr<const Piece> piece;
    std::optional<SurfaceLinks> links{};
};

PathFinder::PathFinder(QObject* parent) : QObject(parent) {}

PathFinder::~PathFinder() = default;

PathFinder::Ticket PathFinder::find(PathRequest request, Done done) {
    waiting_.push_back({++last_, std::move(request), std::move(done)});
    startNext();
    return last_;
}

void PathFinder::cancel(Ticket ticket) {
    std::erase_if(waiting_, [ticket](const Order& order) { return order.ticket == ticket; });
    if (ticket == current_) {
        current_ = 0;
        worker_.cancel();
    }
}

void PathFinder::evictPiece() {
    surface_ = nullptr;
    keepsSurface_ = false;
}

void PathFinder::startNext() {
    if (worker_.isBusy() || waiting_.empty()) {
        return;
    }
    Order order = std::move(waiting_.front());
    waiting_.pop_front();
    current_ = order.ticket;
    keepsSurface_ = true;
    const auto surface = surface_ && surface_->piece == order.request.piece
                             ? surface_
                             : std::make_shared<Surface>(Surface{order.request.piece});
    const PathRequest request = order.request;
    worker_.start(
        [surface, request](Progress& progress) {
            if (!surface->links) {
                surface->links.emplace(surface->piece->mesh, surface->piece->table);
            }
            return pathOfCut(*surface->links, request.from, request.to, request.alongEdges,
                             progress);
        },
        [this, surface, order = std::move(order)](const auto& made, const Progress&) {
            take(order, surface, made);
        });
}

void PathFinder::take(const Order& order, const std::shared_ptr<Surface>& surface,
                      const Attempt<Result<PathPolyline>>& made) {
    surface_ = keepsSurface_ ? surface : nullptr;
    const bool isWanted = current_ == order.ticket;
    current_ = 0;
    startNext();
    if (isWanted) {
        // The preview stays straight; the cut itself reports the error.
        order.done(made.answer ? *made.answer : cutError({}, "the way was not found"));
    }
}

}  // namespace toile::app
