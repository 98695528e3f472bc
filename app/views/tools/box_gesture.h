// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/views/tools/sheet_gesture.h"

namespace toile {

/// Selects the pieces that a box drawn with the pointer touches.
class BoxGesture : public SheetGesture {
public:
    /// @param adds  to what is selected already
    /// @param pressed  place of the sheet under the pointer
    BoxGesture(Document& document, const Eigen::Vector2d& pressed, bool adds);

    void drag(ToolView& view, const Pointer& pointer) override;
    void takeBack() override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

private:
    Document& document_;
    Document::Selection before_;
    bool adds_;
    Eigen::Vector2d from_, to_;  ///< corners on the sheet: the view may move meanwhile
};

}  // namespace toile
