// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/command_list.h"

#include <QAction>
#include <map>
#include <set>

#include "app/actions/action_registry.h"
#include "app/actions/menu_table.h"
#include "app/base/translate.h"
#include "app/document/document.h"

namespace toile::app {

namespace {

/// "▸" between a menu and its submenu.
const QString kInto = QStringLiteral(" \u25b8 ");

Command commandOf(QAction& action, const QString& place) {
    Command command;
    command.text = withoutMnemonic(action.text());
    if (action.isCheckable() && action.isChecked()) {
        command.text += QStringLiteral(" \u2713");
    }
    command.place = place;
    command.tip = action.statusTip();
    command.keys = action.shortcut().toString(QKeySequence::NativeText);
    command.icon = action.icon();
    command.enabled = action.isEnabled();
    command.run = [&action] { action.trigger(); };
    return command;
}

}  // namespace

std::vector<Command> commandList(const ActionRegistry& actions, const Document& document,
                                 const std::function<void(int)>& showPiece,
                                 const std::function<void(int)>& showSeam) {
    std::map<ActionId, QString> methodWords;
    for (const MethodTraits& method : allMethods()) {
        methodWords[actionOf(method.method)] = QString::fromUtf8(method.name);
    }
    std::vector<Command> commands;
    std::set<ActionId> placed{ActionId::CommandPalette};  // it is open
    for (const PlacedAction& entry : placedActions()) {
        if (placed.insert(entry.id).second) {
            commands.push_back(commandOf(actions[entry.id], entry.menus.join(kInto)));
            if (const auto word = methodWords.find(entry.id); word != methodWords.end()) {
                commands.back().otherwise = word->second;
            }
        }
    }
    for (const ActionSpec& spec : actionTable()) {
        if (placed.insert(spec.id).second) {
            commands.push_back(commandOf(actions[spec.id], {}));
        }
    }
    const auto add = [&](const QString& text, const QString& place, const QString& tip,
                         const std::function<void(int)>& show, int index) {
        Command command;
        command.text = text;
        command.place = place;
        command.tip = tip;
        command.listedUnasked = false;
        command.run = [show, index] { show(index); };
        commands.push_back(std::move(command));
    };
    for (int i = 0; i < document.pieceCount(); ++i) {
        const Piece& piece = *document.garment()->pieces[static_cast<std::size_t>(i)];
        add(tr("Piece: %1").arg(QString::fromStdString(piece.name)), tr("Pieces"),
            tr("Select the piece and show it in both views"), showPiece, i);
    }
    for (int i = 0; i < document.seamCount(); ++i) {
        const Seam& seam = document.garment()->seams.seams[static_cast<std::size_t>(i)];
        add(tr("Seam %1: %2").arg(i + 1).arg(QString::fromStdString(seam.name)), tr("Seams"),
            tr("Select the seam and show both its edges in both views"), showSeam, i);
    }
    return commands;
}

}  // namespace toile::app
