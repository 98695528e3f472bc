// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/views/tools/path_tool.h"
#include "core/pattern/line_settings.h"

namespace toile {
struct PieceInternal;
}  // namespace toile

namespace toile::app {

/// Edits internal lines and drill points in either view. Clicks set places on one piece. Enter or a
/// double click ends the line, and a click on its first place closes it. A single place is a drill
/// point. If nothing is begun, a click selects a line, Delete removes it, and dragging a point
/// moves the point. With mirrored editing, the counterpart gets the line too. Each edit is one undo
/// step.
class InternalLineTool : public PathTool {
    Q_OBJECT

public:
    InternalLineTool(Workspace& workspace, PathFinder& finder)
        : PathTool(workspace, finder, UserCut::Kind::Path, 1) {}

    ToolId id() const override { return ToolId::InternalLine; }
    QString hint(ViewKind view) const override;
    bool press(ToolView& view, const Pointer& pointer) override;
    void drag(ToolView& view, const Pointer& pointer) override;
    void release(ToolView& view, const Pointer& pointer) override;
    void click(ToolView& view, const Pointer& pointer) override;
    void hover(ToolView& view, const Pointer& pointer) override;
    bool wants(const QKeyEvent& event) const override;
    void key(ToolView& view, const QKeyEvent& event) override;
    void cancel() override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

    /// Index of the selected line in the settings.
    std::optional<std::size_t> selected() const;

protected:
    void finish() override { make(false); }
    QString elsewhere() const override;

private:
    /// A point of a line and its place on the cloth.
    struct LinePoint {
        std::size_t line = 0, point = 0;
        ClothPoint at;
    };
    struct Moving {
        LinePoint from;
        ClothPoint to;
        QPointF pressed;
        bool moved = false;
    };

    const std::vector<InternalLine>& lines() const;
    void make(bool closed);
    void select(std::optional<std::size_t> line);
    /// The line that is its mirror image; nullopt unless edits are mirrored.
    std::optional<std::size_t> imageOf(std::size_t line) const;
    /// The line nearest to a pixel on the visible cloth.
    std::optional<std::size_t> lineAt(const ToolView& view, const QPointF& at) const;
    /// The points of the drawn lines. Cost: points times the places along them.
    std::vector<LinePoint> points() const;
    std::optional<LinePoint> pointAt(const ToolView& view, const QPointF& at) const;

    std::optional<InternalLine> selected_;  ///< a copy from the settings
    std::optional<Moving> moving_;
};

}  // namespace toile::app
