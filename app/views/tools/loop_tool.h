// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/views/tools/path_tool.h"

namespace toile {

/// Cuts along a closed line through three places or more.
class LoopTool : public PathTool {
    Q_OBJECT

public:
    LoopTool(Workspace& workspace, PathFinder& finder)
        : PathTool(workspace, finder, UserCut::Kind::Loop, 3) {}

    ToolId id() const override { return ToolId::Loop; }
    QString hint(ViewKind view) const override;

protected:
    bool fits(const ClothPoint& point) const override;
};

}  // namespace toile
