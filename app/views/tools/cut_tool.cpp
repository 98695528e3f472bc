// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/cut_tool.h"

namespace toile {

QString CutTool::hint(ViewKind) const {
    if (draft_.isEmpty()) {
        return tr(
            "Click: begin the cut, on an edge to open it there · Ctrl+click: along the "
            "mesh's edges · Esc: back to selecting");
    }
    return hasEnough()
               ? tr("Click: go on · Double click or Enter: cut · Backspace: take the last point "
                    "back · Esc: throw the cut away")
               : tr("Click: next point · Ctrl+click: along the mesh's edges · Backspace: take the "
                    "point back · Esc: throw the cut away");
}

}  // namespace toile
