// SPDX-License-Identifier: GPL-3.0-or-later
// What the overlays look like in both views, on sheets with known strain. Thresholds in words:
// "the colour" is within kColourSteps steps of 255 in each channel; "most" is nine tenths.
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/document/document.h"
#include "app/jobs/derivation.h"
#include "app/render/colour_map.h"
#include "app/render/overlay_values.h"
#include "app/render/scene_builder.h"
#include "app/render/scene_renderer.h"
#include "app/views/colour_bar.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

namespace {

constexpr int kColourSteps = 6;
constexpr double kNineTenths = 0.9;
/// What the arrow of the grain may cover, which turns with it.
constexpr double kArrow = 0.05;
constexpr double kUpwards = 1.5707963267948966;

bool isLike(QRgb pixel, Rgb colour) {
    return std::abs(qRed(pixel) - colour.r) <= kColourSteps &&
           std::abs(qGreen(pixel) - colour.g) <= kColourSteps &&
           std::abs(qBlue(pixel) - colour.b) <= kColourSteps;
}

/// As in surface.glsl.
Rgb hatched(Rgb ground) {
    const auto mixed = [](int part) {
        return static_cast<std::uint8_t>(0.4 * part + 0.6 * 247.35);
    };
    return {mixed(ground.r), mixed(ground.g), mixed(ground.b)};
}

}  // namespace

class OverlayPicturesTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }

    /// A worn sheet of 200 x 120 mm facing the eye whose cloth is stretched sideways by this part.
    void showStretched(double stretch) {
        auto garment = test::makeGarment({{"front", test::makeSheet(200, 120, 20, 12)}});
        auto result = std::make_shared<PieceResult>();
        result->piece = garment->pieces[0];
        result->flat = FlatPiece{};
        result->flat->Q = garment->pieces[0]->mesh.V.leftCols<2>();
        result->flat->Q.col(0) /= 1 + stretch;
        result->quality = measure(*result->piece, result->flat->Q);
        result->options = document().options();
        DocumentState state;
        state.options = document().options();
        state.fabric = *fabricPreset("neoprene");  // -4 to +20 % in all directions
        Derived derived;
        derived.garment = garment;
        derived.results = {result};
        Progress progress;
        toile::app::draw(derived, progress);
        PieceSettings& settings = state.settings[result->piece->id];
        settings.placement = Placement{};
        settings.grain = kUpwards;
        document().open(std::move(state), std::move(derived));
        // A solver would lay the sheet flat without strain.
        fixture_.workspace().jobs().cancel();
        document().setView(&ViewState::worstSpots, false);
        document().setView(&ViewState::valuesPerTriangle, false);
    }

    void setFabric(const char* id) {
        DocumentState next = document().state();
        next.fabric = *fabricPreset(id);
        document().edit("Fabric", std::move(next));
    }

    void setGrain(double radians) {
        DocumentState next = document().state();
        test::said(next, document(), 0).grain = radians;
        document().edit("Grain", std::move(next));
    }

    /// The pixels of the pattern well inside the piece, away from its name and its arrow.
    std::vector<QRgb> inside() {
        const QImage image = fixture_.patternPicture();
        const Camera2D& camera = fixture_.window().views().patternView()->camera();
        const auto& box = document().scene()->pieces[0].flatBox;
        const Eigen::Vector2d from =
            camera.toScreen({box.min().x() + 6, box.max().y() - 6}) * image.devicePixelRatio();
        const Eigen::Vector2d to =
            camera.toScreen({box.max().x() - 6, box.max().y() - 40}) * image.devicePixelRatio();
        const double middle = (from.x() + to.x()) / 2;
        const double arrow = 14 * image.devicePixelRatio();
        std::vector<QRgb> pixels;
        for (int y = qRound(from.y()); y < qRound(to.y()); ++y) {
            for (int x = qRound(from.x()); x < qRound(to.x()); ++x) {
                if (std::abs(x - middle) > arrow) {
                    pixels.push_back(image.pixel(x, y));
                }
            }
        }
        return pixels;
    }

    /// Share of the pixels that are not the same.
    static double differing(const std::vector<QRgb>& a, const std::vector<QRgb>& b) {
        std::size_t count = a.size() == b.size() ? 0 : a.size();
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
            count += a[i] != b[i];
        }
        return a.empty() ? 1 : double(count) / double(a.size());
    }

    double shareLike(Rgb colour) {
        const auto pixels = inside();
        const auto count =
            std::ranges::count_if(pixels, [&](QRgb pixel) { return isLike(pixel, colour); });
        return pixels.empty() ? 0 : double(count) / double(pixels.size());
    }

    Rgb mapColour(Overlay overlay, double value) {
        const OverlayScale scale = overlayScale(*document().scene(), overlay, document().fabric());
        return colourMap(overlay)[static_cast<std::size_t>(
            std::lround(scale.shade(value) * (kColourMapSize - 1)))];
    }

