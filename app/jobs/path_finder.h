// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <deque>
#include <functional>
#include <memory>

#include "app/base/worker.h"
#include "core/base/result.h"
#include "core/cut/surface_point.h"
#include "core/garment/piece.h"

namespace toile::app {

/// A path over a piece that somebody wants to know.
struct PathRequest {
    std::shared_ptr<const Piece> piece;
    SurfacePoint from, to;  ///< on the piece's mesh
    bool alongEdges = false;
};

/// Finds short ways over the cloth, one after the other on a thread of its own, so that a preview
/// never holds the window up however fine the mesh. Ways are found as the cuts are (`pathOfCut`),
/// and a search that is not wanted any more ends at once. What the search needs of a piece is made
/// with the first way and kept while ways on the same piece follow. GUI thread only.
class PathFinder : public QObject {
    Q_OBJECT

public:
    using Ticket = quint64;
    using Done = std::function<void(const Result<PathPolyline>&)>;

    explicit PathFinder(QObject* parent = nullptr);
    ~PathFinder() override;

    /// @param done  called on the GUI thread, later, unless the ticket is cancelled before
    Ticket find(PathRequest request, Done done);
    /// The way is not wanted any more: `done` is not called. Unknown tickets are passed by.
    void cancel(Ticket ticket);
    /// Lets go of what is kept of the piece last asked about, at the latest when the search that
    /// runs is over.
    void evictPiece();

private:
    struct Order {
        Ticket ticket = 0;
        PathRequest request{};
        Done done{};
    };
    struct Surface;

    void startNext();
    void take(const Order& order, const std::shared_ptr<Surface>& surface,
              const Attempt<Result<PathPolyline>>& made);

    std::deque<Order> waiting_;
    std::shared_ptr<Surface> surface_;  ///< of the piece last asked about
    Ticket last_ = 0;
    Ticket current_ = 0;  ///< of the search that runs; 0 where it is not wanted any more
    bool keepsSurface_ = true;
    Worker<Result<PathPolyline>> worker_;
};

}  // namespace toile::app
