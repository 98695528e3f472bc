// SPDX-License-Identifier: GPL-3.0-or-later
// One selection for both views, with a real pointer; and what the garment view can show besides.
#include <QSlider>
#include <cmath>
#include <numbers>

#include "app/render/render_style.h"
#include "app/render/scene_renderer.h"
#include "app/views/feature_text.h"
#include "app/views/tools/tool_box.h"
#include "app/views/way_bars.h"
#include "tests/app/support/pointer_bench.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;
using test::countPixels;
using test::kHighlight;

class HoverTest : public test::PointerBench {
    Q_OBJECT

private slots:
    void aSeamUnderThePointerLightsUpInBothViews() {
        const int seam = firstSeam();
        QCOMPARE(highlightedInGarment() + highlightedInPattern(), 0);
        moveTo(patternView(), onPatternSeam(seam, 1));
        QVERIFY(document().hover());
        QCOMPARE(document().hover()->seam, seam);
        QVERIFY(highlightedInPattern() > 100);  // both edges
        QVERIFY(highlightedInGarment() > 50);
        leave(patternView());
        QVERIFY(!document().hover());
        QCOMPARE(highlightedInGarment() + highlightedInPattern(), 0);

        moveTo(garmentView(), onGarmentSeam(seam));
        QVERIFY(document().hover());
        QCOMPARE(document().hover()->seam, seam);
        QVERIFY(highlightedInPattern() > 100);
        leave(garmentView());
    }

    void aClickTakesTheSeamADoubleClickTheStretchBetweenCorners() {
        const int seam = firstSeam();
        const QPointF at = onPatternSeam(seam, 0);
        click(patternView(), at);
        QCOMPARE(document().seam(), std::optional(seam));
        QVERIFY(document().selection().empty());
        QTest::mouseDClick(&patternView(), Qt::LeftButton, {}, at.toPoint());
        QTest::mouseRelease(&patternView(), Qt::LeftButton, {}, at.toPoint());
        QVERIFY(document().mark());
        QCOMPARE(document().mark()->kind, Feature::Kind::Run);
        QVERIFY(document().mark()->count > 0);
        leave(patternView());
        // With its partner, in both views, and how long they are.
        const QImage pattern = fixture_.patternPicture(), garment = fixture_.garmentPicture();
        const auto isLit = [](const QImage& image, const QPointF& place) {
            const QRect around = QRect(place.toPoint() - QPoint(5, 5), QSize(11, 11));
            return countPixels(image.copy(around), kHighlight, 40) > 0;
        };
        QVERIFY(isLit(pattern, onPatternSeam(seam, 0)));
        QVERIFY(isLit(pattern, onPatternSeam(seam, 1)));
        QVERIFY(isLit(garment, onGarmentSeam(seam)));
        const QString told = markedText(document());
        QVERIFY2(told.contains("from corner to corner") && told.contains(" mm, Δ "),
                 qPrintable(told));
        QVERIFY(fixture_.find<QLabel>("toolHint").text().startsWith(told));
        QVERIFY(highlightedInGarment() > 50);
        QVERIFY(highlightedInPattern() > 50);
        click(patternView(), onPatternPiece(0));
        QVERIFY(!document().mark());
        QCOMPARE(document().selection(), Document::Selection{0});
        const int steps = document().history().count();
        QCOMPARE(steps, 0);  // none of this is an edit
    }

    void escapeSelectsNothing() {
        const auto press = [&] { QTest::keyClick(&patternView(), Qt::Key_Escape); };
        click(patternView(), onPatternPiece(0));
        QVERIFY(!document().selection().empty());
        press();
        QVERIFY(document().selection().empty());
        const QPointF at = onPatternSeam(firstSeam(), 0);
        click(patternView(), at);
        QVERIFY(document().seam());
        press();
        QVERIFY(!document().seam());
        QTest::mouseDClick(&patternView(), Qt::LeftButton, {}, at.toPoint());
        QTest::mouseRelease(&patternView(), Qt::LeftButton, {}, at.toPoint());
        QVERIFY(document().mark());
        press();
        QVERIFY(!document().mark() && !document().seam());
        QVERIFY(fixture_.find<QLabel>("toolHint").text().contains("Esc: clear the selection"));

        // While something runs the key is for that.
        document().setSelection({0});
        const Tool& tool = fixture_.window().tools().current();
        const QKeyEvent key(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QVERIFY(tool.wants(key));
        fixture_.action(ActionId::FlattenAgain).trigger();
        if (fixture_.workspace().jobs().isBusy()) {
            QVERIFY(!tool.wants(key));
        }
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().selection(), Document::Selection{0});
    }

