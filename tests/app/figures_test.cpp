// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/figures.h"

#include <QLocale>
#include <QTest>

#include "app/settings/length_display.h"
#include "app/views/view_text.h"
#include "core/base/units.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

class FiguresTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void anglesAreInDegreesWithATrueMinus() {
        QCOMPARE(angleWithUnit(0.25 * kDegree * 50), QString::fromUtf8("12.5°"));
        QCOMPARE(angleWithUnit(-3 * kDegree), QString::fromUtf8("−3.0°"));
        QCOMPARE(angleWithUnit(-0.001 * kDegree), QString::fromUtf8("0.0°"));
    }

    void lengthsAndAreasHaveOneDecimal() {
        QCOMPARE(lengthNumber(1234.56), QString("1234.6"));
        QCOMPARE(areaNumber(123456), QString("1234.6"));
    }

    void longLengthsAreSaidAsAPersonSaysThem() {
        QCOMPARE(saidLength(5), QString("5.0 mm"));
        QCOMPARE(saidLength(148), QString("14.8 cm"));
        QCOMPARE(saidLength(1072), QString("1.07 m"));
        LengthDisplay::instance().choose(LengthUnit::Inch);
        QCOMPARE(saidLength(1225.8), QString("48.3 in"));
        QCOMPARE(saidLength(2057.4), QString("2.25 yd"));
        LengthDisplay::instance().choose(LengthUnit::Inch, 8);
        QCOMPARE(saidLength(1225.55), QString("48 1/4 in"));
        LengthDisplay::instance().choose(LengthUnit::Millimetre);
    }

    void theCheckerboardGoesWithTheUnit() {
        QCOMPARE(checkerSquare(), 10.0);
        QVERIFY(overlayWords(Overlay::Checker).meaning.contains("1 cm"));
        LengthDisplay::instance().choose(LengthUnit::Inch);
        QCOMPARE(checkerSquare(), 12.7);
        QVERIFY(overlayWords(Overlay::Checker).meaning.contains("1/2 in"));
        LengthDisplay::instance().choose(LengthUnit::Millimetre);
    }

    void percentsCarryTheirSign() {
        QCOMPARE(signedPercent(0.0124), QString("+1.24"));
        QCOMPARE(signedPercent(-0.123), QString("−12.3"));
        QCOMPARE(signedPercent(1e-9), QString("0"));
    }

    void keptOutlinesAreCalledExact() {
        QCOMPARE(boundaryError(3e-13), QString("exact"));
        QCOMPARE(boundaryError(0.0431), QString("4.31"));
    }

    void everyMethodHasANameOfItsOwn() {
        QStringList names;
        for (const MethodTraits& method : allMethods()) {
            names << methodName(method.method);
            QVERIFY(!names.last().isEmpty());
        }
        QCOMPARE(names.removeDuplicates(), 0);
    }

    void unknownStrainIsADash() {
        PieceQuality quality;
        QCOMPARE(strainRange(quality), QString("–"));
        quality.strainMin = -0.012;
        quality.strainMax = 0.034;
        QCOMPARE(strainRange(quality), QString("−1.20 … +3.40"));
    }

    void scaleBarIsARoundLengthThatFits_data() {
        QTest::addColumn<double>("pixelsPerMillimetre");
        QTest::addColumn<double>("millimetres");
        QTest::addColumn<QString>("text");
        QTest::newRow("close") << 100.0 << 1.0 << "1 mm";
        QTest::newRow("usual") << 0.6 << 200.0 << "20 cm";
        QTest::newRow("far") << 0.05 << 2000.0 << "2 m";
    }

    void scaleBarIsARoundLengthThatFits() {
        QFETCH(double, pixelsPerMillimetre);
        QFETCH(double, millimetres);
        QFETCH(QString, text);
        const ScaleBar bar = scaleBarFor(150, pixelsPerMillimetre);
        QCOMPARE(bar.millimetres, millimetres);
        QCOMPARE(bar.text, text);
        QVERIFY(bar.millimetres * pixelsPerMillimetre <= 150.001);
    }
};

TOILE_WINDOW_TEST(FiguresTest)
#include "figures_test.moc"
