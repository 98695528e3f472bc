// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "app/views/tool.h"

namespace toile::app {

class CutProposals;
class Document;
class SheetGesture;
class Workspace;

/// Draws proposed cuts over the worn garment as dashed lines. The selected one shows its name and
/// draggable handles. Logical pixels. Each query casts one ray per drawn point of the lines.
class ProposalLines {
public:
    ProposalLines(CutProposals& proposals, const Document& document)
        : proposals_(proposals), document_(document) {}

    bool areShown(const ToolView& view) const;
    /// @return whether the press grabbed a handle
    bool press(const ToolView& view, const QPointF& at);
    /// Also false if an answer or a cut has removed the proposals during the drag.
    bool isHeld() const;
    /// Requires `isHeld`.
    void drag(const ToolView& view, const QPointF& at);
    void release();
    void cancel();
    /// Selects the line under the pointer. @return false if there is none
    bool select(const ToolView& view, const QPointF& at);
    /// @return whether the hovered handle has changed
    bool hover(const ToolView& view, const QPointF& at);
    bool leave();
    bool isOverHandle() const { return hovered_.has_value(); }
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const;

private:
    struct Handle {
        std::size_t cut;
        int point;
        bool operator==(const Handle&) const = default;
    };
    /// A finely divided line over the cloth.
    struct Line {
        std::vector<Eigen::Vector3d> points;  ///< of the cut: cache key of `drawn`
        std::vector<Eigen::Vector3d> drawn;
    };

    const std::vector<Line>& lines() const;
    std::optional<Handle> handleAt(const ToolView& view, const QPointF& at) const;
    std::optional<std::size_t> lineAt(const ToolView& view, const QPointF& at) const;
    void paintLine(const ToolView& view, QPainter& painter, const RenderStyle& style,
                   std::size_t cut) const;

    CutProposals& proposals_;
    const Document& document_;
    std::optional<Handle> held_, hovered_;
    mutable std::vector<Line> lines_;
};

/// Selects and moves. A click selects a piece, seam or vertex; a double click frames the piece or
/// selects an edge between corners. In the garment view, drags move the view. In the pattern view,
/// they move pieces, turn them by the handle above the selection, or draw a selection box. Arrow
/// keys nudge the selection; Escape clears it. Proposed cuts can be edited in the garment view;
/// Escape closes them.
class SelectTool : public Tool {
    Q_OBJECT

public:
    explicit SelectTool(Workspace& workspace);
    ~SelectTool() override;

    ToolId id() const override { return ToolId::Select; }
    QString hint(ViewKind view) const override;
    Qt::CursorShape cursor(ViewKind view) const override;
    bool press(ToolView& view, const Pointer& pointer) override;
    void drag(ToolView& view, const Pointer& pointer) override;
    void release(ToolView& view, const Pointer& pointer) override;
    void click(ToolView& view, const Pointer& pointer) override;
    void doubleClick(ToolView& view, const Pointer& pointer) override;
    void hover(ToolView& view, const Pointer& pointer) override;
    void leave(ToolView& view) override;
    bool wants(const QKeyEvent& event) const override;
    void key(ToolView& view, const QKeyEvent& event) override;
    void cancel() override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

private:
    /// The target under the pointer in the pattern view.
    enum class Target { Sheet, Piece, Handle };

    Target targetAt(const ToolView& view, const QPointF& at) const;
    /// Creates the gesture for a press that has become a drag.
    std::unique_ptr<SheetGesture> begin(ToolView& view, const Pointer& pressed);
    void nudge(const QKeyEvent& event);
    void selectNothing();

    Workspace& workspace_;
    Document& document_;
    ProposalLines proposals_;         ///< in the garment view
    std::optional<Pointer> pressed_;  ///< in the pattern view, with the button down
    std::unique_ptr<SheetGesture> gesture_;
    Target hovered_ = Target::Sheet;
    int nudging_ = -1;  ///< gesture number of the nudges while a key is held
};

}  // namespace toile::app
