// SPDX-License-Identifier: GPL-3.0-or-later
// The two views side by side, with real mouse and keys: choosing, looking, overlays.
#include <QItemSelectionModel>
#include <QLabel>
#include <QTreeView>
#include <algorithm>

#include "app/render/scene.h"
#include "app/render/scene_renderer.h"
#include "app/views/colour_bar.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/pair_bench.h"
#include "tests/app/support/pixels.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

class ViewsTest : public test::PairBench {
    Q_OBJECT

private slots:
    void clickingAPieceInEitherViewSelectsItEverywhere() {
        QVERIFY(openPair());
        auto& table = fixture_.find<QTreeView>("pieceTable");
        const QColor selection = renderStyle(window().palette()).selection;
        const int before3d = test::countPixels(fixture_.garmentPicture(), selection, 24);
        const int before2d = test::countPixels(fixture_.patternPicture(), selection, 24);

        QTest::mouseClick(&garmentView(), Qt::LeftButton, {}, onGarment(1).toPoint());
        QCOMPARE(document().selection(), Document::Selection{1});
        QCOMPARE(table.selectionModel()->selectedRows().size(), 1);
        QCOMPARE(table.selectionModel()->selectedRows().front().row(), 1);
        QVERIFY(fixture_.find<QLabel>("pieceDetails").text().contains("cap"));
        QTRY_VERIFY_WITH_TIMEOUT(
            test::countPixels(fixture_.garmentPicture(), selection, 24) > before3d + 200,
            test::kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(
            test::countPixels(fixture_.patternPicture(), selection, 24) > before2d + 200,
            test::kPatience);

        QTest::mouseClick(&patternView(), Qt::LeftButton, {}, onPattern(0).toPoint());
        QCOMPARE(document().selection(), Document::Selection{0});
        QTest::mouseClick(&patternView(), Qt::LeftButton, Qt::ControlModifier,
                          onPattern(1).toPoint());
        QCOMPARE(document().selection(), (Document::Selection{0, 1}));
        QTest::mouseClick(&patternView(), Qt::LeftButton, {}, QPoint(3, 3));
        QVERIFY(document().selection().empty());
    }

    void keysSwitchTheOverlays() {
        QVERIFY(openPair());
        const auto& legend = fixture_.find<ColourBar>("colourBar");
        const QImage checker = fixture_.patternPicture();
        const std::pair<Qt::Key, Overlay> keys[] = {{Qt::Key_1, Overlay::None},
                                                    {Qt::Key_3, Overlay::Area},
                                                    {Qt::Key_4, Overlay::Angle},
                                                    {Qt::Key_5, Overlay::Strain},
                                                    {Qt::Key_2, Overlay::Checker}};
        QString last = legend.summary();
        for (const auto& [key, overlay] : keys) {
            QTest::keyClick(&garmentView(), key);
            QCOMPARE(document().view().overlay, overlay);
            QVERIFY(legend.summary() != last);
            last = legend.summary();
            QCOMPARE(fixture_.patternPicture() == checker, overlay == Overlay::Checker);
        }
        QTest::keyClick(&garmentView(), Qt::Key_W);
        QVERIFY(document().view().wireframe);
    }

    void wheelZoomsToTheCursor() {
        QVERIFY(openPair());
        const Camera2D& sheet = patternView().camera();
        const Eigen::Vector2d before = sheet.toWorld(100, 140);
        const double scale = sheet.pixelsPerMillimetre();
        test::turnWheel(patternView(), {100, 140}, 3);
        QVERIFY(sheet.pixelsPerMillimetre() > 1.3 * scale);
        QVERIFY((sheet.toWorld(100, 140) - before).norm() < 1e-6);

        const QPointF cap = onGarment(1);
        const double distance = garmentView().camera().distance();
        test::turnWheel(garmentView(), cap, 2);
        QVERIFY(garmentView().camera().distance() < distance);
        // The middle of the cap's box lies behind its surface, so it drifts, but hardly.
        QVERIFY(QLineF(onGarment(1), cap).length() < 12);
    }

    void dragTurnsTheGarmentAndMovesTheSheet() {
        QVERIFY(openPair());
        const auto& camera = garmentView().camera();
        const Eigen::Vector3d point(0, 0, 80);
        for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton}) {
            const Eigen::Vector2d before = camera.project(point);
            test::drag(garmentView(), {200, 200}, {290, 180}, button);
            QVERIFY((camera.project(point) - before).norm() > 5);
        }
        const double distance = camera.distance();
        const Eigen::Vector3d middle = camera.pointAtTargetDepth(200, 200);
        test::drag(garmentView(), {200, 200}, {240, 230}, Qt::MiddleButton, Qt::ShiftModifier);
        QVERIFY((camera.project(middle) - Eigen::Vector2d(240, 230)).norm() < 1e-6);
        QCOMPARE(camera.distance(), distance);
        QVERIFY(document().selection().empty());  // a drag is no click

