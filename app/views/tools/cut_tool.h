// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/views/tools/path_tool.h"

namespace toile {

/// Cuts a piece along the shortest way through places on it.
class CutTool : public PathTool {
    Q_OBJECT

public:
    CutTool(Workspace& workspace, PathFinder& finder)
        : PathTool(workspace, finder, UserCut::Kind::Path, 2) {}

    ToolId id() const override { return ToolId::Cut; }
    QString hint(ViewKind view) const override;
};

}  // namespace toile
