// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/path_finder.h"

#include <QtConcurrentRun>
#include <algorithm>
#include <exception>
#include <utility>

#include "core/base/progress.h"
#include "core/cut/surface_links.h"
#include "core/cut/surface_point.h"
#include "core/cut/user_cuts.h"

namespace toile {

struct PathFinder::Surface {
    explicit Surface(std::shared_ptr<const Piece> of)
        : piece(std::move(of)), links(piece->mesh, piece->table) {}

    std::shared_ptr<const Piece> piece;
    SurfaceLinks links;
};

/// What the worker works on: written by it, and read after the future has finished.
struct PathFinder::Running {
    Order order;
    std::shared_ptr<Surface> surface;
    Progress progress;
    Result<PathPolyline> outcome = cutError("", "the way was not found");
    bool isForgotten = false;
    bool keepsSurface = true;
};

PathFinder::PathFinder(QObject* parent) : QObject(parent) {
    pool_.setMaxThreadCount(1);
    connect(&watcher_, &QFutureWatcher<void>::finished, this, &PathFinder::onFinished);
}

PathFinder::~PathFinder() {
    watcher_.disconnect(this);
    if (current_) {
        current_->progress.cancel();
    }
    watcher_.waitForFinished();
}

PathFinder::Ticket PathFinder::find(PathWish wish, Done done) {
    waiting_.push_back({++last_, std::move(wish), std::move(done)});
    startNext();
    return last_;
}

void PathFinder::forget(Ticket ticket) {
    std::erase_if(waiting_, [ticket](const Order& order) { return order.ticket == ticket; });
    if (current_ && current_->order.ticket == ticket) {
        current_->isForgotten = true;
        current_->progress.cancel();
    }
}

void PathFinder::forgetPiece() {
    surface_ = nullptr;
    if (current_) {
        current_->keepsSurface = false;
    }
}

void PathFinder::startNext() {
    if (current_ || waiting_.empty()) {
        return;
    }
    current_ = std::make_unique<Running>();
    current_->order = std::move(waiting_.front());
    waiting_.pop_front();
    if (surface_ && surface_->piece == current_->order.wish.piece) {
        current_->surface = surface_;
    }
    Running* running = current_.get();  // outlives the future: the destructor waits for it
    watcher_.setFuture(QtConcurrent::run(&pool_, [running] {
        try {
            if (!running->surface) {
                running->surface = std::make_shared<Surface>(running->order.wish.piece);
            }
            const PathWish& wish = running->order.wish;
            running->outcome = wayOfCut(running->surface->links, wish.from, wish.to,
                                        wish.alongEdges, running->progress);
        } catch (const std::exception&) {
            // Out of memory, or a fault: the preview stays straight, and the cut itself will tell.
        }
    }));
}

void PathFinder::onFinished() {
    const std::unique_ptr<Running> done = std::move(current_);
    surface_ = done->keepsSurface ? done->surface : nullptr;
    startNext();
    if (!done->isForgotten) {
        done->order.done(done->outcome);
    }
}

}  // namespace toile
