// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/tool_box.h"

#include <utility>

#include "app/session/workspace.h"
#include "app/views/tools/cut_tools.h"
#include "app/views/tools/grain_tool.h"
#include "app/views/tools/internal_line_tool.h"
#include "app/views/tools/join_tool.h"
#include "app/views/tools/measure_tool.h"
#include "app/views/tools/notch_tool.h"
#include "app/views/tools/select_tool.h"

namespace toile::app {

ToolBox::ToolBox(Workspace& workspace, QObject* parent) : ToolChoice(parent) {
    add(std::make_unique<SelectTool>(workspace));
    add(std::make_unique<CutTool>(workspace, finder_));
    add(std::make_unique<LoopTool>(workspace, finder_));
    add(std::make_unique<DartTool>(workspace, finder_));
    add(std::make_unique<JoinTool>(workspace));
    add(std::make_unique<MeasureTool>(workspace.document(), finder_));
    add(std::make_unique<GrainTool>(workspace.document()));
    add(std::make_unique<NotchTool>(workspace.document()));
    add(std::make_unique<InternalLineTool>(workspace, finder_));
    current_ = tools_.at(ToolId::Select).get();
    connect(&workspace.document(), &Document::changed, this, [this](const DocumentChange& what) {
        if (what.hasOtherPieces()) {
            // Tools may refer to pieces that no longer exist.
            for (const auto& [id, tool] : tools_) {
                tool->cancel();
            }
            finder_.evictPiece();
        }
    });
}

ToolBox::~ToolBox() = default;

DartTool& ToolBox::dart() const {
    return static_cast<DartTool&>(tool(ToolId::Dart));
}

void ToolBox::add(std::unique_ptr<Tool> tool) {
    Tool* added = tool.get();
    connect(added, &Tool::changed, this, [this, added] {
        if (added == current_) {
            emit changed();
        }
    });
    connect(added, &Tool::finished, this, [this] { choose(ToolId::Select); });
    tools_.emplace(added->id(), std::move(tool));
}

void ToolBox::choose(ToolId id) {
    Tool* tool = tools_.at(id).get();
    if (tool == current_) {
        return;
    }
    current_->cancel();
    current_ = tool;
    emit chosen(id);
    emit changed();
}

}  // namespace toile::app
