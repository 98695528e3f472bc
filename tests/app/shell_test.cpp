// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractAnimation>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTabBar>
#include <QTextBrowser>
#include <QTextStream>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>
#include <memory>
#include <set>

#include "app/actions/action_registry.h"
#include "app/actions/help_table.h"
#include "app/actions/menu_table.h"
#include "app/document/document.h"
#include "app/panels/pieces_model.h"
#include "app/panels/preferences_dialog.h"
#include "app/settings/length_display.h"
#include "app/settings/preferences.h"
#include "app/settings/theme.h"
#include "app/views/pattern_view.h"
#include "app/views/tools/tool_box.h"
#include "app/views/view_area.h"
#include "app/widgets/command_palette.h"
#include "app/widgets/command_search.h"
#include "app/widgets/hint_label.h"
#include "app/window/window_menus.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

namespace {

QString markdownCell(QString text) {
    return text.replace('|', "\\|");
}

/// As a page of the manual.
QString helpMarkdown(const std::vector<HelpGroup>& groups) {
    QString text;
    QTextStream out(&text);
    out << "# Keyboard and mouse\n\n"
           "Every command is also found by typing a few letters of it: Ctrl+K.\n";
    for (const HelpGroup& group : groups) {
        out << "\n## " << group.title << "\n\n| Keys | What | |\n|---|---|---|\n";
        for (const HelpRow& row : group.rows) {
            out << "| " << markdownCell(row.keys) << " | " << markdownCell(row.title) << " | "
                << markdownCell(row.tip) << " |\n";
        }
    }
    out.flush();
    return text;
}

}  // namespace

