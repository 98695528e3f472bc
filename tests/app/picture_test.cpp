// SPDX-License-Identifier: GPL-3.0-or-later
// What pictures of the views show, in words: "the colour" is within kSameColour steps of 255 in
// each channel, "most" is nine tenths, "the same picture" differs in less than a fiftieth of its
// pixels.
#include <QBuffer>
#include <QOpenGLContext>
#include <QTest>

#include "app/render/gl_support.h"
#include "app/render/offscreen.h"
#include "app/render/render_style.h"
#include "app/views/colour_bar.h"
#include "app/views/colour_legend.h"
#include "tests/app/support/picture_bench.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;
using namespace toile::test;

class PictureTest : public QObject, private PictureBench {
    Q_OBJECT

private slots:
    void initTestCase() {
        QString problem;
        context_ = makeOffscreenContext(problem);
        if (!context_) {
            QSKIP(qPrintable(problem));
        }
    }
    /// Windows make their contexts current and let go of them.
    void init() {
        context_.reset();
        QString problem;
        context_ = makeOffscreenContext(problem);
        QVERIFY2(context_, qPrintable(problem));
    }
    void cleanup() { document_.reset(); }
    void cleanupTestCase() { context_.reset(); }

    void theChecksAreCentimetresAndHalfOfThemAreDark_data() {
        QTest::addColumn<int>("view");
        QTest::newRow("garment") << int(ViewsShown::Garment);
        QTest::newRow("pattern") << int(ViewsShown::Pattern);
    }

    void theChecksAreCentimetresAndHalfOfThemAreDark() {
        QFETCH(int, view);
        const auto shown = static_cast<ViewsShown>(view);
        openStretched(0);
        document().setOverlay(Overlay::Checker);
        document().setView(&ViewState::seams, false);
        const QImage image = draw(shown);
        const QRect part = inside(shown);
        int least = 255, most = 0;
        for (int x = part.left(); x < part.right(); ++x) {
            least = std::min(least, qGray(image.pixel(x, part.top() + 3)));
            most = std::max(most, qGray(image.pixel(x, part.top() + 3)));
        }
        QVERIFY2(most - least > 30, "two shades that are told apart");
        const int between = (least + most) / 2;
        const double dark =
            shareInside(image, shown, [&](QRgb pixel) { return qGray(pixel) < between; });
        QVERIFY2(std::abs(dark - 0.5) < 0.05, qPrintable(QString::number(dark)));

        const double scale = shown == ViewsShown::Pattern ? patternCamera().pixelsPerMillimetre()
                                                          : garmentCamera().pixelsPerMillimetre();
        std::vector<int> edges;  // along a row, left of the arrow
        for (int x = part.left(); x < part.center().x() - 14; ++x) {
            const bool before = qGray(image.pixel(x, part.top() + 3)) < between;
            if (before != (qGray(image.pixel(x + 1, part.top() + 3)) < between)) {
                edges.push_back(x);
            }
        }
        QVERIFY(edges.size() >= 5);
        for (std::size_t i = 1; i < edges.size(); ++i) {
            const double square = edges[i] - edges[i - 1];
            QVERIFY2(std::abs(square - 10 * scale) <= 1, qPrintable(QString::number(square)));
        }
    }

    void pieceColoursArePlain() {
        openStretched(0);
        document().setOverlay(Overlay::None);
        for (const ViewsShown view : {ViewsShown::Garment, ViewsShown::Pattern}) {
            QVERIFY(shareLike(view, colourOf(pieceColour(0))) > kMax);
        }
    }

    void mostOfTheClothHasTheColourOfItsValue_data() {
        QTest::addColumn<int>("overlay");
        QTest::addColumn<double>("value");
        QTest::newRow("area") << int(Overlay::Area) << 100 * 1.1 - 100;
        QTest::newRow("angle") << int(Overlay::Angle)
                               << std::atan(1.1) * 180 / std::numbers::pi - 45;
        QTest::newRow("strain") << int(Overlay::Strain) << 10.0;  // of the worst edge
        QTest::newRow("warp") << int(Overlay::Warp) << 0.0;
        QTest::newRow("weft") << int(Overlay::Weft) << 10.0;
        QTest::newRow("bias") << int(Overlay::Bias) << 100 * (std::sqrt((1.21 + 1) / 2) - 1);
        QTest::newRow("energy") << int(Overlay::Dirichlet) << 100 * ((1.21 + 1 / 1.21 + 2) / 4 - 1);
    }

