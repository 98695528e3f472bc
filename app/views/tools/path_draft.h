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

/// A line over one piece that a person is about to draw: the places set so far, one that follows
/// the pointer, and the shortest paths between them, which come a moment later from the path
/// finder.
class PathDraft : public QObject {
    Q_OBJECT

public:
    /// @param finder must outlive this object
    explicit PathDraft(PathFinder& finder, QObject* parent = nullptr);
    ~PathDraft() override;

    /// A way between two neighbouring places.
    struct Leg {
        SurfacePoint from, to;
        bool alongEdges = false;
        bool isFixed = false;  ///< between places that are set; else it follows the pointer
        std::optional<PathPolyline> path{};  ///< none until it is found
        PathFinder::Ticket ticket = 0;       ///< of the search, 0 where none runs
        bool hasFailed = false;              ///< there is no such way, or none was found
    };

    /// All on this piece; null where nothing is set.
    const std::shared_ptr<const Piece>& piece() const { return piece_; }
    bool isEmpty() const { return points_.empty(); }
    const std::vector<ClothPoint>& points() const { return points_; }
    const std::vector<Leg>& legs() const { return legs_; }
    /// The place that follows the pointer.
    const std::optional<ClothPoint>& tip() const { return tip_; }
    bool alongEdges() const { return alongEdges_; }

    /// Precondition: a place of the same piece as those before.
    void add(const ClothPoint& point, std::shared_ptr<const Piece> piece);
    void removeLast();
    void clear();
    /// None: the pointer is elsewhere.
    void setTip(const std::optional<ClothPoint>& tip);
    /// Whether the last place is joined with the first again.
    void setClosed(bool closed);
    /// Whether ways run along the mesh's edges.
    void setAlongEdges(bool alongEdges);

    /// Whether a way is still being looked for.
    bool isSearching() const;
    /// Of all ways, mm; none where one is still being looked for, or where there is none.
    std::optional<double> length() const;

    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style,
               const QColor& colour) const;

signals:
    void changed();

private:
    /// Brings the legs to what the places are; ways that are known already stay.
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
