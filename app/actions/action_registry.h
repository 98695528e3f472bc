// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <map>
#include <utility>

#include "app/actions/action_table.h"

namespace toile::app {

/// A menu's text without its mnemonic marks: "Save && &close" becomes "Save & close".
QString withoutMnemonic(const QString& text);

/// The actions of the table, as used by menus, toolbar, shortcuts, command palette and help.
/// menu_table.h assigns actions to menus.
class ActionRegistry : public QObject {
    Q_OBJECT

public:
    explicit ActionRegistry(QObject* parent = nullptr);

    QAction& operator[](ActionId id) const { return *actions_.at(id); }
    /// In table order.
    QList<QAction*> all() const { return findChildren<QAction*>(); }
    /// Calls the slot whenever the action is triggered, while the receiver lives.
    template <class Receiver, class Slot>
    void on(ActionId id, const Receiver* receiver, Slot slot) const {
        connect(&(*this)[id], &QAction::triggered, receiver, std::move(slot));
    }
    /// Connects all actions to their work in the table, while `garment` lives.
    void connectTo(GarmentActions& garment) const;
    /// Updates which actions are enabled.
    /// @param what  evaluates only conditions that read this; null for all
    void followEnabled(Workspace& workspace, const DocumentChange* what = nullptr) const;
    /// Number of conditions evaluated so far.
    int evaluations() const { return evaluations_; }
    /// Updates which actions are checked.
    void followChecked(Workspace& workspace) const;
    /// Hides actions for specialists from menus and lists, except those in use.
    void setPlain(bool plain);
    /// The action's text from the table, for help and lists: without mnemonic, and without what the
    /// current state adds to the menu's text.
    QString title(ActionId id) const;

private:
    void showWanted() const;

    std::map<ActionId, QAction*> actions_;
    bool plain_ = false;
    mutable int evaluations_ = 0;
};

}  // namespace toile::app
