// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window_menus.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <map>

#include "app/actions/menu_table.h"
#include "app/actions/project_actions.h"
#include "app/widgets/icon.h"

namespace toile::app {

namespace {

/// The context of the translations.
class WindowMenus {
    Q_DECLARE_TR_FUNCTIONS(WindowMenus)
};

/// A heading at the very top would touch the menu's frame.
constexpr int kAirOverHeading = 4;

/// A menu of which nothing can be done now cannot be opened either.
void followActions(QMenu& menu) {
    const auto update = [&menu] {
        const QList<QAction*> actions = menu.actions();
        menu.menuAction()->setEnabled(std::any_of(actions.begin(), actions.end(), [](auto* action) {
            return !action->isSeparator() && action->isEnabled();
        }));
    };
    for (QAction* action : menu.actions()) {
        QObject::connect(action, &QAction::enabledChanged, &menu, update);
    }
    update();
}

/// Fills menus; those below others are made when they are come to.
struct MenuMaker {
    const ActionRegistry& actions;
    QList<QDockWidget*> lists;
    RecentFiles& recent;
    std::map<std::string_view, const MenuSpec*> table{};

    void fill(QMenu& menu, const MenuSpec& spec) {
        menu.setObjectName(spec.name);
        if (std::holds_alternative<MenuHeading>(spec.items.front())) {
            menu.setContentsMargins(0, kAirOverHeading, 0, 0);
        }
        for (const MenuItem& item : spec.items) {
            std::visit([&](const auto& entry) { add(menu, entry); }, item);
        }
    }

    void add(QMenu& menu, ActionId id) { menu.addAction(&actions[id]); }
    void add(QMenu& menu, MenuSeparator) { menu.addSeparator(); }
    void add(QMenu& menu, MenuHeading heading) { menu.addSection(menuText(heading.text)); }
    void add(QMenu& menu, Submenu submenu) {
        const MenuSpec& spec = *table.at(submenu.name);
        QMenu& below = *menu.addMenu(menuText(spec.title));
        fill(below, spec);
        if (!std::holds_alternative<RecentPlace>(spec.items.front())) {
            followActions(below);  // what was opened last is another whenever the menu opens
        }
    }
    void add(QMenu& menu, RecentPlace) { recent.fill(menu); }
    void add(QMenu& menu, ListsPlace) {
        for (QDockWidget* list : lists) {
            menu.addAction(list->toggleViewAction());
        }
    }
};

/// Overlays that have no button of their own: one button that shows which of them is on.
constexpr std::initializer_list<ActionId> kRarerOverlays = {
    ActionId::OverlayArea, ActionId::OverlayAngle, ActionId::OverlayDirichlet};

/// A button with these choices; it looks as the chosen one does, or says `text` where none is.
QToolButton* makeChoiceButton(const ActionRegistry& actions, std::initializer_list<ActionId> ids,
                              const QString& text, const QString& tip, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setToolTip(tip);
    button->setStatusTip(tip);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(button);
    for (const ActionId id : ids) {
        menu->addAction(&actions[id]);
    }
    button->setMenu(menu);
    const auto follow = [button, menu, text] {
        const QList<QAction*> choices = menu->actions();
        const auto chosen = std::ranges::find_if(
            choices, [](const QAction* choice) { return choice->isChecked(); });
        const bool any = chosen != choices.end();
        button->setText(any ? (*chosen)->iconText() : text);
        button->setIcon(any ? (*chosen)->icon() : choices.front()->icon());
        button->setDown(any);
        button->setEnabled(choices.front()->isEnabled());
    };
    for (const QAction* choice : menu->actions()) {
        QObject::connect(choice, &QAction::changed, button, follow);
    }
    // The button forgets that it is down when its menu closes.
    QObject::connect(menu, &QMenu::aboutToHide, button, follow, Qt::QueuedConnection);
    follow();
    return button;
}

}  // namespace

void fillMenuBar(QMainWindow& window, const ActionRegistry& actions,
                 const QList<QDockWidget*>& lists, RecentFiles& recent) {
    MenuMaker maker{actions, lists, recent};
    for (const MenuSpec& spec : menuTable()) {
        maker.table.emplace(spec.name, &spec);
    }
    for (const MenuSpec& spec : menuTable()) {
        if (spec.inMenuBar) {
            maker.fill(*window.menuBar()->addMenu(menuText(spec.title)), spec);
        }
    }
}

void addToolBar(QMainWindow& window, const ActionRegistry& actions) {
    QToolBar& bar = *window.addToolBar(WindowMenus::tr("Tools"));
    bar.setObjectName("toolBar");
    bar.setMovable(false);
    bar.setIconSize({20, 20});
    bar.setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar.addAction(&actions[ActionId::Open]);
    bar.addAction(&actions[ActionId::Save]);
    bar.addAction(&actions[ActionId::ExportPattern]);
    bar.addSeparator();
    bar.addAction(&actions[ActionId::Undo]);
    bar.addAction(&actions[ActionId::Redo]);
    bar.addSeparator();
    bar.addAction(&actions[ActionId::FlattenAgain]);
    bar.addAction(&actions[ActionId::Frame]);
    bar.addSeparator();
    for (const ActionId id : {ActionId::OverlayNone, ActionId::OverlayChecker,
                              ActionId::OverlayStrain, ActionId::OverlayWarp, ActionId::OverlayWeft,
                              ActionId::OverlayBias, ActionId::OverlayPrincipal}) {
        bar.addAction(&actions[id]);
    }
    auto* more = makeChoiceButton(actions, kRarerOverlays, WindowMenus::tr("More"),
                                  WindowMenus::tr("More overlays"), &bar);
    more->setObjectName("moreOverlays");
    bar.addWidget(more);
    bar.addSeparator();
    bar.addAction(&actions[ActionId::Wireframe]);
    // Qt's own is black on any ground.
    if (auto* rest = bar.findChild<QToolButton*>("qt_toolbar_ext_button")) {
        rest->setIcon(themedIcon("more"));
    }
}

}  // namespace toile::app