        const Camera2D& sheet = patternView().camera();
        const Eigen::Vector2d corner = sheet.toWorld(50, 50);
        test::drag(patternView(), {50, 50}, {90, 20}, Qt::MiddleButton);
        QVERIFY((sheet.toScreen(corner) - Eigen::Vector2d(90, 20)).norm() < 1e-6);

        QTest::keyClick(&patternView(), Qt::Key_F);
        (void)fixture_.patternPicture();
        const auto box = sheetBox(*document().scene(), placesOf(document().settings()));
        QVERIFY(sheet.visible().contains(box));
    }

    void doubleClickFramesThePiece() {
        QVERIFY(openPair());
        const double scale = patternView().camera().pixelsPerMillimetre();
        test::doubleClick(patternView(), onPattern(1));
        QVERIFY(patternView().camera().pixelsPerMillimetre() > 1.2 * scale);
        QCOMPARE(document().selection(), Document::Selection{1});
    }

    void checkerboardIsTrueToScaleInThePattern() {
        QVERIFY(openPair());
        test::doubleClick(patternView(), onPattern(0));
        document().setSelection({});
        const QImage image = fixture_.patternPicture();
        const auto& camera = patternView().camera();
        const auto& piece = document().scene()->pieces[0];
        const double squarePixels = 10 * camera.pixelsPerMillimetre() * image.devicePixelRatio();
        // Along a line across the piece, a little above its lower edge, away from the name and the
        // grain arrow.
        const double y = piece.flatBox.min().y() + 12;
        const Eigen::Vector2d from =
            camera.toScreen(placement(0).applied({piece.flatBox.min().x() + 15, y}));
        const Eigen::Vector2d to =
            camera.toScreen(placement(0).applied({piece.flatBox.max().x() - 15, y}));
        const int row = qRound(from.y() * image.devicePixelRatio());
        int least = 255, largest = 0, changes = 0;
        bool wasLight = false, first = true;
        const int begin = qRound(from.x() * image.devicePixelRatio());
        const int end = qRound(to.x() * image.devicePixelRatio());
        for (int x = begin; x <= end; ++x) {
            const int lightness = qGray(image.pixel(x, row));
            least = std::min(least, lightness);
            largest = std::max(largest, lightness);
        }
        for (int x = begin; x <= end; ++x) {
            const bool light = qGray(image.pixel(x, row)) > (least + largest) / 2;
            changes += !first && light != wasLight;
            wasLight = light;
            first = false;
        }
        QVERIFY2(largest - least > 40, "squares stand out from each other");
        const double squares = (end - begin) / squarePixels;
        QVERIFY2(std::abs(changes - squares) <= 1.5,
                 qPrintable(QString("%1 changes on %2 squares").arg(changes).arg(squares)));
    }

    void garmentShowsTheCheckerboardToo() {
        QVERIFY(openPair());
        const QImage checker = fixture_.garmentPicture();
        document().setOverlay(Overlay::None);
        const QImage plain = fixture_.garmentPicture();
        int differing = 0;
        for (int y = 0; y < plain.height(); ++y) {
            for (int x = 0; x < plain.width(); ++x) {
                differing += std::abs(qGray(plain.pixel(x, y)) - qGray(checker.pixel(x, y))) > 12;
            }
        }
        QVERIFY(differing > 5000);
    }

    void movingTheCameraUploadsNothing() {
        QVERIFY(openPair());
        const int uploads = garmentView().renderer().meshUploads();
        test::drag(garmentView(), {200, 200}, {260, 240}, Qt::LeftButton);
        document().setOverlay(Overlay::Strain);
        document().setSelection({1});
        document().setView(&ViewState::wireframe, true);
        (void)fixture_.garmentPicture();
        QCOMPARE(garmentView().renderer().meshUploads(), uploads);
    }
};

TOILE_WINDOW_TEST(ViewsTest)
#include "views_test.moc"