/// What surrounds the views: the tables of actions and menus, command palette, help, preferences,
/// welcome page.
class ShellTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    MainWindow& window() { return fixture_.window(); }
    QWidget& palette() { return fixture_.find<QWidget>("commandPalette"); }
    QLineEdit& line() { return fixture_.find<QLineEdit>("commandLine"); }
    QListWidget& list() { return fixture_.find<QListWidget>("commandList"); }

    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(&window(), key, modifiers);
    }

    /// Opens the palette by its keys and types into it.
    void ask(const QString& text) {
        press(Qt::Key_K, Qt::ControlModifier);
        QVERIFY(palette().isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(line().hasFocus(), test::kPatience);
        QTest::keyClicks(&line(), text);
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        test::writeObj(fixture_.path("pair.obj").toStdString(),
                       {{"strip", test::makeBentStrip(-140)}, {"cap", test::makeCap(140)}});
    }

    void init() {
        fixture_.open();
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
    }
    void cleanup() { fixture_.close(); }

    void everyActionIsInOneMenuAndSaysWhatItDoes() {
        std::set<ActionId> seen;
        for (const PlacedAction& placed : placedActions()) {
            QVERIFY2(seen.insert(placed.id).second,
                     qPrintable(window().actions().title(placed.id)));
            QVERIFY(!placed.menus.isEmpty());
        }
        for (const ActionSpec& spec : actionTable()) {
            const ActionId id = spec.id;
            const QAction& action = window().actions()[id];
            QVERIFY2(seen.count(id) == 1, qPrintable(action.objectName()));
            QVERIFY2(!action.statusTip().isEmpty(), qPrintable(action.objectName()));
        }
    }

    void noTwoActionsShareAKeyOrAName() {
        std::set<QString> keys, names;
        const QAction* ease = &window().actions()[ActionId::StateEase];
        for (const QAction* action : window().actions().all()) {
            QVERIFY(names.insert(action->objectName()).second);
            if (action == ease) {  // of a seam, what renaming is of a piece: never both
                QCOMPARE(action->shortcut(), window().actions()[ActionId::RenamePiece].shortcut());
                continue;
            }
            for (const QKeySequence& key : action->shortcuts()) {
                QVERIFY2(keys.insert(key.toString()).second, qPrintable(key.toString()));
            }
        }
    }

    void menusAreThoseOfTheTable() {
        for (const MenuSpec& spec : menuTable()) {
            std::unique_ptr<QMenu> context;  // those that are made where something is pointed at
            auto* menu = window().findChild<QMenu*>(spec.name);
            QVERIFY(!menu || spec.place != MenuPlace::Context);
            if (!menu) {
                context.reset(makeContextMenu(spec.name, window().actions(),
                                              window().garmentActions().materials(), nullptr));
                menu = context.get();
            } else {
                QCOMPARE(menu->title(), QString(spec.title));
            }
            QList<QAction*> expected;
            for (const MenuItem& item : spec.items) {
                if (const auto* id = std::get_if<ActionId>(&item)) {
                    expected << &window().actions()[*id];
                }
            }
            QList<QAction*> present = menu->actions();
            present.removeIf([&](QAction* action) { return !expected.contains(action); });
            QCOMPARE(present, expected);
        }
    }

    void mnemonicsAreTakenOut() {
        QCOMPARE(withoutMnemonic("Save && &close…"), QString("Save & close…"));
        QCOMPARE(withoutMnemonic("&"), QString());
    }

    void lettersFitInTheirOrder() {
        QVERIFY(fuzzyMatch("wfr", "Show wireframe"));
        QVERIFY(!fuzzyMatch("rfw", "Show wireframe"));
        QVERIFY(!fuzzyMatch("svg", "Angles spread evenly (Wang 2005)"));
        QCOMPARE(fuzzyMatch("es", "Edge strain")->letters, (std::vector<int>{0, 5}));
        QCOMPARE(fuzzyMatch("strain", "Edge strain")->letters,
                 (std::vector<int>{5, 6, 7, 8, 9, 10}));
        QVERIFY(fuzzyMatch("str", "Edge strain")->score >
                fuzzyMatch("str", "Seam 6: front / right")->score);
        QVERIFY(fuzzyMatch("levy", "Least squares (Lévy 2002)"));
        QVERIFY(fuzzyMatch("open", "Open")->score > fuzzyMatch("open", "Top end")->score);
        QCOMPARE(fuzzyMatch("", "anything")->score, 0);
        QVERIFY(beginsWord("pat", "Export pattern"));
        QVERIFY(!beginsWord("tern", "Export pattern"));
    }

    void whatCannotBeRunIsListedLast() {
        const std::vector<Command> commands = {
            {.text = "Frame", .enabled = false, .run = [] {}},
            {.text = "Far frame", .run = [] {}},
            {.text = "Piece: frame", .listedUnasked = false, .run = [] {}}};
        QCOMPARE(searchCommands(commands, "").size(), std::size_t(2));
        const auto found = searchCommands(commands, "frame");
        QCOMPARE(found.size(), std::size_t(3));
        QCOMPARE(found.back().command, 0);
    }

    void wordsGoBeforeScatteredLetters() {
        const auto first = [](const std::vector<Command>& commands, const QString& typed) {
            const auto found = searchCommands(commands, typed);
            return found.empty() ? QString()
                                 : commands[static_cast<std::size_t>(found.front().command)].text;
        };
        const std::vector<Command> commands = {
            {.text = "Least stretch on a circle", .run = [] {}},
            {.text = "Checkerboard", .tip = "True-scale squares of 1 cm", .run = [] {}},
            {.text = "Principal strain", .run = [] {}},
            {.text = "Print pattern…", .run = [] {}},
            {.text = "Export pattern…", .tip = "Write a file for printing", .run = [] {}},
            {.text = "sleeve_left / front", .run = [] {}},
            {.text = "sleeve_left", .run = [] {}}};
        QCOMPARE(first(commands, "scale"), QString("Checkerboard"));
        QCOMPARE(first(commands, "print"), QString("Print pattern…"));
        QCOMPARE(first(commands, "sle"), QString("sleeve_left"));
        QCOMPARE(first(commands, "ps"), QString("Principal strain"));
    }

    void typedCommandRuns() {
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        ask("edge str");
        QCOMPARE(list().currentItem()->text(), QString("Edge strain"));
        QCOMPARE(list().currentItem()->data(CommandPalette::KeysRole).toString(), QString("5"));
        QCOMPARE(list().currentItem()->data(CommandPalette::PlaceRole).toString(),
                 QString("View \u25B8 Overlay"));
        QTest::keyClick(&line(), Qt::Key_Return);
        QVERIFY(!palette().isVisible());
        QCOMPARE(fixture_.document().view().overlay, Overlay::Strain);
    }

    void keysWhileTypingDoNothingElse() {
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        const Overlay before = fixture_.document().view().overlay;
        ask("w1f5");
        QCOMPARE(line().text(), QString("w1f5"));
        QCOMPARE(fixture_.document().view().overlay, before);
        QVERIFY(!fixture_.document().view().wireframe);
        QTest::keyClick(&line(), Qt::Key_Escape);
        QVERIFY(!palette().isVisible());
    }

    void disabledCommandIsShownButNotRun() {
        ask("export");
        QVERIFY(list().count() > 0);
        QCOMPARE(list().currentItem()->text(), QString("Export pattern…"));
        QVERIFY(!list().currentItem()->flags().testFlag(Qt::ItemIsEnabled));
        QVERIFY(fixture_.find<QLabel>("commandTip").text().startsWith("Not available now"));
        QTest::keyClick(&line(), Qt::Key_Return);
        QVERIFY(palette().isVisible());
        QTest::keyClick(&line(), Qt::Key_Escape);
    }

    void arrowsMoveThroughTheList() {
        ask("");
        const int count = list().count();
        QVERIFY(count > 20);
        QCOMPARE(list().currentRow(), 0);
        QTest::keyClick(&line(), Qt::Key_Down);
        QCOMPARE(list().currentRow(), 1);
        QTest::keyClick(&line(), Qt::Key_Up);
        QTest::keyClick(&line(), Qt::Key_Up);
        QCOMPARE(list().currentRow(), count - 1);
        QTest::keyClick(&line(), Qt::Key_PageUp);
        QVERIFY(list().currentRow() < count - 1);
        QTest::keyClicks(&line(), "qqqqq");
        QCOMPARE(list().count(), 0);
        QTest::keyClick(&line(), Qt::Key_Return);
        QTest::keyClick(&line(), Qt::Key_Escape);
    }

    void piecesAndSeamsAreFound() {
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        ask("cap");
        QCOMPARE(list().currentItem()->text(), QString("Piece: cap"));
        QTest::keyClick(&line(), Qt::Key_Return);
        QCOMPARE(fixture_.document().selection(), Document::Selection{1});
        QVERIFY(fixture_.document().seamCount() > 0);
        ask("seam 1:");
        QVERIFY(list().currentItem()->text().startsWith("Seam 1:"));
        QTest::keyClick(&line(), Qt::Key_Return);
        QCOMPARE(fixture_.document().seam(), std::optional<int>(0));
    }

    void methodsAreFoundByTheWordsOfTheCommandLine() {
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        ask("isometric");
        QCOMPARE(list().count(), 1);
        QVERIFY(list().item(0)->text().startsWith("Least distortion"));
        press(Qt::Key_Escape);
    }

    void clickElsewhereClosesThePalette() {
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        ask("fr");
        fixture_.find<QTreeView>("pieceTable").setFocus(Qt::MouseFocusReason);
        QVERIFY(!palette().isVisible());
    }

    void helpListsEveryKey() {
        press(Qt::Key_F1);
        auto& text = fixture_.find<QTextBrowser>("helpText");
        QTRY_VERIFY_WITH_TIMEOUT(text.isVisible(), test::kPatience);
        const QString shown = text.toPlainText();
        for (const QAction* action : window().actions().all()) {
            for (const QKeySequence& key : action->shortcuts()) {
                QVERIFY2(shown.contains(key.toString(QKeySequence::NativeText)),
                         qPrintable(action->objectName()));
            }
        }
        QVERIFY(shown.contains("Zoom towards the pointer"));
        QTest::keyClicks(&fixture_.find<QLineEdit>("helpLine"), "wireframe");
        QVERIFY(text.toPlainText().contains("Show wireframe"));
        QVERIFY(!text.toPlainText().contains("Undo"));
    }

    void helpTellsWhatEveryToolDoes() {
        const auto groups = helpGroups(window().actions(), QKeySequence::PortableText);
        constexpr std::pair<ToolId, ActionId> kTools[] = {
            {ToolId::Select, ActionId::ToolSelect},
            {ToolId::Cut, ActionId::ToolCut},
            {ToolId::Loop, ActionId::ToolLoop},
            {ToolId::Dart, ActionId::ToolDart},
            {ToolId::Join, ActionId::ToolJoin},
            {ToolId::Measure, ActionId::ToolMeasure},
            {ToolId::Grain, ActionId::ToolGrain},
            {ToolId::Notch, ActionId::ToolNotch},
            {ToolId::InternalLine, ActionId::ToolInternalLine}};
        static_assert(std::size(kTools) == kToolCount);
        for (const auto& [id, action] : kTools) {
            const QString title = "With the " + window().actions().title(action) + " tool";
            const auto group = std::ranges::find(groups, title, &HelpGroup::title);
            QVERIFY2(group != groups.end(), qPrintable(title));
            QString keys;
            for (const HelpRow& row : group->rows) {
                keys += row.keys.toLower() + "; ";
            }
            // What the status bar says of the tool has a row.
            const Tool& tool = window().tools().tool(id);
            const QString hint = tool.hint(ViewKind::Pattern).toLower();
            for (const QString key : {"ctrl+click", "double click", "alt", "arrow keys", "esc"}) {
                QVERIFY2(!hint.contains(key) || keys.contains(key), qPrintable(title + ": " + key));
            }
        }
    }

    void escapeLeavesEveryToolForSelecting() {
        for (const ToolId id :
             {ToolId::Cut, ToolId::Loop, ToolId::Dart, ToolId::Join, ToolId::Measure, ToolId::Grain,
              ToolId::Notch, ToolId::InternalLine}) {
            ToolBox& tools = window().tools();
            tools.choose(id);
            for (const ViewKind view : {ViewKind::Garment, ViewKind::Pattern}) {
                QVERIFY(tools.current().hint(view).contains("Esc: leave the tool"));
            }
            const QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
            QVERIFY(tools.current().wants(escape));
            tools.current().key(*window().views().patternView(), escape);
            QCOMPARE(tools.current().id(), ToolId::Select);
        }
    }

    void pageOfTheManualIsTheTable() {
        const QString page =
            helpMarkdown(helpGroups(window().actions(), QKeySequence::PortableText));
        QFile file(TOILE_SOURCE_DIR "/docs/shortcuts.md");
        if (qEnvironmentVariableIsSet("TOILE_UPDATE_DOCS")) {
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(page.toUtf8());
            return;
        }
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY2(QString::fromUtf8(file.readAll()) == page, "write it anew: TOILE_UPDATE_DOCS=1");
    }

    void preferencesOpenByTheirKeysAndChangeTheTables() {
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        auto& table = fixture_.find<QTreeView>("pieceTable");
        const auto header = [&table] {
            return table.model()->headerData(PiecesModel::Outline, Qt::Horizontal).toString();
        };
        const auto cell = [&table] {
            return table.model()->index(0, PiecesModel::Outline).data().toString();
        };
        QCOMPARE(header(), QString("Outline mm"));
        const QString before = cell();
        press(Qt::Key_Comma, Qt::ControlModifier);
        auto& dialog = fixture_.find<PreferencesDialog>("preferencesDialog");
        QTRY_VERIFY_WITH_TIMEOUT(dialog.isVisible(), test::kPatience);
        QTest::keyClick(dialog.findChild<QWidget*>("lengthUnitChoice"), Qt::Key_End);
        QCOMPARE(header(), QString("Outline in"));
        QVERIFY(cell() != before);
        QVERIFY(fixture_.find<QToolButton>("garmentSummary").text().contains(" in "));
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QCOMPARE(cell(), before);
    }

    void columnsAreChosenAndFit() {
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        auto& table = fixture_.find<QTreeView>("pieceTable");
        QVERIFY(table.isColumnHidden(PiecesModel::Triangles));
        QTRY_VERIFY_WITH_TIMEOUT(table.header()->length() <= table.viewport()->width(),
                                 test::kPatience);
        emit table.header()->customContextMenuRequested({10, 5});
        auto* menu = table.findChild<QMenu*>("columnMenu");
        QVERIFY(menu != nullptr);
        menu->findChild<QAction*>("triangles")->trigger();
        menu->close();
        QVERIFY(!table.isColumnHidden(PiecesModel::Triangles));
        for (const int width : {1000, 1400}) {
            window().resize(width, 800);
            QTRY_VERIFY_WITH_TIMEOUT(table.header()->length() <= table.viewport()->width(),
                                     test::kPatience);
        }
    }

    void layoutIsReset() {
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        auto& pieces = fixture_.find<QDockWidget>("piecesDock");
        auto& seams = fixture_.find<QDockWidget>("seamsDock");
        window().addDockWidget(Qt::RightDockWidgetArea, &seams);
        pieces.setFloating(true);
        auto& position = fixture_.find<QDockWidget>("propertiesDock");
        auto& fabric = fixture_.find<QDockWidget>("fabricDock");
        window().addDockWidget(Qt::LeftDockWidgetArea, &fabric);
        position.close();
        fixture_.action(ActionId::ResetLayout).trigger();
        QVERIFY(!pieces.isFloating());
        QVERIFY(!seams.isHidden());
        QTRY_VERIFY_WITH_TIMEOUT(!pieces.visibleRegion().isEmpty(),
                                 test::kPatience);  // the tab in front
        QCOMPARE(window().dockWidgetArea(&seams), Qt::BottomDockWidgetArea);
        QVERIFY(window().tabifiedDockWidgets(&pieces).contains(&seams));
        for (QDockWidget* dock : {&position, &fabric}) {
            QVERIFY(dock->isVisible());
            QCOMPARE(window().dockWidgetArea(dock), Qt::RightDockWidgetArea);
        }
        QTRY_VERIFY_WITH_TIMEOUT(fabric.y() >= position.y() + position.height(), test::kPatience);
    }

    void noTabBarIsLeftOverTheLists() {
        const auto emptyTabBars = [this]() -> int {
            const auto bars =
                window().findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly);
            return static_cast<int>(std::ranges::count_if(bars, [](const QTabBar* bar) -> bool {
                return bar->isVisible() && bar->count() == 0;
            }));
        };
        // Docks glide into their places, and tab bars that nothing is left in go after that.
        const auto hasNoneOnceAllStands = [this, emptyTabBars]() -> bool {
            const auto glides = [this]() -> bool {
                return std::ranges::any_of(window().findChildren<QAbstractAnimation*>(),
                                           [](const QAbstractAnimation* animation) -> bool {
                                               return animation->state() ==
                                                      QAbstractAnimation::Running;
                                           });
            };
            QCoreApplication::processEvents();
            return QTest::qWaitFor(
                [&glides, &emptyTabBars] { return !glides() && emptyTabBars() == 0; },
                test::kPatience);
        };
        fixture_.openAndWait(fixture_.path("pair.obj"));
        QVERIFY(hasNoneOnceAllStands());
        for (int k = 0; k < 3; ++k) {
            fixture_.action(ActionId::ResetLayout).trigger();
            QVERIFY(hasNoneOnceAllStands());
        }
        const QByteArray state = window().saveState();
        window().restoreState(state);
        QVERIFY(hasNoneOnceAllStands());
    }

    void aLayoutOfAnEarlierVersionIsLeftAlone() {
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        auto& fabric = fixture_.find<QDockWidget>("fabricDock");
        window().addDockWidget(Qt::BottomDockWidgetArea, &fabric);
        fabric.close();
        const QByteArray earlier = window().saveState();  // version 0, as before there was a fabric
        fixture_.preferences().setWindowState(earlier);
        MainWindow next(fixture_.preferences());
        next.show();
        next.openFiles({fixture_.path("pair.obj")});
        QTRY_VERIFY_WITH_TIMEOUT(next.workspace().document().garment(), test::kPatience);
        auto* there = next.findChild<QDockWidget*>("fabricDock");
        QVERIFY(there->isVisible());
        QCOMPARE(next.dockWidgetArea(there), Qt::RightDockWidgetArea);
    }

    void welcomePageListsWhatWasOpened() {
        QVERIFY(!fixture_.find<QWidget>("recentFiles").isVisible());
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        QList<QStringList> recent = fixture_.preferences().recentFiles();
        recent.prepend({fixture_.path("gone.obj")});
        fixture_.preferences().setRecentFiles(recent);
        auto& button = fixture_.find<QPushButton>("recent-1");
        QCOMPARE(button.text(), QString("pair.obj"));  // what is gone is not offered
        QVERIFY(window().findChild<QWidget*>("recent-2") == nullptr);
    }

    void welcomePageIsWorkedByKeyboard() {
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        const QList<QStringList> recent = fixture_.preferences().recentFiles();
        fixture_.close();
        fixture_.open();
        fixture_.preferences().setRecentFiles(recent);
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        auto& open = fixture_.find<QPushButton>("welcomeOpen");
        auto& first = fixture_.find<QPushButton>("recent-1");
        QVERIFY(QTest::qWaitFor([&first] { return first.isVisible(); }));
        QCOMPARE(open.nextInFocusChain(), &first);  // down the page
        first.setFocus();
        QTest::keyClick(&first, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(fixture_.document().garment(), test::WindowFixture::kPatience);
    }

    void welcomePageIsLegibleInEveryTheme() {
        for (const QPalette& theme : {darkPalette(), lightPalette()}) {
            window().setPalette(theme);
            for (const QLabel* label : window().findChildren<QLabel*>("faintText")) {
                const QPalette shown = label->palette();
                const int ink = shown.color(QPalette::WindowText).lightness();
                QVERIFY(std::abs(ink - theme.color(QPalette::Window).lightness()) > 100);
            }
        }
        QVERIFY(window().findChild<QLabel*>("faintText"));
    }

    void hintsAreWholeClausesAndTheTipHasAll() {
        const auto clauses = hintClauses("Click: select · Shift+drag: move · a sentence");
        QCOMPARE(clauses.size(), std::size_t(3));
        QCOMPARE(clauses[1].keys, QString("Shift+drag"));
        QCOMPARE(clauses[1].what, QString("move"));
        QVERIFY(clauses[2].keys.isEmpty());
        HintLabel label;
        label.setHint("Click: select · Drag: turn · Wheel: zoom · Esc: select nothing");
        QCOMPARE(label.fitting(10000), HintLabel::kMaxHintsShown);
        std::size_t before = HintLabel::kMaxHintsShown;
        for (int width = 600; width > 0; width -= 5) {
            QVERIFY(label.fitting(width) <= before);
            before = label.fitting(width);
        }
        QCOMPARE(before, std::size_t(0));
        QVERIFY(label.toolTip().contains("Esc: select nothing"));
    }

    void whatIsTypedIsTakenBackByTheWindowsKeys() {
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        Document& document = fixture_.document();
        document.setSelection({0});
        auto& angle = fixture_.find<QDoubleSpinBox>("positionAngle");
        angle.setFocus();
        angle.selectAll();
        QTest::keyClicks(&angle, "33");
        QTest::keyClick(&angle, Qt::Key_Return);
        QCOMPARE(document.history().undoText(), "Turn " + pieceName(document, 0));
        QTest::keyClick(&angle, Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!document.history().canUndo(), test::kPatience);
        QCOMPARE(angle.value(), 0.0);
    }

    void heavyGarmentsWaitToBeAsked() {
        Choices choices = fixture_.preferences().choices();
        choices.autoFlattenTriangles = 10;
        fixture_.preferences().setChoices(choices);
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        QVERIFY(!fixture_.workspace().autoFlatten());
        QVERIFY(!fixture_.action(ActionId::AutoFlatten).isChecked());
    }

    void otherChoicesLeaveFlatteningAsItIs() {
        QVERIFY(fixture_.openAndWait(fixture_.path("pair.obj")));
        fixture_.workspace().setAutoFlatten(false);
        Choices choices = fixture_.preferences().choices();
        choices.autosaveMinutes += 1;
        fixture_.preferences().setChoices(choices);
        QVERIFY(!fixture_.workspace().autoFlatten());
    }
};

TOILE_WINDOW_TEST(ShellTest)
#include "shell_test.moc"