private slots:
    void initTestCase() { SKIP_WITHOUT_GL(); }
    void init() { fixture_.open(); }
    void cleanup() { fixture_.close(); }

    void mostOfTheClothHasTheColourOfItsValue_data() {
        QTest::addColumn<int>("overlay");
        QTest::addColumn<double>("value");
        QTest::newRow("area") << int(Overlay::Area) << 5.0;
        // The corners of 45 degrees of half a square.
        QTest::newRow("angle") << int(Overlay::Angle)
                               << std::atan(1.05) * 180 / std::numbers::pi - 45;
        QTest::newRow("warp") << int(Overlay::Warp) << 0.0;
        QTest::newRow("weft") << int(Overlay::Weft) << 5.0;
        QTest::newRow("bias") << int(Overlay::Bias) << 100 * (std::sqrt((1.05 * 1.05 + 1) / 2) - 1);
        QTest::newRow("energy") << int(Overlay::Dirichlet)
                                << 100 * ((1.1025 + 1 / 1.1025 + 2) / 4 - 1);
    }

    void mostOfTheClothHasTheColourOfItsValue() {
        QFETCH(int, overlay);
        QFETCH(double, value);
        showStretched(0.05);
        document().setOverlay(static_cast<Overlay>(overlay));
        for (const bool perTriangle : {false, true}) {
            document().setView(&ViewState::valuesPerTriangle, perTriangle);
            const double share = shareLike(mapColour(static_cast<Overlay>(overlay), value));
            QVERIFY2(share > kNineTenths, qPrintable(QString::number(share)));
        }
    }

    void anEdgesStrainIsThatOfTheWorstEdgePerTriangle() {
        showStretched(0.05);
        document().setOverlay(Overlay::Strain);
        document().setView(&ViewState::valuesPerTriangle, true);
        QVERIFY(shareLike(mapColour(Overlay::Strain, 5)) > kNineTenths);
    }

    void stripesAppearBeyondTheLimitsAndGoWithAWiderFabric() {
        showStretched(0.05);
        document().setOverlay(Overlay::Weft);
        // Lighter than the end of the colours; at the same place wherever that is.
        const Rgb stripe = hatched(colourMap(Overlay::Weft).back());
        // The light rim of the grain arrow has some pixels of the same colour.
        constexpr double kNone = 1e-3;
        QVERIFY2(shareLike(stripe) < kNone, qPrintable(QString::number(shareLike(stripe))));
        setFabric("denim");  // +1.5 % along the weft
        const double striped = shareLike(stripe);
        QVERIFY2(striped > 0.04 && striped < 0.4, qPrintable(QString::number(striped)));
        QVERIFY2(shareLike(mapColour(Overlay::Weft, 99)) > 0.4, "the end's colour between them");
        const auto& bar = fixture_.find<ColourBar>("colourBar");
        QVERIFY2(bar.summary().contains("100 %"), qPrintable(bar.summary()));
        setFabric("jersey");
        QVERIFY2(shareLike(stripe) < kNone, qPrintable(QString::number(shareLike(stripe))));
        QVERIFY2(bar.summary().contains("within"), qPrintable(bar.summary()));
    }

    void surplusAndStretchAreHatchedInDifferentDirections() {
        setLocale();
        showStretched(0.3);
        document().setOverlay(Overlay::Weft);
        const QImage stretched = fixture_.patternPicture();
        QVERIFY(runsUpwards(stretched));
        showStretched(-0.3);
        const QImage surplus = fixture_.patternPicture();
        QVERIFY(!runsUpwards(surplus));
    }

    void theGrainTurnedByARightAngleExchangesWarpAndWeft() {
        showStretched(0.05);
        const int uploads = fixture_.window().views().patternView()->renderer().meshUploads();
        document().setOverlay(Overlay::Warp);
        (void)fixture_.patternPicture();
        const auto warp = inside();
        document().setOverlay(Overlay::Weft);
        const auto weft = inside();
        QVERIFY(differing(warp, weft) > 0.9);
        setGrain(0);
        QVERIFY(differing(inside(), warp) < kArrow);
        document().setOverlay(Overlay::Warp);
        QVERIFY(differing(inside(), weft) < kArrow);
        const int after = fixture_.window().views().patternView()->renderer().meshUploads();
        QVERIFY2(after - uploads <= 1, "one upload: the mesh when it was shown first");
        setGrain(0.3);
        (void)inside();
        QCOMPARE(fixture_.window().views().patternView()->renderer().meshUploads(), after);
    }

    void glyphsAreDrawnInColourOnGreyCloth() {
        showStretched(0.05);
        document().setOverlay(Overlay::Principal);
        const double ground = shareLike(mapColour(Overlay::Principal, 0));
        QVERIFY2(ground > 0.5 && ground < 0.985, qPrintable(QString::number(ground)));
        const auto pixels = inside();
        const auto orange = std::ranges::count_if(
            pixels, [](QRgb pixel) { return qRed(pixel) > qBlue(pixel) + 50; });
        QVERIFY2(double(orange) > 0.003 * double(pixels.size()), "strokes of the stretch");
        const QImage garment = fixture_.garmentPicture();
        int onGarment = 0;
        for (int y = 0; y < garment.height(); ++y) {
            for (int x = 0; x < garment.width(); ++x) {
                const QRgb pixel = garment.pixel(x, y);
                onGarment += qRed(pixel) > qBlue(pixel) + 50;
            }
        }
        QVERIFY2(onGarment > 100, "strokes on the garment too");
    }

    void theBarShowsTheValueUnderThePointer() {
        setLocale();
        showStretched(0.05);
        document().setOverlay(Overlay::Weft);
        const auto& bar = fixture_.find<ColourBar>("colourBar");
        fixture_.window().views().showValueAt(SurfaceHit{0, 3});
        QCOMPARE(bar.valueText(), QString("+5.0") + QChar(0x202F) + "%");
        fixture_.window().views().showValueAt(std::nullopt);
        QVERIFY(bar.valueText().isEmpty());
    }

    void theNumberFollowsWhatIsUnderAPointerThatRests() {
        setLocale();
        showStretched(0.05);
        document().setOverlay(Overlay::Weft);
        const auto& bar = fixture_.find<ColourBar>("colourBar");
        fixture_.window().views().showValueAt(SurfaceHit{0, 3});
        setGrain(0);
        QCOMPARE(bar.valueText(), QString("0.0") + QChar(0x202F) + "%");
        document().setOverlay(Overlay::Warp);
        QCOMPARE(bar.valueText(), QString("+5.0") + QChar(0x202F) + "%");
    }

    void theWorstSpotIsFlaggedInBothViews() {
        showStretched(0.3);
        document().setOverlay(Overlay::Weft);
        const QImage pattern = fixture_.patternPicture(), garment = fixture_.garmentPicture();
        document().setView(&ViewState::worstSpots, true);
        QVERIFY(fixture_.patternPicture() != pattern);
        QVERIFY(fixture_.garmentPicture() != garment);
    }

    void theBarIsLegibleInTheDark() {
        const QPalette before = QApplication::palette();
        QPalette dark(QColor(40, 42, 46));
        dark.setColor(QPalette::WindowText, QColor(225, 227, 230));
        QApplication::setPalette(dark);
        QCoreApplication::processEvents();
        showStretched(0.05);
        setFabric("denim");
        document().setOverlay(Overlay::Weft);
        document().setView(&ViewState::worstSpots, true);
        const QImage image = fixture_.find<ColourBar>("colourBar").grab().toImage();
        if (const QString folder = qEnvironmentVariable("TOILE_PICTURES"); !folder.isEmpty()) {
            fixture_.window().grab().save(folder + "/dark.png");
        }
        QApplication::setPalette(before);
        // The title stands at the left: letters that stand out from a dark ground.
        int lightest = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width() / 8; ++x) {
                lightest = std::max(lightest, qGray(image.pixel(x, y)));
            }
        }
        QVERIFY(qGray(image.pixel(image.width() / 2, 2)) < 80);
        QVERIFY(lightest > 190);
    }

    void everyKeyShowsItsOverlay() {
        showStretched(0.05);
        QTest::keyClick(fixture_.window().views().garmentView(), Qt::Key_0);
        QCOMPARE(document().view().overlay, Overlay::Dirichlet);
        QTest::keyClick(fixture_.window().views().garmentView(), Qt::Key_9);
        QCOMPARE(document().view().overlay, Overlay::Principal);
        QTest::keyClick(fixture_.window().views().garmentView(), Qt::Key_6);
        QCOMPARE(document().view().overlay, Overlay::Warp);
    }

    void toolbarShowsTheOverlayAndTheTwoBefore() {
        showStretched(0.05);
        auto* view = fixture_.window().views().garmentView();
        const auto shown = [this] {
            return QStringList{fixture_.find<QToolButton>("overlayChoice").text(),
                               fixture_.find<QToolButton>("lastOverlay1").text(),
                               fixture_.find<QToolButton>("lastOverlay2").text()};
        };
        for (const Qt::Key key : {Qt::Key_6, Qt::Key_5, Qt::Key_4}) {
            QTest::keyClick(view, key);
        }
        QCOMPARE(shown(), (QStringList{"Angle", "Strain", "Warp"}));
        QTest::mouseClick(&fixture_.find<QToolButton>("lastOverlay2"), Qt::LeftButton);
        QCOMPARE(document().view().overlay, Overlay::Warp);
        QCOMPARE(shown(), (QStringList{"Warp", "Angle", "Strain"}));
        QCOMPARE(fixture_.find<QToolButton>("overlayChoice").menu()->actions().size(),
                 qsizetype(kOverlayCount));
    }

    void normalsAreColouredAlikeInBothViews() {
        showStretched(0.05);
        document().setOverlay(Overlay::Normal);
        const Rgb facingFront{128, 128, 255};
        QVERIFY(shareLike(facingFront) > kNineTenths);
        const QImage worn = fixture_.garmentPicture();
        QVERIFY(isLike(worn.pixel(worn.width() / 2, worn.height() / 2), facingFront));
    }

private:
    static void setLocale() { QLocale::setDefault(QLocale::c()); }

    /// Of stripes across a piece: does the pattern of a row move to the right in the row above?
    bool runsUpwards(const QImage& image) {
        const Camera2D& camera = fixture_.window().views().patternView()->camera();
        const auto& box = document().scene()->pieces[0].flatBox;
        const Eigen::Vector2d middle =
            camera.toScreen({box.center().x(), box.max().y() - 20}) * image.devicePixelRatio();
        const auto differenceAt = [&](int shift) {
            double sum = 0;
            for (int dx = -60; dx < 60; ++dx) {
                const int x = qRound(middle.x()) + dx, y = qRound(middle.y());
                sum += std::abs(qGray(image.pixel(x, y)) - qGray(image.pixel(x + shift, y - 2)));
            }
            return sum;
        };
        return differenceAt(2) < differenceAt(-2);
    }
};

TOILE_WINDOW_TEST(OverlayPicturesTest)
#include "overlay_pictures_test.moc"
