// SPDX-License-Identifier: GPL-3.0-or-later
// Quantity, mirrored pair and method in the list of pieces: real key and mouse events, what they
// leave in the document and in the files.
#include <QAction>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QSpinBox>
#include <QStyle>
#include <QStyleOptionViewItem>
#include <QTreeView>

#include "app/document/piece_edits.h"
#include "app/panels/pieces_model.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

class PiecesColumnsTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    const PieceSettings& settings(std::size_t piece) { return document().settings()[piece]; }
    int steps() { return document().history().index(); }
    QString lastStep() { return document().history().undoText(); }
    QTreeView& table() { return fixture_.find<QTreeView>("pieceTable"); }
    QModelIndex cell(int row, int column) { return table().model()->index(row, column); }
    void undo() { fixture_.action(ActionId::Undo).trigger(); }

    void click(const QModelIndex& index, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(table().viewport(), Qt::LeftButton, modifiers,
                          table().visualRect(index).center());
    }
    void doubleClick(const QModelIndex& index) {
        click(index);
        QTest::mouseDClick(table().viewport(), Qt::LeftButton, {},
                           table().visualRect(index).center());
    }
    void clickBox(const QModelIndex& index) {
        QStyleOptionViewItem option;
        option.initFrom(&table());
        option.rect = table().visualRect(index);
        option.features |= QStyleOptionViewItem::HasCheckIndicator;
        const QRect box = table().style()->subElementRect(QStyle::SE_ItemViewItemCheckIndicator,
                                                          &option, &table());
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, box.center());
    }
    void typeQuantity(const QString& text) {
        auto* editor = table().findChild<QSpinBox*>("quantityEditor");
        QVERIFY(editor != nullptr);
        editor->selectAll();
        QTest::keyClicks(editor, text);
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(table().findChild<QSpinBox*>("quantityEditor") == nullptr,
                                 test::kPatience);
    }

