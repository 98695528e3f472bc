// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/help_table.h"

#include <QAction>
#include <map>
#include <set>

#include "app/actions/action_registry.h"
#include "app/actions/menu_table.h"
#include "app/base/text.h"
#include "app/document/document.h"

namespace toile::app {
namespace {

/// What the mouse does, for the help page; keys are in the table of actions.
struct Gesture {
    const char* group;  ///< translated when used, like the others
    const char* keys;
    const char* does;
};

/// Gestures of one group must be adjacent.
const std::vector<Gesture>& gestures() {
    static constexpr auto kGarment = TR("In the garment view"),
                          kHabits = TR("In the garment view, as set in Preferences"),
                          kPattern = TR("In the pattern view"), kBoth = TR("In both views"),
                          kSelect = TR("With the Select tool"), kCut = TR("With the Cut tool"),
                          kLoop = TR("With the Closed loop tool"), kDart = TR("With the Dart tool"),
                          kJoin = TR("With the Join tool"), kMeasure = TR("With the Measure tool"),
                          kGrain = TR("With the Grain tool"), kNotch = TR("With the Notch tool"),
                          kLine = TR("With the Internal line tool"), kLists = TR("In the lists");
    static const std::vector<Gesture> table = {
        {kGarment, TR("Drag"), TR("Turn the garment, unless the tool uses the drag")},
        {kGarment, TR("Shift+drag"), TR("Move the garment")},
        {kGarment, TR("Number pad 1, 3, 7"),
         TR("Show the front, right side or top; with Ctrl the opposite side")},
        {kGarment, TR("Number pad 9"), TR("Show the opposite side")},
        {kGarment, TR("Number pad 2, 4, 6, 8"), TR("Turn the garment by 15°")},
        {kGarment, TR("Number pad 5"), TR("Turn perspective on or off")},
        {kGarment, TR("Click on the axis cross"), TR("Show the garment from that side")},
        {kHabits, TR("Toile"), TR("Middle or right drag: turn; with Shift: move; with Ctrl: zoom")},
        {kHabits, TR("Blender"),
         TR("Middle drag or Alt+drag: turn; with Shift: move; with Ctrl: "
            "zoom")},
        {kHabits, TR("CLO"), TR("Right drag: turn; middle drag: move")},
        {kHabits, TR("Rhino"), TR("Right drag: turn; with Shift: move; with Ctrl: zoom")},
        {kPattern, TR("Space+drag, middle drag"), TR("Move the sheet")},
        {kBoth, TR("Wheel"), TR("Zoom towards the pointer")},
        {kBoth, TR("Plus, minus"), TR("Zoom")},
        {kBoth, TR("Arrow keys"), TR("Move the view, unless the tool uses the keys")},
        {kBoth, TR("Right click, menu key, Shift+F10"),
         TR("Show the commands for the piece, the seam or the selection")},
        {kSelect, TR("Click"),
         TR("Select the piece, the seam or, close to it, the vertex; on empty space: clear the "
            "selection")},
        {kSelect, TR("Ctrl+click, Shift+click"), TR("Add the piece to the selection or remove it")},
        {kSelect, TR("Double click"),
         TR("Frame the piece; on an edge: select the edge from corner to corner; on empty space: "
            "frame everything")},
        {kSelect, TR("Drag a piece in the pattern view"), TR("Move the selected pieces")},
        {kSelect, TR("Drag the sheet"),
         TR("Select everything in a box; with Ctrl or Shift: add it to the selection")},
        {kSelect, TR("Drag the handle above the selection"),
         TR("Turn the selected pieces; with Shift: in steps of 15°")},
        {kSelect, TR("Alt while dragging"), TR("Toggle snapping")},
        {kSelect, TR("Arrow keys"),
         TR("Move the selected pieces by 1 mm (1/16 in), with Shift by 10 mm (1/2 in)")},
        {kSelect, TR("Esc while dragging"), TR("Cancel the drag")},
        {kSelect, TR("Esc"), TR("Stop the running task; otherwise clear the selection")},
        {kCut, TR("Click"), TR("Set the next point; start on an edge to open the piece there")},
        {kCut, TR("Ctrl+click"), TR("Follow mesh edges to the pointer")},
        {kCut, TR("Alt+click"), TR("Cut around the tube there, before the first point")},
        {kCut, TR("Alt"), TR("Do not snap to edges and corners, after the first point")},
        {kCut, TR("Double click, Enter"), TR("Cut")},
        {kCut, TR("Backspace"), TR("Remove the last point")},
        {kCut, TR("Esc"), TR("Discard the cut; without one: leave the tool")},
        {kLoop, TR("Click"), TR("Set the next point; at least three are needed")},
        {kLoop, TR("Ctrl+click"), TR("Follow mesh edges to the pointer")},
        {kLoop, TR("Alt+click"), TR("Cut around the tube there, before the first point")},
        {kLoop, TR("Alt"), TR("Do not snap to edges and corners, after the first point")},
        {kLoop, TR("Click on the first point, double click, Enter"), TR("Cut out the part")},
        {kLoop, TR("Backspace"), TR("Remove the last point")},
        {kLoop, TR("Esc"), TR("Discard the cut; without one: leave the tool")},
        {kDart, TR("Drag from an edge"), TR("Cut a dart to the end of the drag")},
        {kDart, TR("Click an edge, then the tip"), TR("Cut a dart with two clicks")},
        {kDart, TR("Ctrl+click"), TR("Cut along mesh edges")},
        {kDart, TR("Alt"), TR("Do not snap to edges and corners, after the first point")},
        {kDart, TR("Backspace, Esc"), TR("Discard the dart; Esc without one: leave the tool")},
        {kJoin, TR("Click a seam"), TR("Join the cloth on both sides of the seam")},
        {kJoin, TR("Esc"), TR("Leave the tool")},
        {kMeasure, TR("Click"), TR("Start measuring here, or measure on to the next point")},
        {kMeasure, TR("Double click, Enter"), TR("End the measurement here")},
        {kMeasure, TR("Backspace"), TR("Remove the last point")},
        {kMeasure, TR("Ctrl+C"), TR("Copy the measurement")},
        {kMeasure, TR("Esc"), TR("Clear the measurement; without one: leave the tool")},
        {kGrain, TR("Drag on a piece in the pattern view"), TR("Turn its grain")},
        {kGrain, TR("Alt while dragging"), TR("Toggle snapping")},
        {kGrain, TR("Click"), TR("Select the piece")},
        {kGrain, TR("Esc"), TR("Cancel the drag; without one: leave the tool")},
        {kNotch, TR("Click a seam"), TR("Add a notch there, on both sides of the seam")},
        {kNotch, TR("Drag a notch"), TR("Move the notch along its seam, on both sides")},
        {kNotch, TR("Click a notch"), TR("Select it")},
        {kNotch, TR("Ctrl+click a notch, Del"), TR("Delete the notch")},
        {kNotch, TR("Esc"), TR("Cancel the drag; without one: leave the tool")},
        {kLine, TR("Click"), TR("Set the next point of the line")},
        {kLine, TR("Click on the first point"), TR("Close the line")},
        {kLine, TR("Double click, Enter"),
         TR("End the line; a single point becomes a drill point")},
        {kLine, TR("Backspace"), TR("Remove the last point")},
        {kLine, TR("Click a line"), TR("Select it")},
        {kLine, TR("Drag a point of a line"), TR("Move the point")},
        {kLine, TR("Del"), TR("Delete the selected line")},
        {kLine, TR("Esc"),
         TR("Discard the line or cancel the drag; without either: leave the tool")},
        {kLists, TR("Click"), TR("Select the piece or the seam in both views")},
        {kLists, TR("Double click"), TR("Frame the piece or the seam in both views")},
        {kLists, TR("Right click, menu key, Shift+F10"),
         TR("Show the commands for the piece or the seam")},
        {kLists, TR("Double click on a name, F2"), TR("Rename the piece")},
        {kLists, TR("Right click on the headings"), TR("Choose the columns of the list of pieces")},
        {kLists, TR("Click on a heading"), TR("Sort by that column")},
    };
    return table;
}

void add(std::vector<HelpGroup>& groups, const QString& title, HelpRow row) {
    if (groups.empty() || groups.back().title != title) {
        groups.push_back({title, {}});
    }
    groups.back().rows.push_back(std::move(row));
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

namespace {

/// Separator "▸" between a menu and its submenu.
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
    std::set<ActionId> placed{ActionId::CommandPalette};  // it is already open
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
        add(tr("Piece: %1").arg(pieceName(document, i)), tr("Pieces"),
            tr("Select the piece and show it in both views"), showPiece, i);
    }
    for (int i = 0; i < document.seamCount(); ++i) {
        add(tr("Seam %1: %2").arg(i + 1).arg(seamName(document, i)), tr("Seams"),
            tr("Select the seam and show both its edges in both views"), showSeam, i);
    }
    return commands;
}

}  // namespace toile::app
