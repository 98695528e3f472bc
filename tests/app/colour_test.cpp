// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/render/colour_map.h"
#include "app/text/figures.h"
#include "app/views/colour_bar.h"
#include "app/views/ruler.h"
#include "app/views/view_text.h"
#include "core/project/piece_settings.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

double lightness(Rgb c) {
    return 0.299 * c.r + 0.587 * c.g + 0.114 * c.b;
}

/// CIE L*a*b* of an sRGB colour, D65; `linear` may come out of a simulation a little out of range.
struct Lab {
    double L, a, b;
};

using Linear = std::array<double, 3>;

Linear linear(Rgb c) {
    const auto channel = [](std::uint8_t v) {
        const double x = v / 255.0;
        return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    return {channel(c.r), channel(c.g), channel(c.b)};
}

Lab lab(const Linear& c) {
    const auto f = [](double t) {
        return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    };
    const double x = (0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.9505;
    const double y = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    const double z = (0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.089;
    return {116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))};
}

double distance(const Lab& one, const Lab& other) {
    return std::hypot(one.L - other.L, one.a - other.a, one.b - other.b);
}

/// How a person without red or green cones sees a colour: Machado, Oliveira, Fernandes 2009, full
/// severity, on linear light.
using Sight = std::array<std::array<double, 3>, 3>;
constexpr Sight kFull = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Sight kProtanopia = {{{0.152286, 1.052583, -0.204868},
                                {0.114503, 0.786281, 0.099216},
                                {-0.003882, -0.048116, 1.051998}}};
constexpr Sight kDeuteranopia = {{{0.367322, 0.860646, -0.227968},
                                  {0.280085, 0.672501, 0.047413},
                                  {-0.011820, 0.042940, 0.968881}}};

Lab seen(Rgb c, const Sight& sight) {
    const Linear in = linear(c);
    Linear out{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t k = 0; k < 3; ++k) {
            out[row] += sight[row][k] * in[k];
        }
        out[row] = std::clamp(out[row], 0.0, 1.0);
    }
    return lab(out);
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

    void surplusAndStretchAreToldApartByEverySight_data() {
        QTest::addColumn<int>("sight");
        QTest::newRow("full colour") << 0;
        QTest::newRow("protanopia") << 1;
        QTest::newRow("deuteranopia") << 2;
    }

    void surplusAndStretchAreToldApartByEverySight() {
        QFETCH(int, sight);
        const Sight& eye = sight == 0 ? kFull : sight == 1 ? kProtanopia : kDeuteranopia;
        const ColourMap& map = divergingMap();
        const Lab zero = seen(map[127], eye);
        double before = 0;
        for (int i = 24; i <= 127; i += 8) {
            // Values of like size and other sign, and of either sign and none. A difference of 2.3
            // is just noticeable side by side.
            const Lab low = seen(map[static_cast<std::size_t>(127 - i)], eye);
            const Lab high = seen(map[static_cast<std::size_t>(128 + i)], eye);
            const double apart = distance(low, high);
            QVERIFY2(apart > 20, qPrintable(QString("%1: %2").arg(i).arg(apart)));
            QVERIFY(distance(low, zero) > 10 && distance(high, zero) > 10);
            QVERIFY(apart > before - 25);
            before = apart;
        }
    }

    void lightnessFallsOnBothSidesOfNothing() {
        const ColourMap& map = divergingMap();
        for (const Sight& eye : {kFull, kProtanopia, kDeuteranopia}) {
            for (std::size_t i = 0; i < 127; ++i) {
                QVERIFY(seen(map[i], eye).L < seen(map[i + 1], eye).L + 0.15);
                QVERIFY(seen(map[255 - i], eye).L < seen(map[254 - i], eye).L + 0.15);
            }
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
        for (int shade = 1; shade < 5; ++shade) {
            QVERIFY(!(pieceColour(0) == pieceColour(shade * kHueCount)));
        }
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
        bar.show({Overlay::Area, {-5, 5, false, true}});
        QVERIFY2(bar.summary().contains("≥ +5 %"), qPrintable(bar.summary()));
        QVERIFY2(bar.summary().contains("−5 %") && !bar.summary().contains("≤"),
                 qPrintable(bar.summary()));
    }

    void barSaysHowMuchIsBeyondTheFabric() {
        QLocale::setDefault(QLocale::c());
        ColourBar bar;
        Histogram histogram;
        histogram.bins[7] = 0.86;
        histogram.below = 0.02;
        histogram.above = 0.12;
        bar.show({Overlay::Weft, {-1, 3, true, true, true}, histogram});
        QVERIFY2(bar.summary().contains("−1 % to +3 %"), qPrintable(bar.summary()));
        QVERIFY2(bar.summary().contains("14 % of the cloth exceeds"), qPrintable(bar.summary()));
        bar.showValue(-2.44);
        QCOMPARE(bar.valueText(), QString("−2.4") + QChar(0x202F) + "%");
        (void)bar.grab();
        bar.show({Overlay::Angle, {0, 5, false, false}});
        QVERIFY2(bar.valueText().isEmpty(), "a strain is no angle");
    }

    void theBarInACornerLeavesTheScaleBarItsCorner() {
        QWidget view;
        ColourBar& bar = *ColourBar::inCorner(view);
        for (const int width : {1200, 700, 480, 460, 330, 240}) {
            view.resize(width, 420);
            bar.show({Overlay::Strain, {-5, 5, true, true, true}});
            QVERIFY2(view.rect().contains(bar.geometry()), qPrintable(QString::number(width)));
            QVERIFY2(bar.width() >= std::min(260, width - 40), qPrintable(QString::number(width)));
            for (const double scale : {0.2, 0.37, 0.5, 1.9, 5.2}) {
                const QRectF corner = scaleBarBox(view.font(), view.rect(), scale, kRulerBreadth);
                QVERIFY(!corner.intersects(bar.geometry()));
            }
        }
    }

    void valuesAreReadWithTheirUnit() {
        QLocale::setDefault(QLocale::c());
        const QString space(QChar(0x202F));
        QCOMPARE(overlayValueText(Overlay::Warp, 2.44), "+2.4" + space + "%");
        QCOMPARE(overlayValueText(Overlay::Warp, -0.04), "0.0" + space + "%");
        QCOMPARE(overlayValueText(Overlay::Angle, 3.14), QString("3.1°"));
        QCOMPARE(overlayValueText(Overlay::Dirichlet, 0.123), "0.12" + space + "%");
        QCOMPARE(overlayNumber(Overlay::Bias, 12.5), QString("+12.5"));
        QCOMPARE(overlayNumber(Overlay::Angle, 12.5), QString("12.5"));
    }
};

TOILE_WINDOW_TEST(ColourTest)
#include "colour_test.moc"