    void mostOfTheClothHasTheColourOfItsValue() {
        QFETCH(int, overlay);
        QFETCH(double, value);
        openStretched(0.1);
        document().setOverlay(static_cast<Overlay>(overlay));
        document().setView(&ViewState::valuesPerTriangle, true);
        const QColor colour = mapColour(static_cast<Overlay>(overlay), value);
        for (const ViewsShown view : {ViewsShown::Garment, ViewsShown::Pattern}) {
            const double share = shareLike(view, colour);
            QVERIFY2(share > kMax, qPrintable(QString::number(share)));
        }
    }

    void glyphsStandOnGreyClothInBothViews() {
        openStretched(0.1);
        document().setOverlay(Overlay::Principal);
        for (const ViewsShown view : {ViewsShown::Garment, ViewsShown::Pattern}) {
            const double grey = shareLike(view, mapColour(Overlay::Principal, 0));
            QVERIFY2(grey > 0.5 && grey < 0.99, qPrintable(QString::number(grey)));
            const double orange = shareInside(
                draw(view), view, [](QRgb pixel) { return qRed(pixel) > qBlue(pixel) + 50; });
            QVERIFY2(orange > 0.005, qPrintable(QString::number(orange)));
        }
    }

    void warpAndWeftGoWithTheGrain() {
        openStretched(0.1);
        for (const ViewsShown view : {ViewsShown::Garment, ViewsShown::Pattern}) {
            setGrain(kGrainUpwards);
            document().setOverlay(Overlay::Weft);
            QVERIFY(shareLike(view, mapColour(Overlay::Weft, 10)) > kMax);
            setGrain(0);
            QVERIFY(shareLike(view, mapColour(Overlay::Weft, 0)) > kMax);
            document().setOverlay(Overlay::Warp);
            QVERIFY(shareLike(view, mapColour(Overlay::Warp, 10)) > kMax);
        }
    }

    void bentClothThatLiesFlatWithoutStrainIsGrey() {
        openFlattened(test::makeGarment({{"strip", test::makeBentStrip(0)}}));
        document().setOverlay(Overlay::Area);
        const double share = shareLike(ViewsShown::Pattern, mapColour(Overlay::Area, 0));
        QVERIFY2(share > kMax, qPrintable(QString::number(share)));
    }

    void stripesAreThereBeyondTheLimitsAndNotWithin() {
        // As in surface.glsl: so much of the colour of the end that is passed.
        const auto hatched = [this](double stretch) {
            const QColor end = mapColour(Overlay::Weft, stretch < 0 ? -99 : 99);
            const auto mixed = [](int part) { return static_cast<int>(0.4 * part + 0.6 * 247.35); };
            return QColor(mixed(end.red()), mixed(end.green()), mixed(end.blue()));
        };
        for (const ViewsShown view : {ViewsShown::Garment, ViewsShown::Pattern}) {
            for (const auto& [stretch, striped] :
                 {std::pair(0.1, false), std::pair(0.3, true), std::pair(-0.1, true)}) {
                openStretched(stretch);
                document().setOverlay(Overlay::Weft);
                const double share = shareLike(view, hatched(stretch));
                // The light rim of the grain arrow has some pixels of the same colour.
                QVERIFY2(striped ? share > 0.04 && share < 0.4 : share < 1e-3,
                         qPrintable(QString::number(share)));
            }
        }
    }