    void seamLinesCanBeHidden() {
        const QImage with = fixture_.patternPicture();
        fixture_.action(ActionId::ShowSeams).trigger();
        const QImage without = fixture_.patternPicture();
        QVERIFY(with != without);
        QVERIFY(!document().view().seams);
        fixture_.action(ActionId::ShowSeams).trigger();
        QCOMPARE(fixture_.patternPicture(), with);
    }

    void xrayShowsTheSeamBehindTheCloth() {
        // From behind, with the cap between the eye and what is drawn on its other side.
        garmentView().look(ViewKey::Top);
        const QImage before = fixture_.garmentPicture();
        QTest::keyClick(&fixture_.window(), Qt::Key_X);
        QVERIFY(document().view().xray);
        const QImage through = fixture_.garmentPicture();
        const auto seamPixels = [&](const QImage& image) {
            const int colour = static_cast<int>(
                scene()
                    .lineVertices[scene().garmentLines.seams[std::size_t(firstSeam())][0].first]
                    .tint);
            const Rgb rgb = seamPalette()[std::size_t(colour)];
            return countPixels(image, QColor(rgb.r, rgb.g, rgb.b), 12);
        };
        QVERIFY2(seamPixels(through) >= seamPixels(before), "no line is lost");
        QVERIFY(through != before);
    }

    void numberPadTurnsTheGarment() {
        const auto& camera = garmentView().camera();
        QTest::keyClick(&garmentView(), Qt::Key_1, Qt::KeypadModifier);
        QCOMPARE(camera.yaw(), 0.0);
        QCOMPARE(camera.pitch(), 0.0);
        QTest::keyClick(&garmentView(), Qt::Key_3, Qt::KeypadModifier);
        QVERIFY(std::abs(camera.yaw() - std::numbers::pi / 2) < 1e-9);
        QTest::keyClick(&garmentView(), Qt::Key_9, Qt::KeypadModifier);
        QVERIFY(std::abs(camera.yaw() + std::numbers::pi / 2) < 1e-9);
        QTest::keyClick(&garmentView(), Qt::Key_5, Qt::KeypadModifier);
        QVERIFY(camera.isOrthographic());
        QVERIFY(fixture_.action(ActionId::Orthographic).isChecked());
        // What is drawn without perspective is found without it too.
        const QPointF middle = garmentView().rect().center();
        QCOMPARE(garmentView().hitAt(middle).has_value(), true);
    }

    void aClickOnTheCrossTurnsTheGarment() {
        garmentView().look(ViewKey::Right);
        // Straight ahead now lies the ball of the x axis; to its left that of the z axis.
        const QPointF cross(14 + 31.5, garmentView().height() - 14 - 31.5);
        click(garmentView(), cross - QPointF(24, 0));
        QCOMPARE(garmentView().camera().yaw(), 0.0);
        QVERIFY(document().selection().empty());
    }

    void twoQuickClicksOnTheCrossFrameNothing() {
        const QPointF cross(14 + 31.5, garmentView().height() - 14 - 31.5);
        zoomIn(garmentView(), 4);
        garmentView().look(ViewKey::Right);
        (void)fixture_.garmentPicture();
        const double distance = garmentView().camera().distance();
        const QPoint ball = (cross - QPointF(24, 0)).toPoint();
        QTest::mouseDClick(&garmentView(), Qt::LeftButton, {}, ball);
        QTest::mouseRelease(&garmentView(), Qt::LeftButton, {}, ball);
        (void)fixture_.garmentPicture();
        QCOMPARE(garmentView().camera().distance(), distance);
        QCOMPARE(garmentView().camera().yaw(), 0.0);
    }

    void aPieceOrAVertexTakesTheSeamsPlace() {
        click(patternView(), onPatternSeam(firstSeam(), 0));
        QVERIFY(document().seam());
        click(patternView(), onPatternPiece(0));
        QVERIFY(!document().seam());
        QCOMPARE(document().selection(), Document::Selection{0});
    }

