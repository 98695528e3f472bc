// SPDX-License-Identifier: GPL-3.0-or-later
// The window's tools: their bar beside the views, and which one is chosen.
#include <QAction>
#include <QToolBar>
#include <utility>

#include "app/main_window.h"
#include "app/views/tools/tool_box.h"
#include "app/views/view_area.h"

namespace toile {

namespace {

constexpr std::pair<ActionId, ToolId> kTools[] = {
    {ActionId::ToolSelect, ToolId::Select}, {ActionId::ToolCut, ToolId::Cut},
    {ActionId::ToolLoop, ToolId::Loop},     {ActionId::ToolDart, ToolId::Dart},
    {ActionId::ToolJoin, ToolId::Join},     {ActionId::ToolMeasure, ToolId::Measure},
    {ActionId::ToolGrain, ToolId::Grain},
};

/// Groups in the bar: after these comes a line.
bool endsGroup(ToolId tool) {
    return tool == ToolId::Select || tool == ToolId::Join;
}

}  // namespace

QWidget* MainWindow::makeToolPalette() {
    auto* bar = new QToolBar(tr("Tools"), this);
    bar->setObjectName("toolPalette");
    bar->setOrientation(Qt::Vertical);
    bar->setMovable(false);
    bar->setIconSize({22, 22});
    bar->setToolButtonStyle(Qt::ToolButtonIconOnly);
    for (const auto& [action, tool] : kTools) {
        bar->addAction(&actions_[action]);
        if (endsGroup(tool)) {
            bar->addSeparator();
        }
    }
    return bar;
}

void MainWindow::connectTools() {
    for (const auto& [action, tool] : kTools) {
        actions_.on(action, this, [this, tool = tool] {
            tools_->choose(tool);
            views_->takeKeyboard(viewInUse_);  // for Escape and Enter
        });
    }
    const auto show = [this](ToolId chosen) {
        for (const auto& [action, tool] : kTools) {
            actions_[action].setChecked(tool == chosen);
        }
    };
    connect(tools_, &ToolBox::chosen, this, show);
    show(tools_->current().id());
}

}  // namespace toile
