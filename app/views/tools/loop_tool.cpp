// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/loop_tool.h"

namespace toile {

bool LoopTool::fits(const ClothPoint& point) const {
    return point.on != ClothPoint::On::Own && PathTool::fits(point);
}

QString LoopTool::hint(ViewKind) const {
    if (draft_.isEmpty()) {
        return tr(
            "Click: begin a closed cut · Ctrl+click: along the mesh's edges · Esc: back to "
            "selecting");
    }
    return hasEnough()
               ? tr("Click: go on · Click the first point, double click or Enter: cut · "
                    "Backspace: take the last point back · Esc: throw the cut away")
               : tr("Click: next point, of three or more · Backspace: take the last point back · "
                    "Esc: throw the cut away");
}

}  // namespace toile