    void bothSidesOfASeamHaveItsColourAndNothingElseHas() {
        openFlattened(test::makeSewnCap());
        document().setOverlay(Overlay::None);
        toile::app::setGrain(document(), "Grain", {{0, 0.0}, {1, 0.0}});  // no arrow along the seam
        const Scene& scene = *document().scene();
        const std::vector<int> colours = seamColours(document().garment()->seams);
        Camera2D camera;
        camera.setViewport(kSize.width(), kSize.height());
        const SheetPlaces places = placesOf(document().settings(), document().colours());
        framePattern(camera, scene, places, {0, 1}, false);
        const QImage shown = draw(ViewsShown::Pattern);
        document().setView(&ViewState::seams, false);
        const QImage hidden = draw(ViewsShown::Pattern);
        int sewn = 0;
        for (std::size_t seam = 0; seam < scene.seams.size(); ++seam) {
            if (colours[seam] < 0) {
                continue;
            }
            ++sewn;
            const QRgb colour =
                colourOf(seamPalette()[static_cast<std::size_t>(colours[seam])]).rgb();
            for (std::size_t side = 0; side < 2; ++side) {
                const VertexRun run = scene.patternLines.seams[seam][side];
                int like = 0, likeHidden = 0;
                for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
                    const auto& vertex = scene.lineVertices[i];
                    const Eigen::Vector2d at =
                        camera.toScreen(placeOf(places, static_cast<int>(vertex.piece))
                                            .placement.applied({vertex.flat[0], vertex.flat[1]}));
                    const QPoint pixel(qFloor(at.x()), qFloor(at.y()));
                    like += distance(shown.pixel(pixel), colour) <= kLineColour;
                    likeHidden += distance(hidden.pixel(pixel), colour) <= kLineColour;
                }
                // At its ends other lines meet it.
                QVERIFY2(like + 2 >= int(run.count), qPrintable(QString::number(like)));
                QCOMPARE(likeHidden, 0);
            }
        }
        QCOMPARE(sewn, 1);
    }

    void aSelectedPieceKeepsTheColoursOfItsSeams() {
        openFlattened(test::makeSewnCap());
        document().setOverlay(Overlay::None);
        const std::vector<int> colours = seamColours(document().garment()->seams);
        const auto sewn = std::ranges::find_if(colours, [](int colour) { return colour >= 0; });
        QVERIFY(sewn != colours.end());
        const QRgb seam = colourOf(seamPalette()[static_cast<std::size_t>(*sewn)]).rgb();
        const QRgb selection = renderStyle(lightPalette()).selection.rgb();
        const auto count = [](const QImage& image, QRgb colour) {
            int like = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    like += distance(image.pixel(x, y), colour) <= kLineColour;
                }
            }
            return like;
        };
        for (const ViewsShown view : {ViewsShown::Garment, ViewsShown::Pattern}) {
            document().setSelection({});
            const QImage plain = draw(view);
            document().setSelection({0, 1});
            const QImage selected = draw(view);
            QVERIFY(count(plain, seam) > 50);
            QVERIFY2(
                count(selected, seam) > 0.9 * count(plain, seam),
                qPrintable(QString("%1 of %2").arg(count(selected, seam)).arg(count(plain, seam))));
            QVERIFY2(count(selected, selection) > count(plain, selection) + 50, "and a halo");
        }
    }

    void inXrayMoreThanHalfOfTheNearestSheetsColourIsLeft() {
        // One sheet before another, in the colours of two pieces.
        auto garment =
            test::makeGarment({{"front", test::makeSheet(200, 120, 20, 12)},
                               {"back", test::makeSheet(200, 120, 20, 12, {0, 0, -50})}});
        const Points2 flat = garment->pieces[0]->mesh.V.leftCols<2>();
        open(garment,
             {resultOf(garment->pieces[0], flat, {}), resultOf(garment->pieces[1], flat, {})});
        document().setOverlay(Overlay::None);
        PictureOptions asked = options(ViewsShown::Garment);
        const auto middle = [&] {
            const QImage image = draw(asked);
            return image.pixelColor(image.width() / 2 + 40, image.height() / 2 + 40);
        };
        const QColor plain = middle();
        document().setView(&ViewState::xray, true);
        const QColor through = middle();
        const QColor behind = colourOf(pieceColour(1));
        QVERIFY(distance(plain.rgb(), colourOf(pieceColour(0)).rgb()) <= kSameColour);
        QVERIFY2(distance(plain.rgb(), behind.rgb()) > 30, "two colours");
        // As a mixture of the nearest sheet's colour, that behind it and a ground nearly white.
        const double near = 0.58, far = 0.34 * (1 - near), ground = 1 - near - far;
        for (const auto& [seen, a, b] : {std::tuple(through.red(), plain.red(), behind.red()),
                                         std::tuple(through.green(), plain.green(), behind.green()),
                                         std::tuple(through.blue(), plain.blue(), behind.blue())}) {
            const double expected = near * a + far * b + ground * 243;
            QVERIFY2(std::abs(seen - expected) < 6,
                     qPrintable(QString("%1 of %2").arg(seen).arg(expected)));
        }
    }

    void linesOfADistantMeshDoNotCoverTheColours() {
        for (const auto& [cells, covered] : {std::pair(12, true), std::pair(200, false)}) {
            auto garment =
                test::makeGarment({{"front", test::makeSheet(200, 120, cells, cells * 3 / 5)}});
            Points2 flat = garment->pieces[0]->mesh.V.leftCols<2>();
            flat.col(0) /= 1.1;
            open(garment, {resultOf(garment->pieces[0], flat, {})});
            document().setOverlay(Overlay::Weft);
            for (const ViewsShown view : {ViewsShown::Garment, ViewsShown::Pattern}) {
                document().setView(&ViewState::wireframe, false);
                const QImage without = draw(view);
                document().setView(&ViewState::wireframe, true);
                const double share = differing(without, draw(view), 12);
                QVERIFY2(covered ? share > 0.02 : share < 0.001,
                         qPrintable(QString::number(share)));
            }
        }
    }

    void aCapCoversWhatGeometrySays() {
        auto garment = test::makeGarment({{"cap", makeRoundCap(100, 1.0, 24, 120)}});
        Points2 flat = garment->pieces[0]->mesh.V.leftCols<2>();
        open(garment, {resultOf(garment->pieces[0], flat, {})});
        const Camera3D camera = garmentCamera();
        // The rim is the silhouette: it stands upright before the eye.
        const double z = document().scene()->box.min().z();
        const double radius = 100 * std::sin(1.0);
        const double pixels = (camera.project({radius, 0, z}) - camera.project({0, 0, z})).norm();
        const double expected =
            std::numbers::pi * pixels * pixels / (kSize.width() * kSize.height());
        const double share = shareOfCloth(options(ViewsShown::Garment));
        QVERIFY2(std::abs(share / expected - 1) < 0.02,
                 qPrintable(QString("%1 of %2").arg(share).arg(expected)));
    }

    void theGarmentOnItsWayEndsAsThePattern() {
        openStretched(0.1);
        PictureOptions asked = options(ViewsShown::Garment);
        asked.morph = 1;
        const double flat = shareOfCloth(asked);
        const double worn = shareOfCloth(options(ViewsShown::Garment));
        // Framed alike by their widths: what is narrower is drawn larger.
        QVERIFY2(flat > worn * 1.02, qPrintable(QString("%1 of %2").arg(flat).arg(worn)));
    }

    void bothViewsStandSideBySide() {
        openStretched(0.1);
        const QImage both = draw(options(ViewsShown::Both, QSize(1401, 500)));
        QCOMPARE(both.size(), QSize(1401, 500));
        QCOMPARE(both.copy(0, 0, 700, 500), draw(options(ViewsShown::Garment, QSize(700, 500))));
        QCOMPARE(both.copy(700, 0, 701, 500), draw(options(ViewsShown::Pattern, QSize(701, 500))));
    }

    void theBarStandsBelowAndTakesNothingElseAway() {
        openStretched(0.1);
        document().setOverlay(Overlay::Weft);
        PictureOptions asked = options(ViewsShown::Pattern);
        asked.legend = true;
        const int height = legendHeight(asked.font);
        const QImage image = draw(asked);
        QCOMPARE(image.size(), kSize);
        QCOMPARE(image.copy(0, 0, kSize.width(), kSize.height() - height),
                 draw(options(ViewsShown::Pattern, QSize(kSize.width(), kSize.height() - height))));
        const QImage bar = image.copy(0, kSize.height() - height, kSize.width(), height);
        int ends = 0;
        for (int x = 0; x < bar.width(); ++x) {
            const QRgb pixel = bar.pixel(x, 7 + 22 + 6);
            ends += distance(pixel, colourOf(divergingMap().back()).rgb()) < 12;
        }
        QVERIFY(ends > 3);
    }

    void theLegendInACornerGrowsUntilItsWordsFit() {
        ColourLegend legend{Overlay::Strain, {-0.05, 0.05}};
        const QFont font = options(ViewsShown::Pattern).font;
        const QFontMetrics metrics(font);
        const int least = legendHeight(font, LegendShape::Corner);
        const int words = metrics.horizontalAdvance(legend.meaning());
        QCOMPARE(cornerLegendHeight(legend, font, 3 * words), least);
        QCOMPARE(cornerLegendHeight(legend, font, words + 30), least + metrics.height());
        QCOMPARE(cornerLegendHeight(legend, font, 3 * words / 4), least + 2 * metrics.height());
        QCOMPARE(cornerLegendHeight(legend, font, words / 4), least + 2 * metrics.height());
        legend.isMissing = true;  // says in place of colours what is to be done
        QCOMPARE(cornerLegendHeight(legend, font, words), least);
        const int narrow = 60;
        const int lines = metrics.horizontalAdvance(legend.meaning()) / narrow;
        QVERIFY(cornerLegendHeight(legend, font, narrow) > lines * metrics.height());
    }

    void everySizeIsDrawnAsItIs_data() {
        QTest::addColumn<QSize>("size");
        for (const QSize size : {QSize(16, 16), QSize(17, 300), QSize(300, 16), QSize(2000, 33)}) {
            QTest::addRow("%d x %d", size.width(), size.height()) << size;
        }
    }

    void everySizeIsDrawnAsItIs() {
        QFETCH(QSize, size);
        openStretched(0.1);
        document().setView(&ViewState::rulers, true);
        document().setView(&ViewState::worstSpots, true);
        document().setOverlay(Overlay::Strain);
        PictureOptions asked = options(ViewsShown::Both, size);
        asked.legend = true;
        QCOMPARE(draw(asked).size(), size);
    }

    void tooLargeIsASentence() {
        openStretched(0.1);
        QString problem;
        QVERIFY(drawViews(document(), options(ViewsShown::Garment, QSize(200000, 16)), problem)
                    .isNull());
        QVERIFY2(problem.contains("200000 x 16"), qPrintable(problem));
    }

    void drawnTwiceIsTheSameToTheBit() {
        openFlattened(test::makeSewnCap());
        document().setOverlay(Overlay::Strain);
        document().setView(&ViewState::worstSpots, true);
        PictureOptions asked = options(ViewsShown::Both);
        asked.legend = true;
        QByteArray files[2];
        for (QByteArray& file : files) {
            QBuffer buffer(&file);
            QVERIFY(buffer.open(QIODevice::WriteOnly));
            QVERIFY(draw(asked).save(&buffer, "PNG"));
        }
        QVERIFY(!files[0].isEmpty());
        QCOMPARE(files[0], files[1]);
    }

    void isThePictureOfTheWindow() {
        test::WindowFixture fixture;
        fixture.open({1440, 900});
        const QString file = fixture.path("cap.obj");
        test::writeObj(file.toStdString(), test::sewnCapParts());
        QVERIFY(fixture.openAndWait(file));
        PictureOptions asked;
        asked.legend = false;
        asked.font = QApplication::font();
        asked.palette = QApplication::palette();
        for (int overlay = 0; overlay < kOverlayCount; ++overlay) {
            fixture.document().setOverlay(static_cast<Overlay>(overlay));
            QTRY_VERIFY_WITH_TIMEOUT(fixture.window().views().isUpToDate(), kPatience);
            for (const ViewsShown view : {ViewsShown::Garment, ViewsShown::Pattern}) {
                const QImage grabbed = view == ViewsShown::Garment ? fixture.garmentPicture()
                                                                   : fixture.patternPicture();
                init();  // grabbing has let go of the context
                asked.views = view;
                asked.size = grabbed.size();
                QString problem;
                const QImage drawn = drawViews(fixture.document(), asked, problem);
                keep(drawn, QString("%1-%2-drawn").arg(overlay).arg(int(view)));
                keep(grabbed, QString("%1-%2-grabbed").arg(overlay).arg(int(view)));
                const double share = differing(drawn, grabbed);
                QVERIFY2(share < kSamePicture,
                         qPrintable(QString("%1: %2").arg(overlay).arg(share)));
            }
        }
    }

    void isTheSameWithoutADisplay() {
        openFlattened(test::makeSewnCap());
        document().setOverlay(Overlay::Strain);
        const QImage withDisplay = draw(ViewsShown::Both);
        context_.reset();
        context_ = makeEglContext();
        if (!context_) {
            QSKIP("no driver here draws without a display");
        }
        QVERIFY(!QOpenGLContext::currentContext());
        const QImage without = draw(ViewsShown::Both);
        keep(withDisplay, "with-display");
        keep(without, "without-display");
        const double share = differing(withDisplay, without);
        QVERIFY2(share < kSamePicture, qPrintable(QString::number(share)));
        QString problem;
        context_.reset();
        QVERIFY(!hasGl());
        QVERIFY(drawViews(document(), options(ViewsShown::Garment), problem).isNull());
        QVERIFY2(problem.contains("OpenGL 3.3"), qPrintable(problem));
    }

private:
    /// For a person to look at, where TOILE_PICTURES names a folder.
    static void keep(const QImage& image, const QString& name) {
        if (const QString folder = qEnvironmentVariable("TOILE_PICTURES"); !folder.isEmpty()) {
            image.save(folder + '/' + name + ".png");
        }
    }
};

TOILE_WINDOW_TEST(PictureTest)
#include "picture_test.moc"
