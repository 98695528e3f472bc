// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/views/tool.h"

namespace toile::app {

class Workspace;

/// Joins the cloth on both sides of a seam. The seam under the pointer is highlighted in both
/// views; a click joins its sides.
class JoinTool : public Tool {
    Q_OBJECT

public:
    explicit JoinTool(Workspace& workspace) : workspace_(workspace) {}

    ToolId id() const override { return ToolId::Join; }
    QString hint(ViewKind view) const override;
    Qt::CursorShape cursor(ViewKind) const override { return Qt::CrossCursor; }
    void click(ToolView& view, const Pointer& pointer) override;
    /// Does nothing: the first click removed a seam, and the user has to see the next one before
    /// removing it.
    void doubleClick(ToolView&, const Pointer&) override {}
    void hover(ToolView& view, const Pointer& pointer) override;
    void leave(ToolView& view) override;
    bool speaks() const override { return true; }
    void cancel() override { show(std::nullopt); }
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

    std::optional<int> seam() const { return seam_; }

private:
    std::optional<int> seamAt(const ToolView& view, const Pointer& pointer) const;
    void show(std::optional<int> seam);
    QStringList note() const;

    Workspace& workspace_;
    std::optional<int> seam_;
    QPointF pointer_;
    ViewKind pointerView_ = ViewKind::Garment;
};

}  // namespace toile::app
