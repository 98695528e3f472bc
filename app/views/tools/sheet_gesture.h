// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/views/tools/tool.h"

namespace toile {

/// What a drag in the pattern view does, from the press to the release. What it changes is one step
/// of the history; taken back it leaves none.
class SheetGesture {
public:
    virtual ~SheetGesture() = default;

    /// The pointer has moved with the button down, far enough to be no click.
    virtual void drag(ToolView& view, const Pointer& pointer) = 0;
    /// Everything is to be as before the press.
    virtual void takeBack() = 0;
    virtual void paint(const ToolView&, QPainter&, const RenderStyle&) const {}
};

}  // namespace toile
