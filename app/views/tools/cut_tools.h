// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/views/tools/path_tool.h"

namespace toile::app {

/// Cuts a piece along the shortest path through the given places.
class CutTool : public PathTool {
    Q_OBJECT

public:
    CutTool(Workspace& workspace, PathFinder& finder)
        : PathTool(workspace, finder, UserCut::Kind::Path, 2) {}

    ToolId id() const override { return ToolId::Cut; }
    QString hint(ViewKind view) const override;

protected:
    bool goesAround() const override { return true; }
};

/// Cuts along a closed line through at least three places.
class LoopTool : public PathTool {
    Q_OBJECT

public:
    LoopTool(Workspace& workspace, PathFinder& finder)
        : PathTool(workspace, finder, UserCut::Kind::Loop, 3) {}

    ToolId id() const override { return ToolId::Loop; }
    QString hint(ViewKind view) const override;

protected:
    bool fits(const ClothPoint& point) const override;
    bool goesAround() const override { return true; }
};

/// Cuts from an edge to a tip inside the cloth, by one drag or two clicks.
class DartTool : public PathTool {
    Q_OBJECT

public:
    DartTool(Workspace& workspace, PathFinder& finder)
        : PathTool(workspace, finder, UserCut::Kind::Dart, 2) {}

    ToolId id() const override { return ToolId::Dart; }
    QString hint(ViewKind view) const override;
    bool press(ToolView& view, const Pointer& pointer) override;
    void drag(ToolView& view, const Pointer& pointer) override;
    void release(ToolView& view, const Pointer& pointer) override;
    void click(ToolView& view, const Pointer& pointer) override;
    /// Proposes a dart from the nearest edge to a tip: Enter cuts it, a click starts another.
    /// @param flat  tip in the flat piece's coordinates, mm; does nothing if the piece is not flat
    void propose(int piece, const Eigen::Vector2d& flat);

protected:
    QString remark(const ClothPoint& point) const override;
    UserCut::Kind kindFor(const std::vector<ClothPoint>& points) override;

private:
    QPointF pressed_;
};

}  // namespace toile::app
