// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_menus.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <map>

#include "app/actions/action_registry.h"
#include "app/actions/material_menu.h"
#include "app/actions/menu_table.h"
#include "app/actions/project_actions.h"
#include "app/session/workspace.h"
#include "app/widgets/icon.h"

namespace toile::app {
namespace {

/// Translation context.
class WindowMenus {
    Q_DECLARE_TR_FUNCTIONS(WindowMenus)
};

/// Without it, a heading at the top would touch the menu's frame.
constexpr int kAirOverHeading = 4;

/// Disables a menu without enabled entries, and hides a menu without visible entries.
void followActions(QMenu& menu) {
    const auto update = [&menu] {
        const auto isAny = [&menu](bool (QAction::*holds)() const) {
            return std::ranges::any_of(menu.actions(), [holds](const QAction* action) {
                return !action->isSeparator() && (action->*holds)();
            });
        };
        menu.menuAction()->setVisible(isAny(&QAction::isVisible));
        menu.menuAction()->setEnabled(isAny(&QAction::isEnabled));
    };
    for (QAction* action : menu.actions()) {
        QObject::connect(action, &QAction::enabledChanged, &menu, update);
        QObject::connect(action, &QAction::visibleChanged, &menu, update);
    }
    update();
}

/// Hides a heading if no entry below it is visible.
void followBelow(const QMenu& menu, QAction& heading) {
    QList<QAction*> below;
    const QList<QAction*> all = menu.actions();
    for (qsizetype k = all.indexOf(&heading) + 1; k < all.size() && !all[k]->isSeparator(); ++k) {
        below << all[k];
    }
    const auto update = [&heading, below] {
        heading.setVisible(std::ranges::any_of(below, &QAction::isVisible));
    };
    for (QAction* action : below) {
        QObject::connect(action, &QAction::visibleChanged, &heading, update);
    }
    update();
}

/// Fills menus recursively, including submenus.
struct MenuMaker {
    const ActionRegistry& actions;
    QList<QDockWidget*> lists;
    MaterialMenu& materials;
    RecentFiles* recent;  ///< null for menus without a `RecentPlace`
    std::map<std::string_view, const MenuSpec*> table{};

