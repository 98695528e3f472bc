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

/// Proposed cuts over the worn garment: dashed lines, the selected one with its name and its
/// handles, which a drag moves. Logical pixels. Each question costs a ray for each place that lines
/// are drawn through.
class ProposalLines {
public:
    ProposalLines(CutProposals& proposals, const Document& document)
        : proposals_(proposals), document_(document) {}

    /// Whether there is anything to see.
    bool areShown(const ToolView& view) const;
    /// @return whether the press has taken hold of a handle
    bool press(const ToolView& view, const QPointF& at);
    /// False also where an answer or a cut has taken the proposals away under the pointer.
    bool isHeld() const;
    /// Requires `isHeld`.
    void drag(const ToolView& view, const QPointF& at);
    void release();
    void cancel();
    /// Selects the line under the pointer. @return false where there is none
    bool select(const ToolView& view, const QPointF& at);
    /// @return whether another handle, or none, is under the pointer now
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
    /// A line over the cloth, finely divided.
    struct Line {
        std::vector<Eigen::Vector3d> points;  ///< of the cut: while these are the same it stays
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

/// A click selects the piece, seam or vertex under it, a double click frames the piece or selects
/// an edge from corner to corner. In the garment view drags move the view; in the pattern view they
/// move pieces, turn them by the handle above the selection, or draw a box that selects. The arrow
/// keys nudge what is selected; Escape selects nothing. Proposed cuts are selected and moved by
/// their handles in the garment view while there are any; Escape then closes them.
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
    /// What the pointer is over in the pattern view.
    enum class Target { Sheet, Piece, Handle };

    Target targetAt(const ToolView& view, const QPointF& at) const;
    /// What is under a press that has become a drag.
    std::unique_ptr<SheetGesture> begin(ToolView& view, const Pointer& pressed);
    void nudge(const QKeyEvent& event);
    void selectNothing();

    Workspace& workspace_;
    Document& document_;
    ProposalLines proposals_;         ///< in the garment view
    std::optional<Pointer> pressed_;  ///< in the pattern view, with the button down
    std::unique_ptr<SheetGesture> gesture_;
    Target hovered_ = Target::Sheet;
    int nudging_ = -1;  ///< number of the nudges while a key is held
};

}  // namespace toile::app
