// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "app/jobs/path_finder.h"
#include "app/views/tool.h"
#include "app/views/tools/cloth_snapper.h"

class QColor;
class QPainter;

namespace toile::app {

/// An unfinished line over one piece: the places set so far, a tip that follows the pointer, and
/// the shortest paths between them. The path finder delivers the paths asynchronously.
class PathDraft : public QObject {
    Q_OBJECT

public:
    /// @param finder must outlive this object
    explicit PathDraft(PathFinder& finder, QObject* parent = nullptr);
    ~PathDraft() override;

    /// A path between two neighbouring places.
    struct Leg {
        SurfacePoint from, to;
        bool alongEdges = false;
        bool isFixed = false;  ///< both ends are set; otherwise it follows the pointer
        std::optional<PathPolyline> path{};  ///< nullopt until it is found
        PathFinder::Ticket ticket = 0;       ///< of the running search; 0: none
        bool hasFailed = false;              ///< no path exists or was found
    };

    /// The piece of all places; null if there are none.
    const std::shared_ptr<const Piece>& piece() const { return piece_; }
    bool isEmpty() const { return points_.empty(); }
    const std::vector<ClothPoint>& points() const { return points_; }
    const std::vector<Leg>& legs() const { return legs_; }
    const std::optional<ClothPoint>& tip() const { return tip_; }
    bool alongEdges() const { return alongEdges_; }

    /// Precondition: a place of the same piece as those before.
    void add(const ClothPoint& point, std::shared_ptr<const Piece> piece);
    void removeLast();
    void clear();
    /// Nullopt: the pointer is elsewhere.
    void setTip(const std::optional<ClothPoint>& tip);
    /// Sets whether the last place connects back to the first.
    void setClosed(bool closed);
    /// Sets whether paths follow the mesh's edges.
    void setAlongEdges(bool alongEdges);

    /// Whether a search is running.
    bool isSearching() const;
    /// Total length, mm; nullopt while a search runs or if a path is missing.
    std::optional<double> length() const;

    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style,
               const QColor& colour) const;

signals:
    void changed();

private:
    /// Updates the legs after a change of places; keeps known paths.
    void refresh();

    PathFinder& finder_;
    std::shared_ptr<const Piece> piece_;
    std::vector<ClothPoint> points_;
    std::optional<ClothPoint> tip_;
    std::vector<Leg> legs_;
    bool closed_ = false;
    bool alongEdges_ = false;
};

}  // namespace toile::app
