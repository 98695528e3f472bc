// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of the selected pieces in the panel beside the views.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

#include "app/document/document.h"
#include "app/document/piece_edits.h"
#include "core/project/piece_settings.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

class PiecePanelTest : public QObject {
    Q_OBJECT

    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    QLineEdit& name() { return fixture_.find<QLineEdit>("pieceName"); }
    QSpinBox& quantity() { return fixture_.find<QSpinBox>("pieceQuantity"); }
    QCheckBox& pair() { return fixture_.find<QCheckBox>("piecePair"); }
    QString size() { return fixture_.find<QLabel>("pieceSize").text(); }
    QString lastStep() { return document().history().undoText(); }
    const PieceSettings& said(std::size_t piece) { return document().settings()[piece]; }

    static void type(QWidget& field, const QString& text) {
        field.setFocus();
        QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
        if (text.isEmpty()) {
            QTest::keyClick(&field, Qt::Key_Delete);
        }
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        test::writeObj(fixture_.path("three.obj").toStdString(),
                       {{"front", test::makeSheet(120, 80, 6, 4)},
                        {"back", test::makeSheet(120, 80, 6, 4, {200, 0, 0})},
                        {"button", test::makeSheet(10, 10, 2, 2, {400, 0, 0})}});
    }

    void init() {
        fixture_.open();
        QVERIFY(fixture_.openAndWait(fixture_.path("three.obj")));
    }

    void cleanup() { fixture_.close(); }

    void aNameIsTypedAndTakenBack() {
        document().setSelection({0});
        QCOMPARE(name().text(), QString("front"));
        type(name(), "Vorderteil");
        QCOMPARE(pieceName(document(), 0), QString("Vorderteil"));
        QCOMPARE(lastStep(), QString("Rename front"));
        type(name(), "");
        QCOMPARE(pieceName(document(), 0), QString("front"));
        QCOMPARE(name().text(), QString("front"));
        const int steps = document().history().count();
        type(name(), "front");  // as it is: no step
        QCOMPARE(document().history().count(), steps);
    }

    void whatIsTypedIsForThePieceItWasTypedFor() {
        document().setSelection({0});
        name().setFocus();
        name().selectAll();
        QTest::keyClicks(&name(), "cape");
        document().setSelection({1});
        QCOMPARE(name().text(), QString("back"));
        QTest::keyClick(&name(), Qt::Key_Return);
        QCOMPARE(pieceName(document(), 1), QString("back"));
    }

    void whatIsTypedStaysWhenFlatteningEnds() {
        document().setSelection({0});
        for (const char* name : {"positionX", "positionY", "positionAngle"}) {
            auto& field = fixture_.find<QDoubleSpinBox>(name);
            field.setFocus();
            field.selectAll();
            QTest::keyClicks(&field, "17");
            fixture_.workspace().setMethod(document().state().options.method == Method::Natural
                                               ? Method::Curvature
                                               : Method::Natural);
            QVERIFY(fixture_.waitForResults());
            QCOMPARE(field.text(), QString("17"));
            QTest::keyClick(&field, Qt::Key_Return);
            QCOMPARE(field.value(), 17.0);
        }
        QCOMPARE(lastStep(), QString("Turn front"));
    }

    void howManyAreCutIsTyped() {
        document().setSelection({0, 1});
        QCOMPARE(quantity().text(), QString("1"));
        type(quantity(), "3");
        QCOMPARE(said(0).quantity, 3);
        QCOMPARE(said(1).quantity, 3);
        QCOMPARE(said(2).quantity, 1);
        QCOMPARE(lastStep(), QString("Set quantity of 2 pieces to 3"));
        pair().click();
        QVERIFY(said(0).mirroredPair && said(1).mirroredPair && !said(2).mirroredPair);
    }

    void escapeForgetsWhatWasTyped() {
        document().setSelection({0});
        for (QWidget* field : std::initializer_list<QWidget*>{&name(), &quantity()}) {
            field->setFocus();
            QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
            QTest::keyClicks(field, "7");
            QTest::keyClick(field, Qt::Key_Escape);
            QVERIFY(!field->hasFocus());
        }
        QCOMPARE(name().text(), QString("front"));
        QCOMPARE(quantity().text(), QString("1"));
        QVERIFY(!document().history().canUndo());
    }

    void valuesThatDifferAreSaidToAndStay() {
        setQuantity(document(), {0}, 4);
        setMirroredPair(document(), {0}, true);
        setMaterial(document(), {0}, "Lining");
        document().setSelection({0, 2});
        const int steps = document().history().count();
        QCOMPARE(name().placeholderText(), QString("2 pieces"));
        QVERIFY(name().text().isEmpty() && !name().isEnabled());
        QCOMPARE(quantity().text(), QString("various"));
        QCOMPARE(pair().checkState(), Qt::PartiallyChecked);
        QCOMPARE(size(), QString("various"));
        for (QWidget* field : std::initializer_list<QWidget*>{&name(), &quantity(), &pair()}) {
            field->setFocus();  // and left again
        }
        QCOMPARE(document().history().count(), steps);
        document().setSelection({0, 1});
        QCOMPARE(size(), QString::fromUtf8("120.0 × 80.0 mm"));  // both alike
    }

    void theSizeGoesByTheGrainHoweverThePieceLies() {
        document().setSelection({0});
        const QString before = size();
        type(fixture_.find<QDoubleSpinBox>("positionAngle"), "30");
        QCOMPARE(size(), before);
        type(fixture_.find<QDoubleSpinBox>("positionGrain"), "120");  // as it was on the piece
        QCOMPARE(size(), before);
        type(fixture_.find<QDoubleSpinBox>("positionGrain"), "30");
        QVERIFY(size() != before);
    }

    void nothingIsCutOffWhateverIsSelected() {
        const QWidget& field = fixture_.find<QWidget>("positionX");
        const QWidget& panel = *field.parentWidget()->parentWidget();
        for (const Document::Selection& pieces :
             {Document::Selection{}, Document::Selection{0}, Document::Selection{0, 2}}) {
            document().setSelection(pieces);
            QCoreApplication::processEvents();
            QVERIFY(panel.width() <= panel.parentWidget()->width());
        }
    }

    void withoutASelectionNothingMovesAndNothingCanBeTyped() {
        document().setSelection({0});
        const QPoint place = quantity().pos();
        const QSize extent = quantity().size();
        document().setSelection({});
        QCoreApplication::processEvents();
        QVERIFY(!quantity().isVisible());
        for (const char* field : {"pieceName", "pieceQuantity", "piecePair", "pieceMaterial",
                                  "positionGrain", "positionX", "positionAngle"}) {
            QVERIFY2(!fixture_.find<QWidget>(field).isEnabled(), field);
        }
        QCOMPARE(quantity().text().trimmed(), QString());
        document().setSelection({0});
        QCoreApplication::processEvents();
        QCOMPARE(quantity().pos(), place);
        QCOMPARE(quantity().size(), extent);
    }
};

TOILE_WINDOW_TEST(PiecePanelTest)
#include "piece_panel_test.moc"
