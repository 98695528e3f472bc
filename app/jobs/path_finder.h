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

/// A request for a path over a piece.
struct PathRequest {
    std::shared_ptr<const Piece> piece;
    SurfacePoint from, to;  ///< on the piece's mesh
    bool alongEdges = false;
};

/// Finds short paths over the cloth, one after the other on a thread of its own, so that previews
/// do not block the window, however fine the mesh. Paths are found in the same way as cuts
/// (`pathOfCut`), and an unwanted search ends at once. The search structure of a piece is made with
/// its first path and kept while paths on the same piece follow. GUI thread only.
class PathFinder : public QObject {
    Q_OBJECT

public:
    using Ticket = quint64;
    using Done = std::function<void(const Result<PathPolyline>&)>;

    explicit PathFinder(QObject* parent = nullptr);
    ~PathFinder() override;

    /// @param done  called on the GUI thread, later, unless the ticket is cancelled before
    Ticket find(PathRequest request, Done done);
    /// Drops a search: `done` is not called. Ignores unknown tickets.
    void cancel(Ticket ticket);
    /// Frees the search structure of the last piece, at the latest when the running search has
    /// ended.
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
    Ticket current_ = 0;  ///< of the running search; 0 if it is not wanted any more
    bool keepsSurface_ = true;
    Worker<Result<PathPolyline>> worker_;
};

}  // namespace toile::app
