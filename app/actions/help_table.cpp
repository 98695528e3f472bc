// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/help_table.h"

#include <QAction>
#include <QTextStream>

#include "app/actions/action_registry.h"
#include "app/actions/menu_table.h"
#include "app/base/translate.h"

namespace toile {

namespace {

void add(std::vector<HelpGroup>& groups, const QString& title, HelpRow row) {
    if (groups.empty() || groups.back().title != title) {
        groups.push_back({title, {}});
    }
    groups.back().rows.push_back(std::move(row));
}

QString cell(QString text) {
    return text.replace('|', "\\|");
}

}  // namespace

std::vector<HelpGroup> helpGroups(const ActionRegistry& actions,
                                  QKeySequence::SequenceFormat format) {
    std::vector<HelpGroup> groups;
    for (const PlacedAction& placed : placedActions()) {
        const QAction& action = actions[placed.id];
        QStringList keys;
        for (const QKeySequence& shortcut : action.shortcuts()) {
            keys << shortcut.toString(format);
        }
        if (!keys.isEmpty()) {
            add(groups, placed.menus.front(),
                {keys.join(", "), actions.title(placed.id), action.statusTip()});
        }
    }
    for (const Gesture& gesture : gestures()) {
        add(groups, tr(gesture.group), {tr(gesture.keys), tr(gesture.does), {}});
    }
    return groups;
}

QString helpMarkdown(const std::vector<HelpGroup>& groups) {
    QString text;
    QTextStream out(&text);
    out << "# " << tr("Keyboard and mouse") << "\n\n"
        << tr("Every command is also found by typing a few letters of it: Ctrl+K.") << '\n';
    for (const HelpGroup& group : groups) {
        out << "\n## " << group.title << "\n\n| " << tr("Keys") << " | " << tr("What") << " | |\n"
            << "|---|---|---|\n";
        for (const HelpRow& row : group.rows) {
            out << "| " << cell(row.keys) << " | " << cell(row.title) << " | " << cell(row.tip)
                << " |\n";
        }
    }
    out.flush();
    return text;
}

}  // namespace toile
