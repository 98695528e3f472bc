// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>

#include "app/jobs/path_finder.h"
#include "app/views/tool.h"

namespace toile::app {

class DartTool;
class Workspace;

/// All tools, of which one is chosen.
class ToolBox : public ToolChoice {
    Q_OBJECT

public:
    /// @param workspace must outlive this object
    explicit ToolBox(Workspace& workspace, QObject* parent = nullptr);
    ~ToolBox() override;

    Tool& tool(ToolId id) const { return *tools_.at(id); }
    /// The one that proposes.
    DartTool& dart() const;
    /// What the tool before had begun is thrown away.
    void choose(ToolId id);

private:
    void add(std::unique_ptr<Tool> tool);

    PathFinder finder_;  ///< of all tools, which go before it
    std::map<ToolId, std::unique_ptr<Tool>> tools_;
};

}  // namespace toile::app