private slots:
    void initTestCase() {
        test::writeObj(fixture_.path("three.obj").toStdString(),
                       {{"front", test::makeSheet(120, 80, 6, 4)},
                        {"back", test::makeSheet(100, 80, 5, 4, {200, 0, 0})},
                        {"cuff", test::makeSheet(60, 20, 3, 2, {400, 0, 0})}});
    }

    void init() {
        fixture_.open();
        QVERIFY(fixture_.openAndWait(fixture_.path("three.obj")));
    }

    void cleanup() { fixture_.close(); }

    void quantityIsTyped() {
        doubleClick(cell(0, PiecesModel::Quantity));
        typeQuantity("2");
        QCOMPARE(settings(0).quantity, 2);
        QCOMPARE(settings(1).quantity, 1);
        QCOMPARE(steps(), 1);
        QCOMPARE(lastStep(), QString("Set quantity of front to 2"));
        QCOMPARE(cell(0, PiecesModel::Quantity).data().toString(), QString("2"));
        doubleClick(cell(0, PiecesModel::Quantity));
        typeQuantity("2");
        QCOMPARE(steps(), 1);  // as it was
        undo();
        QCOMPARE(settings(0).quantity, 1);
    }

    void quantityStaysWithinReason() {
        doubleClick(cell(1, PiecesModel::Quantity));
        typeQuantity("99999999");  // the last digits are not taken
        QCOMPARE(settings(1).quantity, 999999);
        setQuantity(document(), {1}, kMaxCopies + 1);
        QCOMPARE(settings(1).quantity, kMaxCopies);
        setQuantity(document(), {1}, 0);
        QCOMPARE(settings(1).quantity, 1);
        const int before = steps();
        setQuantity(document(), {-1, 7}, 3);
        setQuantity(document(), {}, 3);
        QCOMPARE(steps(), before);
    }

    /// What a project may hold (project_file.cpp) can be edited too: it falls to no smaller bound.
    void manyCopiesOfAProjectStayAsManyInTheEditor() {
        setQuantity(document(), {0}, 5000);
        QCOMPARE(settings(0).quantity, 5000);
        doubleClick(cell(0, PiecesModel::Quantity));
        typeQuantity("5001");
        QCOMPARE(settings(0).quantity, 5001);
    }

    void aQuantityThatIsOnlyLookedAtStaysForAll() {
        setQuantity(document(), {2}, 4);
        click(cell(0, PiecesModel::Name));
        click(cell(2, PiecesModel::Name), Qt::ControlModifier);
        const int before = steps();
        doubleClick(cell(0, PiecesModel::Quantity));
        typeQuantity("");
        QCOMPARE(settings(0).quantity, 1);
        QCOMPARE(settings(2).quantity, 4);
        QCOMPARE(steps(), before);
    }

    void anEditIsMeantForAllSelectedRows() {
        click(cell(0, PiecesModel::Name));
        click(cell(2, PiecesModel::Name), Qt::ControlModifier);
        QCOMPARE(document().selection(), (Document::Selection{0, 2}));
        doubleClick(cell(2, PiecesModel::Quantity));
        typeQuantity("6");
        QCOMPARE(document().selection(), (Document::Selection{0, 2}));
        QCOMPARE(settings(0).quantity, 6);
        QCOMPARE(settings(1).quantity, 1);
        QCOMPARE(settings(2).quantity, 6);
        QCOMPARE(lastStep(), QString("Set quantity of 2 pieces to 6"));
        clickBox(cell(0, PiecesModel::Pair));
        QVERIFY(settings(0).mirroredPair && !settings(1).mirroredPair && settings(2).mirroredPair);
        QCOMPARE(steps(), 2);
        undo();
        undo();
        QVERIFY(settings(2) == settings(1) || settings(2).quantity == 1);
        QVERIFY(!settings(0).mirroredPair);
    }

    void aRowThatIsNotSelectedIsMeantAlone() {
        click(cell(0, PiecesModel::Name));
        clickBox(cell(1, PiecesModel::Pair));
        QVERIFY(!settings(0).mirroredPair && settings(1).mirroredPair);
        QCOMPARE(lastStep(), QString("Set mirrored pair for back"));
        clickBox(cell(1, PiecesModel::Pair));
        QCOMPARE(lastStep(), QString("Clear mirrored pair for back"));
        QCOMPARE(steps(), 2);
    }

    void spaceTurnsThePairOnAndOff() {
        click(cell(2, PiecesModel::Area));
        QTest::keyClick(&table(), Qt::Key_Space);
        QVERIFY(settings(2).mirroredPair);
        QTest::keyClick(&table(), Qt::Key_Space);
        QVERIFY(!settings(2).mirroredPair);
        QCOMPARE(steps(), 2);
    }

    void columnsAreSortedByNumber() {
        setQuantity(document(), {0}, 10);
        setQuantity(document(), {1}, 9);
        table().sortByColumn(PiecesModel::Quantity, Qt::AscendingOrder);
        QCOMPARE(cell(0, PiecesModel::Name).data().toString(), QString("cuff"));
        QCOMPARE(cell(2, PiecesModel::Name).data().toString(), QString("front"));
        setMirroredPair(document(), {1}, true);
        table().sortByColumn(PiecesModel::Pair, Qt::DescendingOrder);
        QCOMPARE(cell(0, PiecesModel::Name).data().toString(), QString("back"));
    }

    void theMethodIsGreyWhileItIsNotTheOneAskedFor() {
        const QModelIndex method = cell(0, PiecesModel::Method);
        QCOMPARE(method.data().toString(), QString("Least distortion"));
        QVERIFY(!method.data(Qt::ForegroundRole).isValid());
        fixture_.workspace().setAutoFlatten(false);
        fixture_.action(ActionId::MethodCurvature).trigger();
        QCOMPARE(method.data().toString(), QString("Least distortion"));
        QVERIFY(method.data(Qt::ForegroundRole).isValid());
        QVERIFY(method.data(Qt::ToolTipRole).toString().contains("out of date"));
        fixture_.action(ActionId::FlattenAgain).trigger();
        QTRY_COMPARE_WITH_TIMEOUT(cell(0, PiecesModel::Method).data().toString(),
                                  QString("Angles from curvature"), test::kPatience);
        QVERIFY(!cell(0, PiecesModel::Method).data(Qt::ForegroundRole).isValid());
    }

    void headingsAreNotCutOff() {
        for (const QSize size : {QSize(1280, 800), QSize(1600, 1000)}) {
            fixture_.window().resize(size);
            QTRY_COMPARE_WITH_TIMEOUT(fixture_.window().size(), size, test::kPatience);
            const QHeaderView& header = *table().header();
            QTRY_VERIFY_WITH_TIMEOUT(header.length() <= table().viewport()->width(),
                                     test::kPatience);
            for (int column = 0; column < PiecesModel::ColumnCount; ++column) {
                if (!table().isColumnHidden(column)) {
                    QTRY_VERIFY2_WITH_TIMEOUT(
                        header.sectionSize(column) >=
                            header.fontMetrics().horizontalAdvance(
                                table().model()->headerData(column, Qt::Horizontal).toString()),
                        qPrintable(table().model()->headerData(column, Qt::Horizontal).toString()),
                        test::kPatience);
                }
            }
        }
    }

    void whatIsAsItShouldBeTakesNoColumn() {
        const auto isHidden = [this](int column) { return table().isColumnHidden(column); };
        for (const int column : {PiecesModel::Method, PiecesModel::Flips, PiecesModel::Crossings}) {
            QVERIFY(isHidden(column));
        }
        QVERIFY(table().header()->sectionSize(PiecesModel::Status) < 200);
        // Results with a flip, and of another method.
        PieceResults results = document().results();
        auto other = std::make_shared<PieceResult>(*results[0]);
        other->quality->flippedTriangles = 1;
        other->options.method = Method::Curvature;
        results[0] = other;
        test::setResults(document(), results, document().scene());
        QVERIFY(!isHidden(PiecesModel::Flips) && !isHidden(PiecesModel::Method));
        QVERIFY(isHidden(PiecesModel::Crossings));
        // What a person chooses stays, whatever comes.
        emit table().header()->customContextMenuRequested({10, 5});
        auto* menu = table().findChild<QMenu*>("columnMenu");
        QVERIFY(menu && menu->findChild<QAction*>("flips")->isChecked());
        menu->findChild<QAction*>("flips")->trigger();
        menu->close();
        test::setResults(document(), results, document().scene());
        QVERIFY(isHidden(PiecesModel::Flips) && !isHidden(PiecesModel::Method));
    }

    void headsTooLongLoseTheirEndAndTheTipHasThem() {
        QCOMPARE(table().header()->textElideMode(), Qt::ElideRight);
        const QAbstractItemModel& model = *table().model();
        for (int column = 0; column < PiecesModel::ColumnCount; ++column) {
            const QString title = model.headerData(column, Qt::Horizontal).toString();
            QVERIFY(model.headerData(column, Qt::Horizontal, Qt::ToolTipRole)
                        .toString()
                        .startsWith(title));
        }
    }

    void theClothNeededCountsEveryCopy() {
        document().setSelection({});
        const QString once = fixture_.find<QLabel>("pieceDetails").text();
        setQuantity(document(), {0}, 3);
        setMirroredPair(document(), {0}, true);
        const QString all = fixture_.find<QLabel>("pieceDetails").text();
        QVERIFY(all != once);
        QVERIFY(all.contains("Pieces to cut") && all.contains(">8<"));
        QVERIFY(!once.contains("Pieces to cut"));
        QCOMPARE(copiesOf(document(), 0), 6);
    }

    void filesSayHowManyAreCut() {
        setQuantity(document(), {0}, 3);
        setMirroredPair(document(), {2}, true);
        for (const char* name : {"out.svg", "out.dxf", "out.json"}) {
            const QString path = fixture_.path(name);
            fixture_.workspace().exportTo(path.toStdString());
            QTRY_VERIFY_WITH_TIMEOUT(!fixture_.workspace().writing().isBusy(), test::kPatience);
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QByteArray bytes = file.readAll();
            const bool isReport = path.endsWith("json");
            QVERIFY2(bytes.contains(isReport ? "\"quantity\": 3" : "cut 3"), name);
            QVERIFY2(bytes.contains(isReport ? "\"mirrored_pair\": true" : "cut 1 pair"), name);
        }
    }
};

TOILE_WINDOW_TEST(PiecesColumnsTest)
#include "pieces_columns_test.moc"
