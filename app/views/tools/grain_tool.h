// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "app/document/layout.h"
#include "app/views/grain_arrow.h"
#include "app/views/tool.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"

namespace toile::app {

/// Turns the grain of a piece by a drag in the pattern view; the arrow turns around its middle.
/// With snapping on, it snaps to the sheet's axes and diagonals, to straight edges and the nearest
/// edge. Alt inverts snapping.
class GrainTool : public Tool {
    Q_OBJECT

public:
    explicit GrainTool(Document& document) : document_(document) {}

    ToolId id() const override { return ToolId::Grain; }
    QString hint(ViewKind view) const override;
    Qt::CursorShape cursor(ViewKind view) const override;
    bool press(ToolView& view, const Pointer& pointer) override;
    void drag(ToolView& view, const Pointer& pointer) override;
    void release(ToolView& view, const Pointer& pointer) override;
    void click(ToolView& view, const Pointer& pointer) override;
    void hover(ToolView& view, const Pointer& pointer) override;
    void leave(ToolView& view) override;
    void key(ToolView& view, const QKeyEvent& event) override;
    void cancel() override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

private:
    /// A drag in progress.
    struct Turning {
        int piece;
        int gesture;
        PieceGrains before;
        Eigen::Vector2d middle;  ///< centre of rotation on the sheet, fixed during the drag
        double length;           ///< mm
        double start;            ///< the arrow's direction on the sheet at the press
        double from;             ///< the pointer's direction from the middle
        QPointF pressed, pointer;
        std::vector<double> edges{};  ///< directions on the sheet to snap to
        bool moved = false;
        double now = 0;
        /// State at the press. If it has changed, the piece may be gone or have other coordinates.
        std::shared_ptr<const Garment> of{};
        PieceResults results{};
    };

    std::optional<int> pieceAt(const ToolView& view, const QPointF& at) const;
    bool isStale(const Turning& turning) const;

    Document& document_;
    std::optional<Turning> turning_;
    int hovered_ = -1;
    mutable GarmentArrows garmentArrows_;  ///< used for painting only
};

}  // namespace toile::app
