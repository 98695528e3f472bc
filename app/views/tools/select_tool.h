// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "app/views/tool.h"
#include "app/views/tools/proposal_lines.h"

namespace toile::app {

class Document;
class SheetGesture;
class Workspace;

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
