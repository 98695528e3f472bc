// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>

#include "app/document/document.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

/// Fields beside the views take the keyboard for one number, and no longer.
class FieldKeysTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    QDoubleSpinBox& left() { return fixture_.find<QDoubleSpinBox>("positionX"); }

    /// To whatever has the keyboard, as a person types.
    static void type(const QString& keys) { QTest::keyClicks(QApplication::focusWidget(), keys); }
    static void press(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }

    bool isAtWork() const {
        return qobject_cast<SceneView*>(QApplication::focusWidget()) != nullptr;
    }
    void goToPlace() {
        press(Qt::Key_P);
        QTRY_VERIFY_WITH_TIMEOUT(left().hasFocus(), test::kPatience);
    }

private slots:
    void initTestCase() { SKIP_WITHOUT_GL(); }

    void init() {
        fixture_.open();
        QVERIFY(fixture_.openAndWait(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj"));
        document().setSelection({0});
        fixture_.patternView().setFocus();
        QTRY_VERIFY_WITH_TIMEOUT(isAtWork(), test::kPatience);
    }
    void cleanup() { fixture_.close(); }

    void enterTakesWhatWasTypedAndGivesTheKeyboardBack() {
        goToPlace();
        left().selectAll();
        type("50");
        press(Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(isAtWork(), test::kPatience);
        QCOMPARE(left().value(), 50.0);
        type("5");
        QCOMPARE(document().view().overlay, Overlay::Strain);
        QCOMPARE(left().value(), 50.0);
    }

    void escapeTakesBackWhatWasTypedAndGivesTheKeyboardBack() {
        goToPlace();
        const double before = left().value();
        const QString shown = left().text();
        const int steps = document().history().count();
        left().selectAll();
        type("77");
        press(Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(isAtWork(), test::kPatience);
        QCOMPARE(left().value(), before);
        QCOMPARE(left().text(), shown);
        QCOMPARE(document().history().count(), steps);
        type("t5");
        QCOMPARE(left().text(), shown);
        QCOMPARE(document().view().overlay, Overlay::Strain);
    }

    void tabGoesOnToTheNextField() {
        goToPlace();
        press(Qt::Key_Tab);
        QVERIFY(qobject_cast<QDoubleSpinBox*>(QApplication::focusWidget()));
        QVERIFY(!left().hasFocus());
    }

    void listsKeepTheKeyboard() {
        fixture_.action(ActionId::GoToPieces).trigger();
        QWidget* list = QApplication::focusWidget();
        QVERIFY(list && !isAtWork());
        press(Qt::Key_Escape);
        QCOMPARE(QApplication::focusWidget(), list);
    }
};

TOILE_WINDOW_TEST(FieldKeysTest)
#include "field_keys_test.moc"
