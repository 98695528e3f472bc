// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/action_registry.h"

#include <QActionGroup>
#include <QKeySequence>
#include <algorithm>

#include "app/actions/garment_actions.h"
#include "app/actions/menu_table.h"
#include "app/base/text.h"
#include "app/widgets/icon.h"

namespace toile::app {

QString withoutMnemonic(const QString& text) {
    QString plain;
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (text[i] == u'&' && ++i == text.size()) {
            break;
        }
        plain += text[i];
    }
    return plain;
}

ActionRegistry::ActionRegistry(QObject* parent) : QObject(parent) {
    std::map<ActionGroup, QActionGroup*> groups;
    for (const ActionSpec& spec : actionTable()) {
        auto* action = new QAction(app::tr(spec.text), this);
        action->setObjectName(spec.name);
        const QKeySequence shortcut(QString::fromLatin1(spec.shortcut));
        action->setShortcut(shortcut);
        const QString tip = app::tr(spec.tip);
        action->setStatusTip(tip);
        action->setToolTip(
            shortcut.isEmpty()
                ? tip
                : QString("%1 (%2)").arg(tip, shortcut.toString(QKeySequence::NativeText)));
        if (!spec.icon.empty()) {
            action->setIcon(themedIcon(QString::fromStdString(spec.icon)));
        }
        if (*spec.shortText) {
            action->setIconText(app::tr(spec.shortText));
        }
        action->setCheckable(spec.work.group != ActionGroup::None);
        if (spec.work.group > ActionGroup::Toggle) {
            QActionGroup*& group = groups[spec.work.group];
            if (!group) {
                group = new QActionGroup(this);
            }
            group->addAction(action);
        }
        actions_.emplace(spec.id, action);
    }
    actions_.at(ActionId::ResetEase)->setShortcuts({Qt::Key_Delete, Qt::Key_Backspace});
    actions_.at(ActionId::Redo)
        ->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
    actions_.at(ActionId::Quit)->setMenuRole(QAction::QuitRole);
    actions_.at(ActionId::About)->setMenuRole(QAction::AboutRole);
    actions_.at(ActionId::EditPreferences)->setMenuRole(QAction::PreferencesRole);
}

void ActionRegistry::connectTo(GarmentActions& garment) const {
    for (const ActionSpec& spec : actionTable()) {
        if (spec.work.run) {
            on(spec.id, &garment,
               [&garment, &run = spec.work.run](bool checked) { run(garment, checked); });
        }
    }
}

void ActionRegistry::followEnabled(Workspace& workspace, const DocumentChange* what) const {
    for (const ActionSpec& spec : actionTable()) {
        const When& when = spec.work.enabledWhen;
        if (when && (!what || !when.reads || when.reads(*what))) {
            ++evaluations_;
            (*this)[spec.id].setEnabled(when(workspace));
        }
    }
}

void ActionRegistry::followChecked(Workspace& workspace) const {
    for (const ActionSpec& spec : actionTable()) {
        if (spec.work.checkedWhen) {
            ++evaluations_;
            (*this)[spec.id].setChecked(spec.work.checkedWhen(workspace));
        }
    }
    showWanted();
}

void ActionRegistry::setPlain(bool plain) {
    plain_ = plain;
    showWanted();
}

void ActionRegistry::showWanted() const {
    const bool isOtherSolver = actions_.at(ActionId::SolverSlcp)->isChecked();
    for (const auto& [id, action] : actions_) {
        // The default solver is listed only as the way back from another one.
        const bool isInUse = id == ActionId::SolverNewton ? isOtherSolver : action->isChecked();
        action->setVisible(!plain_ || !isForSpecialists(id) || isInUse);
    }
}

QString ActionRegistry::title(ActionId id) const {
    return withoutMnemonic(app::tr(std::ranges::find(actionTable(), id, &ActionSpec::id)->text));
}

}  // namespace toile::app
