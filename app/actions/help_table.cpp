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
    const char* group;  ///< to be translated, as the others
    const char* keys;
    const char* does;
};

// lupdate knows this name, and takes the namespace for the context.
#define TR(text) text

/// Those of one group follow each other.
const std::vector<Gesture>& gestures() {
    static constexpr auto kGarment = TR("In the garment view"),
                          kHabits = TR("In the garment view, as Preferences choose"),
                          kPattern = TR("In the pattern view"), kBoth = TR("In both views"),
                          kSelect = TR("With the Select tool"), kCut = TR("With the Cut tool"),
                          kLoop = TR("With the Closed loop tool"), kDart = TR("With the Dart tool"),
                          kJoin = TR("With the Join tool"), kMeasure = TR("With the Measure tool"),
                          kGrain = TR("With the Grain tool"), kNotch = TR("With the Notch tool"),
                          kLine = TR("With the Internal line tool"), kLists = TR("In the lists");
    static const std::vector<Gesture> table = {
        {kGarment, TR("Drag"), TR("Turn the garment, where the tool does not take the drag")},
        {kGarment, TR("Shift+drag"), TR("Move the garment")},
        {kGarment, TR("Number pad 1, 3, 7"),
         TR("Show the front, the right side, the top; with Ctrl the side opposite to it")},
        {kGarment, TR("Number pad 9"), TR("Show the opposite side")},
        {kGarment, TR("Number pad 2, 4, 6, 8"), TR("Turn the garment by 15°")},
        {kGarment, TR("Number pad 5"), TR("Show it with perspective or without")},
        {kGarment, TR("Click on the axis cross"), TR("Show the garment from that side")},
        {kHabits, TR("Toile"), TR("Middle or right drag: turn; with Shift: move; with Ctrl: zoom")},
        {kHabits, TR("Blender"),
         TR("Middle drag or Alt+drag: turn; with Shift: move; with Ctrl: "
            "zoom")},
        {kHabits, TR("CLO"), TR("Right drag: turn; middle drag: move")},
        {kHabits, TR("Rhino"), TR("Right drag: turn; with Shift: move; with Ctrl: zoom")},
        {kPattern, TR("Space+drag, middle drag"), TR("Move the sheet")},
        {kBoth, TR("Wheel"), TR("Zoom towards the pointer")},
        {kBoth, TR("Right click, menu key, Shift+F10"),
         TR("Show what can be done with the piece, the seam or the selection")},
        {kSelect, TR("Click"),
         TR("Select the piece, the seam or, from near by, the vertex; beside all: select nothing")},
        {kSelect, TR("Ctrl+click, Shift+click"),
         TR("Add the piece to the selection, or take it out")},
        {kSelect, TR("Double click"),
         TR("Frame the piece; on an edge: select it from corner to corner; beside all pieces: "
            "frame everything")},
        {kSelect, TR("Drag a piece in the pattern view"), TR("Move the selected pieces")},
        {kSelect, TR("Drag the sheet"),
         TR("Select what a box touches; with Ctrl or Shift: besides what is selected")},
        {kSelect, TR("Drag the handle above the selection"),
         TR("Turn the selected pieces; with Shift: in steps of 15°")},
        {kSelect, TR("Alt while dragging"),
         TR("Snap where snapping is off, and the other way round")},
        {kSelect, TR("Arrow keys"),
         TR("Move the selected pieces by 1 mm (1/16 in), with Shift by 10 mm (1/2 in)")},
        {kSelect, TR("Esc while dragging"), TR("Take the drag back")},
        {kSelect, TR("Esc"), TR("Select nothing; while something runs: stop it")},
        {kCut, TR("Click"), TR("Set the next point; begin on an edge to open the piece there")},
        {kCut, TR("Ctrl+click"), TR("Go there along the edges of the mesh")},
        {kCut, TR("Alt+click"), TR("Cut around the tube there, while nothing is begun")},
        {kCut, TR("Alt"), TR("Draw to no edge or corner, while a line is begun")},
        {kCut, TR("Double click, Enter"), TR("Cut")},
        {kCut, TR("Backspace"), TR("Take the last point back")},
        {kCut, TR("Esc"), TR("Throw the cut away; without one: back to selecting")},
        {kLoop, TR("Click"), TR("Set the next point, of three or more")},
        {kLoop, TR("Ctrl+click"), TR("Go there along the edges of the mesh")},
        {kLoop, TR("Alt+click"), TR("Cut around the tube there, while nothing is begun")},
        {kLoop, TR("Alt"), TR("Draw to no edge or corner, while a line is begun")},
        {kLoop, TR("Click on the first point, double click, Enter"), TR("Cut the part out")},
        {kLoop, TR("Backspace"), TR("Take the last point back")},
        {kLoop, TR("Esc"), TR("Throw the cut away; without one: back to selecting")},
        {kDart, TR("Drag from an edge"), TR("Cut a dart to where the drag ends")},
        {kDart, TR("Click an edge, then the tip"), TR("The same, by two clicks")},
        {kDart, TR("Ctrl+click"), TR("Cut along the edges of the mesh")},
        {kDart, TR("Alt"), TR("Draw to no edge or corner, while a line is begun")},
        {kDart, TR("Backspace, Esc"),
         TR("Throw the dart away; Esc without one: back to selecting")},
        {kJoin, TR("Click a seam"),
         TR("Join the cloth on both sides of it, so that it becomes one")},
        {kJoin, TR("Esc"), TR("Back to selecting")},
        {kMeasure, TR("Click"), TR("Measure from here, and on to the next place")},
        {kMeasure, TR("Double click, Enter"), TR("End here")},
        {kMeasure, TR("Backspace"), TR("Take the last place back")},
        {kMeasure, TR("Ctrl+C"), TR("Copy what is measured")},
        {kMeasure, TR("Esc"), TR("Clear the measure; without one: back to selecting")},
        {kGrain, TR("Drag on a piece in the pattern view"), TR("Turn its grain")},
        {kGrain, TR("Alt while dragging"),
         TR("Snap where snapping is off, and the other way round")},
        {kGrain, TR("Click"), TR("Select the piece")},
        {kGrain, TR("Esc"), TR("Take the drag back; without one: back to selecting")},
        {kNotch, TR("Click a seam"), TR("Add a notch there, on both sides of the seam")},
        {kNotch, TR("Drag a notch"), TR("Move it along its seam, on both sides")},
        {kNotch, TR("Click a notch"), TR("Select it")},
        {kNotch, TR("Ctrl+click a notch, Del"), TR("Take the notch away")},
        {kNotch, TR("Esc"), TR("Take the drag back; without one: back to selecting")},
        {kLine, TR("Click"), TR("Set the next point of the line")},
        {kLine, TR("Click on the first point"), TR("Close the line")},
        {kLine, TR("Double click, Enter"), TR("End the line; of one point: make it a drill point")},
        {kLine, TR("Backspace"), TR("Take the last point back")},
        {kLine, TR("Click a line"), TR("Select it")},
        {kLine, TR("Drag a point of a line"), TR("Move the point")},
        {kLine, TR("Del"), TR("Take the selected line away")},
        {kLine, TR("Esc"),
         TR("Throw the line away, take the drag back; without either: back to selecting")},
        {kLists, TR("Click"), TR("Select the piece or the seam in both views")},
        {kLists, TR("Double click"), TR("Frame the piece or the seam in both views")},
        {kLists, TR("Right click, menu key, Shift+F10"),
         TR("Show what can be done with the piece or the seam")},
        {kLists, TR("Double click on a name, F2"), TR("Call the piece otherwise")},
        {kLists, TR("Right click on the headings"), TR("Choose the columns of the list of pieces")},
        {kLists, TR("Click on a heading"), TR("Sort by that column")},
    };
    return table;
}

#undef TR

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
