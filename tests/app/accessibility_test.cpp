// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QSlider>
#include <QToolBar>
#include <set>

#include "app/document/document.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

/// The window for somebody who hears it, or has no mouse.
class AccessibilityTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    static bool isControl(const QWidget& widget) {
        return qobject_cast<const QAbstractButton*>(&widget) ||
               qobject_cast<const QAbstractSpinBox*>(&widget) ||
               qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QLineEdit*>(&widget) ||
               qobject_cast<const QSlider*>(&widget) ||
               qobject_cast<const QAbstractItemView*>(&widget);
    }
    /// Qt's own parts of a control: its arrows, its line, its menus.
    static bool isPart(const QWidget& widget) {
        const QWidget* parent = widget.parentWidget();
        return widget.objectName().startsWith("qt_") || qobject_cast<const QComboBox*>(parent) ||
               qobject_cast<const QAbstractSpinBox*>(parent) ||
               qobject_cast<const QLineEdit*>(parent) || widget.inherits("QHeaderView") ||
               parent->inherits("QComboBoxPrivateContainer") ||
               qobject_cast<const QDockWidget*>(parent);
    }
    static QString nameOf(QWidget& widget) {
        QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(&widget);
        return interface ? interface->text(QAccessible::Name) : QString();
    }

private slots:
    void initTestCase() { SKIP_WITHOUT_GL(); }

    void init() {
        fixture_.open();
        QVERIFY(fixture_.openAndWait(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj"));
        fixture_.document().setSelection({0});
    }
    void cleanup() { fixture_.close(); }

    void everyControlHasAName() {
        QStringList nameless;
        for (QWidget* widget : fixture_.window().findChildren<QWidget*>()) {
            if (isControl(*widget) && !isPart(*widget) && nameOf(*widget).isEmpty()) {
                nameless << QString("%1 (%2)").arg(
                    widget->parentWidget()->objectName() + "." + widget->objectName(),
                    widget->metaObject()->className());
            }
        }
        nameless.removeDuplicates();
        QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(", ")));
    }

    void viewsHaveNames() {
        for (QWidget* view : {static_cast<QWidget*>(&fixture_.garmentView()),
                              static_cast<QWidget*>(&fixture_.patternView())}) {
            QVERIFY(!nameOf(*view).isEmpty());
        }
    }

    /// Tab goes round through all that can be typed into, and back to where it began.
    void tabComesToEveryFieldThatIsSeen() {
        std::set<QWidget*> reached;
        fixture_.patternView().setFocus();
        QWidget* const first = QApplication::focusWidget();
        QVERIFY(first);
        constexpr int kMany = 400;
        for (int k = 0; k < kMany; ++k) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            if (QApplication::focusWidget() == first) {
                break;
            }
            reached.insert(QApplication::focusWidget());
        }
        QCOMPARE(QApplication::focusWidget(), first);
        QStringList missed;
        for (QWidget* widget : fixture_.window().findChildren<QWidget*>()) {
            const bool isField =
                qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QComboBox*>(widget);
            if (isField && widget->isVisible() && widget->isEnabled() && !isPart(*widget) &&
                reached.count(widget) == 0) {
                missed << widget->objectName();
            }
        }
        QVERIFY2(missed.isEmpty(), qPrintable(missed.join(", ")));
    }
};

TOILE_WINDOW_TEST(AccessibilityTest)
#include "accessibility_test.moc"
