// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/document/layout.h"
#include "app/views/tools/sheet_gesture.h"
#include "core/sheet/snapping.h"

namespace toile {

/// Moves the selected pieces with the pointer, snapping where that is on; Alt turns it the other
/// way round.
class MoveGesture : public SheetGesture {
public:
    /// @param pressed  place of the sheet under the pointer
    MoveGesture(Document& document, const Eigen::Vector2d& pressed);

    void drag(ToolView& view, const Pointer& pointer) override;
    void takeBack() override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

private:
    Document& document_;
    int gesture_;
    Eigen::Vector2d pressed_;
    PiecePlacements before_;
    std::vector<PieceSettings> settingsBefore_;
    Eigen::AlignedBox2d box_;          ///< around what moves, before
    Points2 corners_ = Points2(0, 2);  ///< of what moves, before
    SnapTargets targets_;
    SnappedMove move_;
    QPointF pointer_;
};

/// The corners of the pieces' outlines as they lie.
Points2 cornersOnSheet(const Document& document, const std::vector<int>& pieces);

}  // namespace toile
