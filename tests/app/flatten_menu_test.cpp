// SPDX-License-Identifier: GPL-3.0-or-later
// Methods and their quality in the menu, with the mouse.
#include <QLabel>
#include <QMenu>
#include <QMenuBar>

#include "app/text/figures.h"
#include "tests/app/support/pair_bench.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

class FlattenMenuTest : public test::PairBench {
    Q_OBJECT

    /// Opens the menu with the mouse, as a person does.
    QMenu& openMenu(const char* name) {
        auto& menu = fixture_.find<QMenu>(name);
        QMenuBar* bar = window().menuBar();
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->actionGeometry(menu.menuAction()).center());
        return menu;
    }

private slots:
    void anotherMethodFlattensAgain() {
        QVERIFY(openPair());
        QVERIFY(document().results()[1]->quality->maxBoundaryLengthError < 1e-9);
        action(ActionId::MethodNatural).trigger();
        QTRY_COMPARE_WITH_TIMEOUT(document().results()[1]->options.method, Method::Natural,
                                  test::kPatience);
        QVERIFY(document().results()[1]->quality->maxBoundaryLengthError > 1e-4);
        QVERIFY(!action(ActionId::SolverSlcp).isEnabled());
    }

    void everyMethodStandsInTheFlattenMenu() {
        QMenu& menu = openMenu("flattenMenu");
        QTRY_VERIFY_WITH_TIMEOUT(menu.isVisible(), test::kPatience);
        bool keepsLengths = true;
        QString section;
        std::size_t found = 0;
        for (const QAction* action : menu.actions()) {
            if (action->isSeparator()) {
                section = action->text();
                continue;
            }
            for (const MethodTraits& method : allMethods()) {
                if (action != &window().actions()[actionOf(method.method)]) {
                    continue;
                }
                ++found;
                QVERIFY2(keepsLengths || !method.keepsLengths, "free outlines come last");
                keepsLengths = method.keepsLengths;
                QCOMPARE(section, keepsLengths ? QString("Seam lines keep their length")
                                               : QString("Seam lines may change length"));
                QCOMPARE(action->text().remove('&'), methodName(method.method));
                QVERIFY(!action->statusTip().isEmpty());
                QCOMPARE(action->isChecked(), document().options().method == method.method);
            }
        }
        QCOMPARE(found, allMethods().size());
        QString letters;
        for (const QAction* action : menu.actions()) {
            const qsizetype mark = action->text().indexOf('&');
            if (mark >= 0) {
                const QChar letter = action->text().at(mark + 1).toLower();
                QVERIFY2(!letters.contains(letter), qPrintable(action->text()));
                letters += letter;
            }
        }
        menu.close();
    }

    /// What is in use stays, and menus that are empty go.
    void plainMenusLeaveOutWhatIsForSpecialists() {
        QVERIFY(openPair());
        QMenu& menu = openMenu("flattenMenu");
        QTRY_VERIFY_WITH_TIMEOUT(menu.isVisible(), test::kPatience);
        menu.close();
        const auto shown = [&menu] {
            QList<const QAction*> found;
            for (const QAction* entry : menu.actions()) {
                if (entry->isVisible() && !entry->isSeparator()) {
                    found << entry;
                }
            }
            return found;
        };
        const auto all = shown().size();
        action(ActionId::MethodLscm).trigger();
        fixture_.preferences().setChoices({.menus = Menus::Plain});
        QVERIFY(action(ActionId::MethodIsometric).isVisible());
        QVERIFY(action(ActionId::MethodLscm).isVisible());
        QVERIFY(!action(ActionId::MethodStretch).isVisible());
        QVERIFY(!action(ActionId::CompareMethods).isVisible());
        QCOMPARE(shown().size(), 7);  // three methods, quality, automatic, again, cancel
        action(ActionId::MethodIsometric).trigger();
        QTRY_VERIFY(!action(ActionId::MethodLscm).isVisible());
        fixture_.preferences().setChoices({});
        QCOMPARE(shown().size(), all);
        QVERIFY(action(ActionId::CompareMethods).isEnabled());
    }

    void choosingAMethodInTheMenuFlattensAgain() {
        QVERIFY(openPair());
        QMenu& menu = openMenu("flattenMenu");
        QTRY_VERIFY_WITH_TIMEOUT(menu.isVisible(), test::kPatience);
        QAction& curvature = action(ActionId::MethodCurvature);
        QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(&curvature).center());
        QVERIFY(curvature.isChecked());
        QTRY_COMPARE_WITH_TIMEOUT(document().results()[1]->options.method, Method::Curvature,
                                  test::kPatience);
        QVERIFY(document().results()[1]->quality->maxBoundaryLengthError < 1e-9);
        document().setSelection({1});
        const QString details = fixture_.find<QLabel>("pieceDetails").text();
        QVERIFY2(details.contains(methodName(Method::Curvature)), qPrintable(details));
    }

    void qualityIsForTheIsometricMethodOnly() {
        QVERIFY(openPair());
        ActionRegistry& actions = window().actions();
        auto& quality = fixture_.find<QMenu>("qualityMenu");
        for (const Method method : {Method::Natural, Method::Isometric, Method::Wang2005}) {
            actions[actionOf(method)].trigger();
            const bool isometric = method == Method::Isometric;
            QCOMPARE(actions[ActionId::QualityFine].isEnabled(), isometric);
            QCOMPARE(quality.menuAction()->isEnabled(), isometric);
        }
        QVERIFY(actions[ActionId::QualityStandard].isChecked());
        actions[ActionId::MethodIsometric].trigger();
        QMenu& menu = openMenu("flattenMenu");
        QTRY_VERIFY_WITH_TIMEOUT(menu.isVisible(), test::kPatience);
        QTest::keyClick(&menu, Qt::Key_Q);
        QTRY_VERIFY_WITH_TIMEOUT(quality.isVisible(), test::kPatience);
        QTest::mouseClick(&quality, Qt::LeftButton, {},
                          quality.actionGeometry(&actions[ActionId::QualityDraft]).center());
        QCOMPARE(document().options().quality, Quality::Draft);
        QVERIFY(!actions[ActionId::QualityStandard].isChecked());
        QTRY_COMPARE_WITH_TIMEOUT(document().results()[1]->options.quality, Quality::Draft,
                                  test::kPatience);
        QCOMPARE(document().results()[1]->options.method, Method::Isometric);
    }
};

TOILE_WINDOW_TEST(FlattenMenuTest)
#include "flatten_menu_test.moc"
