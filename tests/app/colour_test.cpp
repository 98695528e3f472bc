// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <limits>

#include "app/render/colour_map.h"
#include "app/render/overlay_scale.h"
#include "app/widgets/colour_bar.h"

using namespace toile;

namespace {

double lightness(Rgb c) {
    return 0.299 * c.r + 0.587 * c.g + 0.114 * c.b;
}

}  // namespace

class ColourTest : public QObject {
    Q_OBJECT

private slots:
    void divergingMapIsBlueThenGreyThenOrange() {
        const Rgb low = divergingMap()[20], middle = divergingMap()[128],
                  high = divergingMap()[235];
        QVERIFY(low.b > low.r + 40);
        QVERIFY(high.r > high.b + 60);
        QVERIFY(std::abs(middle.r - middle.b) < 6 && lightness(middle) > 220);
    }

    void divergingMapDarkensEvenlyToBothSides() {
        for (int i = 0; i < 127; ++i) {
            QVERIFY(lightness(divergingMap()[static_cast<std::size_t>(i)]) <=
                    lightness(divergingMap()[static_cast<std::size_t>(i) + 1]) + 1);
        }
        for (int i = 128; i < 255; ++i) {
            QVERIFY(lightness(divergingMap()[static_cast<std::size_t>(i)]) + 1 >=
                    lightness(divergingMap()[static_cast<std::size_t>(i) + 1]));
        }
        // Like sizes of surplus and stretch look alike strong.
        for (int i = 0; i < 128; ++i) {
            QVERIFY(std::abs(lightness(divergingMap()[static_cast<std::size_t>(i)]) -
                             lightness(divergingMap()[static_cast<std::size_t>(255 - i)])) < 40);
        }
    }

    void sequentialMapDarkens() {
        for (std::size_t i = 0; i + 1 < kColourMapSize; ++i) {
            QVERIFY(lightness(sequentialMap()[i]) + 1 >= lightness(sequentialMap()[i + 1]));
        }
        QVERIFY(lightness(sequentialMap().front()) - lightness(sequentialMap().back()) > 150);
    }

    void neighbouringPiecesDifferInColour() {
        for (int i = 0; i < 40; ++i) {
            QVERIFY(!(pieceColour(i) == pieceColour(i + 1)));
        }
        QVERIFY(!(pieceColour(0) == pieceColour(12)));
    }

    void roundsUpToWhatReadsEasily_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("plain");
        QTest::addColumn<double>("close");
        QTest::newRow("0.2 stays") << 0.2 << 0.2 << 0.2;
        QTest::newRow("0.23") << 0.23 << 0.5 << 0.3;
        QTest::newRow("1") << 1.0 << 1.0 << 1.0;
        QTest::newRow("52") << 52.0 << 100.0 << 60.0;
        QTest::newRow("9") << 9.0 << 10.0 << 10.0;
        QTest::newRow("nothing") << 0.0 << 1.0 << 1.0;
    }

    void roundsUpToWhatReadsEasily() {
        QFETCH(double, value);
        QFETCH(double, plain);
        QFETCH(double, close);
        QCOMPARE(roundedUp(value), plain);
        QCOMPARE(roundedUpClosely(value), close);
    }

    void signedScaleIsSymmetricAndSaysWhatItClamps() {
        std::vector<float> values(1000, 0.0F);
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = static_cast<float>(i) / 1000.0F * 4.0F - 1.0F;  // -1 .. 3
        }
        values.back() = 500;  // one bad triangle
        const OverlayScale scale = robustScale(values, true, 0.1);
        QCOMPARE(scale.low, -scale.high);
        QCOMPARE(scale.high, 3.0);
        QVERIFY(scale.above);
        QVERIFY(!scale.below);
    }

    void roundingNoiseIsNotBlownUp() {
        const OverlayScale scale = robustScale({1e-9F, -2e-10F, 0.0F}, true, 0.1);
        QCOMPARE(scale.low, -0.1);
        QCOMPARE(scale.high, 0.1);
    }

    void unsignedScaleStartsAtZero() {
        const OverlayScale scale = robustScale({0.5F, 1.0F, 7.0F}, false, 0.1);
        QCOMPARE(scale.low, 0.0);
        QVERIFY(scale.high >= 1.0);
    }

    void nothingAndNonsenseGiveAUsableScale() {
        const float nan = std::numeric_limits<float>::quiet_NaN();
        const float infinite = std::numeric_limits<float>::infinity();
        for (const auto& values : {std::vector<float>{}, std::vector<float>{nan, infinite}}) {
            const OverlayScale scale = robustScale(values, true, 0.1);
            QVERIFY(scale.high > scale.low);
        }
    }

    void positionsAreClamped() {
        const OverlayScale scale{-2, 2, false, false};
        QCOMPARE(scale.position(0), 0.5);
        QCOMPARE(scale.position(9), 1.0);
        QCOMPARE(scale.position(-9), 0.0);
    }

    void barSaysWhereItClamps() {
        QLocale::setDefault(QLocale::c());
        ColourBar bar;
        bar.show(Overlay::Strain, {-5, 5, false, true});
        QVERIFY2(bar.summary().contains("≥ +5 %"), qPrintable(bar.summary()));
        QVERIFY2(bar.summary().contains("−5 %") && !bar.summary().contains("≤"),
                 qPrintable(bar.summary()));
    }
};

QTEST_MAIN(ColourTest)
#include "colour_test.moc"
