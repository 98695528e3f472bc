// SPDX-License-Identifier: GPL-3.0-or-later
// What stands on the rulers and between the lines of the grid.
#include "app/views/ruler.h"

#include "app/render/pattern_renderer.h"
#include "app/settings/length_display.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/sheet_bench.h"

using namespace toile;
using namespace toile::app;

class RulerTest : public test::SheetBench {
    Q_OBJECT

private slots:
    void rulersAndGridCanBeSwitchedOff() {
        const QImage with = fixture_.patternPicture();
        action(ActionId::Rulers).trigger();
        QVERIFY(!document().view().rulers);
        const QImage without = fixture_.patternPicture();
        QVERIFY(with != without);
        action(ActionId::Grid).trigger();
        QVERIFY(fixture_.patternPicture() != without);
    }

    void rulersReadAtEveryScale() {
        for (const LengthUnit display :
             {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Inch}) {
            rulersReadAtEveryScaleIn(display);
        }
        QCOMPARE(rulerText(50, rulerUnit({100, 10}, LengthUnit::Millimetre)), QString("50"));
        QCOMPARE(rulerText(50, rulerUnit({100, 10}, LengthUnit::Centimetre)), QString("5"));
        QCOMPARE(rulerText(-5, rulerUnit({5, 5}, LengthUnit::Centimetre)), QString("−0.5"));
        QCOMPARE(rulerUnit({2000, 10}, LengthUnit::Centimetre).symbol, QString("m"));
        const RulerUnit inches = rulerUnit({25.4, 8}, LengthUnit::Inch);
        QCOMPARE(inches.symbol, QString("in"));
        QCOMPARE(rulerText(25.4 * 1.375, inches), QString("1 3/8"));
        QCOMPARE(rulerText(-254, inches), QString("−10"));
        // As on a tape: whole inches in eighths, then halves, quarters and eighths of their own.
        QCOMPARE(rulerSteps(60 / 25.4, LengthUnit::Inch).major, 25.4);
        QCOMPARE(rulerSteps(60 / 25.4, LengthUnit::Inch).parts, 8);
        QCOMPARE(rulerSteps(500 / 25.4, LengthUnit::Inch).major, 25.4 / 8);
    }

    void theGridCountsInInches() {
        const QImage before = fixture_.patternPicture();
        LengthDisplay::instance().choose(LengthUnit::Inch, 8);
        QVERIFY(fixture_.patternPicture() != before);
        LengthDisplay::instance().choose(LengthUnit::Millimetre);
        QCOMPARE(gridSteps(100 / 25.4, LengthUnit::Inch).major, 25.4);
        QCOMPARE(gridSteps(100 / 25.4, LengthUnit::Inch).parts, 8);
        QCOMPARE(gridSteps(10 / 25.4, LengthUnit::Inch).minor(), 25.4);
    }

private:
    static void rulersReadAtEveryScaleIn(LengthUnit display) {
        for (double scale = 1e-3; scale < 1e3; scale *= 1.3) {
            const RulerSteps steps = rulerSteps(scale, display);
            QVERIFY(steps.major * scale >= 55.9);
            QVERIFY(steps.major * scale <= 56 * 2.6);
            QVERIFY(steps.major / steps.parts * scale >= 4.9);
            const GridSteps grid = gridSteps(scale, display);
            QVERIFY(grid.major * scale >= 33.9 && grid.major * scale <= 341);
            QVERIFY(grid.minorStrength <= 0.5);
            QVERIFY(grid.minorStrength == 0 || grid.minor() * scale >= 6);
            const RulerUnit unit = rulerUnit(steps, display);
            QVERIFY(rulerText(steps.major, unit) != rulerText(2 * steps.major, unit));
            QVERIFY(rulerText(12 * steps.major, unit).size() <= 8);
        }
    }
};

TOILE_WINDOW_TEST(RulerTest)
#include "ruler_test.moc"
