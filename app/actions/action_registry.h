// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <map>
#include <utility>

#include "app/actions/action_table.h"

namespace toile::app {

/// A menu's text without the mark of its mnemonic: "Save && &close" is "Save & close".
QString withoutMnemonic(const QString& text);

/// The actions of the table, behind menus, toolbar, shortcuts, command palette and help. Which menu
/// an action is in says menu_table.h.
class ActionRegistry : public QObject {
    Q_OBJECT

public:
    explicit ActionRegistry(QObject* parent = nullptr);

    QAction& operator[](ActionId id) const { return *actions_.at(id); }
    /// In the order of the table.
    QList<QAction*> all() const { return findChildren<QAction*>(); }
    /// Does this whenever the action is triggered, for as long as the receiver lives.
    template <class Receiver, class Slot>
    void on(ActionId id, const Receiver* receiver, Slot slot) const {
        connect(&(*this)[id], &QAction::triggered, receiver, std::move(slot));
    }
    /// From now on does what the table says, for as long as `garment` lives.
    void connectTo(GarmentActions& garment) const;
    /// Asks the table which actions can be done now, of those that read what has changed.
    void followEnabled(Workspace& workspace) const;
    /// How many conditions were evaluated so far.
    int evaluations() const { return evaluations_; }
    /// And which are chosen, or switched on.
    void followChecked(Workspace& workspace) const;
    /// Whether actions for specialists are left out of menus and lists, but for those in use.
    void setPlain(bool plain);
    /// What the table calls it, for help and lists: without mnemonic, and without what the present
    /// state adds to the menu's text.
    QString title(ActionId id) const;

private:
    void showWanted() const;

    std::map<ActionId, QAction*> actions_;
    bool plain_ = false;
    mutable int evaluations_ = 0;
};

}  // namespace toile::app
