// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/document/layout.h"
#include "app/views/tools/sheet_gesture.h"

namespace toile {

/// Turns the selected pieces together about the middle of the box around them. Shift: in steps of
/// 15 degrees; where snapping is on a single piece catches at whole right angles, where its grain
/// or a straight edge runs along the sheet; Alt turns the snapping the other way round.
class RotateGesture : public SheetGesture {
public:
    RotateGesture(Document& document, const Eigen::Vector2d& pressed);

    void drag(ToolView& view, const Pointer& pointer) override;
    void takeBack() override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

private:
    double snapped(double turn, const Pointer& pointer) const;

    Document& document_;
    int gesture_;
    PiecePlacements before_;
    std::vector<PieceSettings> settingsBefore_;
    Eigen::Vector2d centre_;
    double from_;  ///< direction of the pointer at the press, radians
    double turn_ = 0;
    /// Turns modulo half a turn after which something of a single piece lies along the sheet.
    std::vector<double> good_;
    QPointF pointer_;
};

}  // namespace toile
