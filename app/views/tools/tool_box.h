// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>

#include "app/jobs/path_finder.h"
#include "app/views/tool.h"

namespace toile::app {

class DartTool;
class Workspace;

/// Owns all tools, one of which is chosen.
class ToolBox : public ToolChoice {
    Q_OBJECT

public:
    /// @param workspace must outlive this object
    explicit ToolBox(Workspace& workspace, QObject* parent = nullptr);
    ~ToolBox() override;

    Tool& tool(ToolId id) const { return *tools_.at(id); }
    /// The tool that shows proposed darts.
    DartTool& dart() const;
    /// Chooses a tool and discards unfinished work of the previous one.
    void choose(ToolId id);

private:
    void add(std::unique_ptr<Tool> tool);

    PathFinder finder_;  ///< shared by all tools; declared first to outlive them
    std::map<ToolId, std::unique_ptr<Tool>> tools_;
};

}  // namespace toile::app