    void hoverEvaluatesNoAction() {
        const auto evaluations = [this] { return fixture_.window().actions().evaluations(); };
        const int before = evaluations();
        moveTo(patternView(), onPatternPiece(0));
        QVERIFY(document().hover());
        moveTo(patternView(), onPatternSeam(firstSeam(), 0));
        leave(patternView());
        QVERIFY(!document().hover());
        QCOMPARE(evaluations(), before);
        document().setSelection({0});
        const int selected = evaluations() - before;
        QVERIFY(selected > 0);
        // Fewer than when all are evaluated, as after a job.
        fixture_.window().actions().followEnabled(fixture_.workspace());
        QVERIFY(evaluations() - before - selected > selected);
    }

    void theMorphLeavesACameraThatWasMoved() {
        zoomIn(garmentView(), 5);
        const double distance = garmentView().camera().distance();
        for (const double way : {0.3, 0.9, 1.0, 0.0}) {
            garmentView().setMorph(way);
            QCOMPARE(garmentView().camera().distance(), distance);
        }
    }

    void theEyeStopsBeforeTheCloth() {
        zoomIn(garmentView(), 120);
        const QPointF middle = garmentView().rect().center();
        const auto hit = garmentView().hitAt(middle);
        QVERIFY(hit);
        QVERIFY(hit->distance > 2e-3 * scene().box.diagonal().norm());
        QVERIFY(garmentView().camera().distance() > 0);
    }

    void theSliderEndsAtTheFlatPattern() {
        auto& slider = fixture_.find<QSlider>("morphSlider");
        QVERIFY(slider.isVisible());
        const QImage worn = fixture_.garmentPicture();
        const int uploads = garmentView().renderer().meshUploads();
        slider.setFocus();
        QTest::keyClick(&slider, Qt::Key_End);
        QCOMPARE(garmentView().morph(), 1.0);
        const QImage flat = fixture_.garmentPicture();
        QVERIFY(flat != worn);
        // Every piece is where the sheet has it: a place of the flat piece projects as the whole
        // sheet does, at one scale.
        const auto onScreen = [&](int piece, int face) -> QPointF {
            return *garmentView().onScreen(piece, face, Eigen::Vector3d(1, 0, 0));
        };
        const auto onSheet = [&](int piece, int face) -> QPointF {
            return *patternView().onScreen(piece, face, Eigen::Vector3d(1, 0, 0));
        };
        const QPointF a = onScreen(0, 0), b = onScreen(1, 5), c = onScreen(1, 30);
        const QPointF sheetA = onSheet(0, 0), sheetB = onSheet(1, 5), sheetC = onSheet(1, 30);
        const double scale = QLineF(a, b).length() / QLineF(sheetA, sheetB).length();
        QVERIFY(std::abs(QLineF(a, c).length() - scale * QLineF(sheetA, sheetC).length()) < 0.5);
        QVERIFY(std::abs(QLineF(a, b).angleTo(QLineF(sheetA, sheetB))) < 0.1 ||
                std::abs(QLineF(a, b).angleTo(QLineF(sheetA, sheetB)) - 360) < 0.1);
        // The cloth answers there too.
        QVERIFY(
            garmentView().hitAt(*garmentView().onScreen(1, 5, Eigen::Vector3d::Constant(1.0 / 3))));
        QCOMPARE(garmentView().renderer().meshUploads(), uploads);
        QTest::keyClick(&slider, Qt::Key_Home);
        QCOMPARE(fixture_.garmentPicture(), worn);
    }

    void theSlidersGrooveGoesToTheClick() {
        auto& slider = fixture_.find<QSlider>("morphSlider");
        const auto at = [&](double share) {
            return QPoint(qRound(share * slider.width()), slider.height() / 2);
        };
        QTest::mousePress(&slider, Qt::LeftButton, {}, at(0.75));
        QVERIFY(std::abs(garmentView().morph() - 0.75) < 0.04);
        QVERIFY(slider.isSliderDown());  // and can be dragged on
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, at(0.75));
        QVERIFY(std::abs(garmentView().morph() - 0.75) < 0.04);
        QTest::mouseClick(&slider, Qt::LeftButton, {}, at(0.25));
        QVERIFY(std::abs(garmentView().morph() - 0.25) < 0.04);
        QVERIFY(!slider.isSliderDown());
    }

    void playGoesThereByItself() {
        fixture_.action(ActionId::PlayMorph).trigger();
        QVERIFY(QTest::qWaitFor([&] { return garmentView().morph() == 1.0; }, 20000));
        fixture_.action(ActionId::PlayMorph).trigger();
        QVERIFY(QTest::qWaitFor([&] { return garmentView().morph() == 0.0; }, 20000));
    }
};

TOILE_WINDOW_TEST(HoverTest)
#include "hover_test.moc"