    void fill(QMenu& menu, const MenuSpec& spec) {
        menu.setObjectName(spec.name);
        if (std::holds_alternative<MenuHeading>(spec.items.front())) {
            menu.setContentsMargins(0, kAirOverHeading, 0, 0);
        }
        for (const MenuItem& item : spec.items) {
            std::visit([&](const auto& entry) { add(menu, entry); }, item);
        }
        for (QAction* entry : menu.actions()) {
            if (entry->isSeparator() && !entry->text().isEmpty()) {
                followBelow(menu, *entry);
            }
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
            followActions(below);  // recent files may change before the menu is opened again
        }
    }
    void add(QMenu& menu, RecentPlace) { recent->fill(menu); }
    void add(QMenu& menu, MaterialsPlace) { materials.fill(menu); }
    void add(QMenu& menu, ListsPlace) {
        for (QDockWidget* list : lists) {
            menu.addAction(list->toggleViewAction());
        }
    }
};

/// Flatten is emphasized while the pattern is out of date and no update is running.
void glowWhenWanted(QWidget& button, Workspace& workspace) {
    button.setObjectName("flattenButton");
    QObject::connect(&workspace, &Workspace::patternAged, &button, [&button](PatternAge age) {
        button.setStyleSheet(age == PatternAge::OutOfDate
                                 ? "QToolButton { border: 1px solid palette(highlight);"
                                   " border-radius: 3px; font-weight: 600; padding: 3px; }"
                                 : "");
    });
}

MenuMaker makerOf(const ActionRegistry& actions, const QList<QDockWidget*>& lists,
                  MaterialMenu& materials, RecentFiles* recent) {
    MenuMaker maker{actions, lists, materials, recent};
    for (const MenuSpec& spec : menuTable()) {
        maker.table.emplace(spec.name, &spec);
    }
    return maker;
}

}  // namespace

OverlayButtons::OverlayButtons(QToolBar& bar, const ActionRegistry& actions)
    : QObject(&bar),
      last_{&actions[overlayAction(Overlay::Strain)], &actions[overlayAction(Overlay::None)]},
      choice_(new QToolButton(&bar)) {
    choice_->setObjectName("overlayChoice");
    choice_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    choice_->setPopupMode(QToolButton::InstantPopup);
    choice_->setToolTip(tr("Colours shown on the cloth in both views"));
    choice_->setAccessibleName(tr("Overlay"));
    auto* menu = new QMenu(choice_);
    for (const OverlayTraits& known : kOverlays) {
        QAction& action = actions[overlayAction(known.overlay)];
        overlays_ << &action;
        menu->addAction(&action);
        connect(&action, &QAction::changed, this, &OverlayButtons::follow);
    }
    choice_->setMenu(menu);
    bar.addWidget(choice_);
    for (std::size_t k = 0; k < kLast; ++k) {
        buttons_[k] = new QToolButton(&bar);
        buttons_[k]->setObjectName(QString("lastOverlay%1").arg(k + 1));
        buttons_[k]->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        bar.addWidget(buttons_[k]);
    }
    follow();
}

void OverlayButtons::follow() {
    const auto on =
        std::ranges::find_if(overlays_, [](auto* action) { return action->isChecked(); });
    QAction* now = on == overlays_.end() ? shown_ : *on;
    if (shown_ && now != shown_) {
        // A returning overlay swaps places with the active one; else the oldest is dropped.
        const auto called = std::ranges::find(last_, now);
        std::shift_right(last_.begin(), called == last_.end() ? called : called + 1, 1);
        last_.front() = shown_;
    }
    shown_ = now;
    show();
}

void OverlayButtons::show() {
    if (shown_) {
        choice_->setText(shown_->iconText());
        choice_->setIcon(shown_->icon());
    }
    choice_->setEnabled(overlays_.front()->isEnabled());
    for (std::size_t k = 0; k < kLast; ++k) {
        if (buttons_[k]->defaultAction() != last_[k]) {
            buttons_[k]->removeAction(buttons_[k]->defaultAction());
            buttons_[k]->setDefaultAction(last_[k]);
        }
    }
}

QMenu* makeContextMenu(const char* name, const ActionRegistry& actions, MaterialMenu& materials,
                       QWidget* parent) {
    MenuMaker maker = makerOf(actions, {}, materials, nullptr);
    auto* menu = new QMenu(parent);
    maker.fill(*menu, *maker.table.at(name));
    return menu;
}

void fillMenuBar(QMainWindow& window, const ActionRegistry& actions,
                 const QList<QDockWidget*>& lists, RecentFiles& recent, MaterialMenu& materials) {
    MenuMaker maker = makerOf(actions, lists, materials, &recent);
    for (const MenuSpec& spec : menuTable()) {
        if (spec.place == MenuPlace::Bar) {
            maker.fill(*window.menuBar()->addMenu(menuText(spec.title)), spec);
        }
    }
}

void addToolBar(QMainWindow& window, const ActionRegistry& actions, Workspace& workspace) {
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
    glowWhenWanted(*bar.widgetForAction(&actions[ActionId::FlattenAgain]), workspace);
    bar.addAction(&actions[ActionId::Frame]);
    bar.addSeparator();
    new OverlayButtons(bar, actions);  // owned by the bar
    bar.addSeparator();
    bar.addAction(&actions[ActionId::GoToFabric]);
    bar.addAction(&actions[ActionId::ReadyToCut]);
    // Qt's own icon is black on any background.
    if (auto* rest = bar.findChild<QToolButton*>("qt_toolbar_ext_button")) {
        rest->setIcon(themedIcon("more"));
    }
}

}  // namespace toile::app
