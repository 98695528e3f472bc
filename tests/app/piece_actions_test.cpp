// SPDX-License-Identifier: GPL-3.0-or-later
// What is done with pieces as wholes: named, hidden, left out, exported alone; by clicks in views,
// lists and the menus that the right button shows.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QTreeView>

#include "app/document/document.h"
#include "app/document/piece_edits.h"
#include "app/export/export_dialog.h"
#include "app/panels/pieces_model.h"
#include "core/flatten/base/piece_result.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

class PieceActionsTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    QTreeView& table() { return fixture_.find<QTreeView>("pieceTable"); }
    QModelIndex cell(int row, int column) { return table().model()->index(row, column); }
    QString lastStep() { return document().history().undoText(); }

    QPointF inPattern(int piece) {
        const auto at = static_cast<std::size_t>(piece);
        const Eigen::Vector2d pixel = fixture_.patternView().camera().toScreen(
            document().settings()[at].placement->applied(document().scene()->pieces[at].label));
        return {pixel.x(), pixel.y()};
    }
    QPointF inGarment(int piece) {
        const Eigen::Vector2d pixel = fixture_.garmentView().camera().project(
            document().scene()->pieces[static_cast<std::size_t>(piece)].box.center());
        return {pixel.x(), pixel.y()};
    }
    static void rightClick(QWidget& widget, const QPointF& at) {
        test::moveTo(widget, at);
        test::sendMouse(widget, QEvent::MouseButtonPress, at, Qt::RightButton, Qt::RightButton);
        test::sendMouse(widget, QEvent::MouseButtonRelease, at, Qt::RightButton, Qt::NoButton);
    }
    /// The menu that is shown; null where none is.
    QMenu* shown() {
        for (const char* name : {"pieceContext", "seamContext", "groundContext"}) {
            for (auto* menu : fixture_.window().findChildren<QMenu*>(name)) {
                if (menu->isVisible()) {
                    return menu;
                }
            }
        }
        return nullptr;
    }
    void choose(ActionId id) {
        QMenu* menu = shown();
        QVERIFY(menu);
        QVERIFY(menu->actions().contains(&fixture_.action(id)));
        QTest::mouseClick(menu, Qt::LeftButton, {},
                          menu->actionGeometry(&fixture_.action(id)).center());
        QVERIFY(!shown());
    }
    /// The pattern as a file has it now.
    QByteArray svgOf() {
        const QString path = fixture_.path("now.svg");
        QFile::remove(path);
        fixture_.workspace().exportTo(path.toStdString());
        QFile file(path);
        return fixture_.waitUntilIdle() && file.open(QIODevice::ReadOnly) ? file.readAll()
                                                                          : QByteArray();
    }
    void typeName(const QString& name) {
        auto* editor = table().viewport()->findChild<QLineEdit*>();
        QVERIFY(editor);
        editor->selectAll();
        QTest::keyClicks(editor, name);
        // The list takes what was typed a moment later.
        const QPointer<QLineEdit> open(editor);
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(!open, test::kPatience);
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        test::writeObj(fixture_.path("three.obj").toStdString(),
                       {{"front", test::makeSheet(120, 80, 6, 4)},
                        {"back", test::makeSheet(100, 80, 5, 4, {200, 0, 0})},
                        {"button", test::makeSheet(10, 10, 2, 2, {400, 0, 0})}});
    }

    void init() {
        fixture_.open();
        QVERIFY(fixture_.openAndWait(fixture_.path("three.obj")));
    }

    void cleanup() { fixture_.close(); }

    void aPieceIsRenamedAndHiddenByClicksAlone() {
        rightClick(fixture_.patternView(), inPattern(0));
        QCOMPARE(document().selection(), Document::Selection{0});
        choose(ActionId::RenamePiece);
        typeName("Vorderteil");
        QCOMPARE(pieceName(document(), 0), QString("Vorderteil"));
        QCOMPARE(lastStep(), QString("Rename front"));
        QCOMPARE(cell(0, PiecesModel::Name).data().toString(), QString("Vorderteil"));
        const QPointF place = inPattern(0);
        rightClick(fixture_.patternView(), place);
        choose(ActionId::HidePieces);
        QVERIFY(isHidden(document(), 0));
        QCOMPARE(lastStep(), QString("Hide Vorderteil"));
        QVERIFY(!fixture_.patternView().hitAt(place));
        QVERIFY(!fixture_.garmentView().hitAt(inGarment(0)));
        QVERIFY(document().selection().empty());
        fixture_.action(ActionId::ShowAllPieces).trigger();
        QVERIFY(fixture_.patternView().hitAt(place));
    }

    void theKeyForItRenamesTheSelectedPiece() {
        document().setSelection({1});
        QTest::keyClick(&fixture_.patternView(), Qt::Key_F2);
        typeName("front");
        QCOMPARE(pieceName(document(), 1), QString("front 2"));
        fixture_.action(ActionId::Undo).trigger();
        QCOMPARE(pieceName(document(), 1), QString("back"));
    }

    void aDragWithTheRightButtonShowsNoMenu() {
        for (QWidget* view :
             std::initializer_list<QWidget*>{&fixture_.garmentView(), &fixture_.patternView()}) {
            const QPointF middle = view->rect().center();
            test::drag(*view, middle, middle + QPointF(60, 20), Qt::RightButton);
            QVERIFY(!shown());
        }
        QVERIFY(document().selection().empty());
    }

    void aSelectionThatIsPointedAtStays() {
        document().setSelection({0, 1});
        rightClick(fixture_.patternView(), inPattern(1));
        QVERIFY(shown());
        QCOMPARE(document().selection(), (Document::Selection{0, 1}));
        choose(ActionId::ShowOnlyThese);
        QVERIFY(isHidden(document(), 2) && !isHidden(document(), 0));
    }

    void theMenuKeyIsAboutTheSelection() {
        const auto press = [this](int key, Qt::KeyboardModifiers modifiers) {
            QTest::keyClick(&fixture_.patternView(), static_cast<Qt::Key>(key), modifiers);
        };
        press(Qt::Key_F10, Qt::ShiftModifier);
        QVERIFY(shown());
        QCOMPARE(shown()->objectName(), QString("groundContext"));
        shown()->close();
        document().setSelection({2});
        press(Qt::Key_F10, Qt::ShiftModifier);
        QVERIFY(shown());
        QCOMPARE(shown()->objectName(), QString("pieceContext"));
        shown()->close();
    }

    void smallPiecesAreLeftOutAtOnce() {
        fixture_.action(ActionId::LeaveOutSmall).trigger();
        auto& area = fixture_.find<QDoubleSpinBox>("leaveOutArea");
        area.setValue(0.5);
        QVERIFY(!fixture_.find<QPushButton>("leaveOutNow").isEnabled());
        area.setValue(2);
        QVERIFY(fixture_.find<QLabel>("leaveOutCount").text().contains("button"));
        QTest::mouseClick(&fixture_.find<QPushButton>("leaveOutNow"), Qt::LeftButton);
        QVERIFY(isLeftOut(document(), 2) && !isLeftOut(document(), 1));
        QTRY_VERIFY_WITH_TIMEOUT(document().patternPiece(1) && !document().patternPiece(2),
                                 test::kPatience);
        QCOMPARE(cell(2, PiecesModel::Status).data().toString(), QString("Left out"));
        document().setSelection({2});
        fixture_.action(ActionId::TakeIn).trigger();
        QTRY_VERIFY_WITH_TIMEOUT(document().patternPiece(2), test::kPatience);
    }

    void whatIsLeftOutGoesAtOnceWhereNothingIsFlattenedByItself() {
        fixture_.workspace().setAutoFlatten(false);
        auto& bar = fixture_.find<QWidget>("outdatedBar");
        const PieceResult* front = document().result(0);
        document().setSelection({2});
        fixture_.action(ActionId::LeaveOut).trigger();
        QTRY_VERIFY_WITH_TIMEOUT(document().result(2) && isLeftOut(*document().result(2)),
                                 test::kPatience);
        QVERIFY(!document().patternPiece(2) && document().patternPiece(1));
        QCOMPARE(document().result(0), front);
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(!bar.isVisible() && fixture_.workspace().canExport());
        QCOMPARE(fixture_.workspace().patternAge(), PatternAge::UpToDate);
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(document().patternPiece(2));
        fixture_.action(ActionId::Redo).trigger();
        QVERIFY(!document().patternPiece(2));

        // Also beside what waits to be flattened.
        fixture_.workspace().setMethod(Method::Natural);
        QVERIFY(bar.isVisible());
        QVERIFY(!fixture_.find<QWidget>("flattenButton").styleSheet().isEmpty());
        document().setSelection({1});
        fixture_.action(ActionId::LeaveOut).trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!document().patternPiece(1), test::kPatience);
        QCOMPARE(document().result(0), front);
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(bar.isVisible());
        QVERIFY(!svgOf().contains("back"));
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(document().patternPiece(1) && fixture_.workspace().canExport());
        fixture_.action(ActionId::Redo).trigger();
        QVERIFY(!document().patternPiece(1));

        // What is taken in is not flat until it is flattened, and no file goes without it; until
        // that is known, one is written as the pattern is shown.
        document().cache().clear();
        fixture_.action(ActionId::TakeIn).trigger();
        QVERIFY(fixture_.workspace().canExport() && !svgOf().contains("back"));
        QTRY_VERIFY_WITH_TIMEOUT(!fixture_.workspace().canExport(), test::kPatience);
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(bar.isVisible() && !fixture_.action(ActionId::ExportPattern).isEnabled());
        QTest::mouseClick(bar.findChild<QPushButton*>("flattenNow"), Qt::LeftButton);
        QVERIFY(fixture_.waitForResults());
        QVERIFY(document().patternPiece(1) && !document().patternPiece(2));
        QVERIFY(!bar.isVisible());
        QVERIFY(fixture_.find<QWidget>("flattenButton").styleSheet().isEmpty());
    }

    void onlyTheFrontIsExported() {
        rightClick(fixture_.patternView(), inPattern(0));
        choose(ActionId::ExportOnlyThese);
        auto* dialog = fixture_.window().findChild<ExportDialog*>();
        QVERIFY(dialog);
        QCOMPARE(dialog->findChild<QComboBox*>("exportPieces")->currentText(),
                 QString("Selected pieces (1)"));
        const QString path = fixture_.path("only.svg");
        auto* field = dialog->findChild<QLineEdit*>("exportPath");
        field->setText(path);
        QTest::mouseClick(dialog->findChild<QPushButton*>("exportNow"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), test::kPatience);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray svg = file.readAll();
        QVERIFY(svg.contains("front") && !svg.contains("back"));
    }
};

TOILE_WINDOW_TEST(PieceActionsTest)
#include "piece_actions_test.moc"
