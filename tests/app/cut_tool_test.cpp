// SPDX-License-Identifier: GPL-3.0-or-later
// The cut tool, with mouse and keys, in both views.
#include <cmath>
#include <cstdlib>

#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/tool_bench.h"

using namespace toile;
using namespace toile::app;

using test::click;
using test::doubleClick;
using test::drag;
using test::moveTo;

class CutToolTest : public test::ToolBench {
    Q_OBJECT

private slots:
    void aSheetIsCutAcross_data() {
        QTest::addColumn<bool>("inPattern");
        QTest::newRow("garment view, double click") << false;
        QTest::newRow("pattern view, Enter") << true;
    }

    void aSheetIsCutAcross() {
        QFETCH(bool, inPattern);
        openSheets();
        const test::Moment start = test::momentOf(document());
        SceneView& view = inPattern ? patternView() : garmentView();
        tools().choose(ToolId::Cut);
        view.setFocus();
        const QString idle = hint();
        click(view, at(view, 0, {0, 77, 0}));
        QVERIFY(hint() != idle);
        QCOMPARE(pathTool().draft().points().size(), std::size_t{1});
        QCOMPARE(pathTool().draft().points()[0].on, ClothPoint::On::Rim);
        const QPointF end = at(view, 0, {kWidth, 77, 0});
        if (inPattern) {
            click(view, end);
            QTest::keyClick(&view, Qt::Key_Return);
        } else {
            doubleClick(view, end);
        }
        QVERIFY(pathTool().draft().isEmpty());
        QVERIFY(waitForPieces(3));
        const Garment& garment = *document().garment();
        QCOMPARE(garment.cuts.size(), std::size_t{1});
        QCOMPARE(garment.cuts[0].name, std::string("cut 1"));
        QVERIFY(std::abs(garment.cuts[0].length - kWidth) < 0.5);
        QCOMPARE(garment.pieces[0]->name, std::string("sheet 1"));
        QCOMPARE(garment.pieces[1]->name, std::string("sheet 2"));
        QCOMPARE(garment.pieces[2], start.derived.garment->pieces[1]);  // untouched
        QCOMPARE(document().history().undoText(), QString("Cut sheet"));
        QVERIFY(said().isEmpty());
        document().history().undo();
        QVERIFY(test::momentOf(document()) == start);
        document().history().redo();
        QVERIFY(waitForPieces(3));
    }

    void theWayIsShownBeforeItIsCut() {
        openSheets();
        tools().choose(ToolId::Cut);
        click(garmentView(), at(garmentView(), 0, {0, 40, 0}));
        moveTo(garmentView(), at(garmentView(), 0, {123, 104, 0}));
        QVERIFY(QTest::qWaitFor([this] { return pathTool().draft().length().has_value(); },
                                test::kPatience));
        QVERIFY(std::abs(*pathTool().draft().length() - std::hypot(123, 64)) < 1.5);
        const QImage shown = garmentView().grabFramebuffer();
        QTest::keyClick(&garmentView(), Qt::Key_Escape);
        QVERIFY(pathTool().draft().isEmpty());
        QVERIFY(garmentView().grabFramebuffer() != shown);
    }

    void escapeThrowsTheCutAwayAndThenTheTool() {
        openSheets();
        const test::Moment start = test::momentOf(document());
        tools().choose(ToolId::Cut);
        click(patternView(), at(patternView(), 0, {20, 20, 0}));
        click(patternView(), at(patternView(), 0, {60, 20, 0}));
        QTest::keyClick(&patternView(), Qt::Key_Escape);
        QVERIFY(pathTool().draft().isEmpty());
        QCOMPARE(tools().current().id(), ToolId::Cut);
        QTest::keyClick(&patternView(), Qt::Key_Escape);
        QCOMPARE(tools().current().id(), ToolId::Select);
        QVERIFY(test::momentOf(document()) == start);
        QCOMPARE(document().history().count(), 0);
    }

    void backspaceTakesTheLastPointBack() {
        openSheets();
        tools().choose(ToolId::Cut);
        SceneView& view = garmentView();
        for (const double x : {20.0, 60.0, 100.0}) {
            click(view, at(view, 0, {x, 33, 0}));
        }
        QCOMPARE(pathTool().draft().points().size(), std::size_t{3});
        QTest::keyClick(&view, Qt::Key_Backspace);
        QCOMPARE(pathTool().draft().points().size(), std::size_t{2});
        QTest::keyClick(&view, Qt::Key_Backspace);
        QTest::keyClick(&view, Qt::Key_Return);  // one point is no cut
        QCOMPARE(pathTool().draft().points().size(), std::size_t{1});
        QTest::keyClick(&view, Qt::Key_Backspace);
        QVERIFY(pathTool().draft().isEmpty());
        QCOMPARE(document().history().count(), 0);
    }

    void aCutStaysOnOnePiece() {
        openSheets();
        tools().choose(ToolId::Cut);
        click(garmentView(), at(garmentView(), 0, {50, 33, 0}));
        click(garmentView(), at(garmentView(), 1, {325, 25, 0}));
        QCOMPARE(pathTool().draft().points().size(), std::size_t{1});
        click(patternView(), at(patternView(), 0, {90, 33, 0}));  // the other view goes on with it
        QCOMPARE(pathTool().draft().points().size(), std::size_t{2});
    }

    void thePointerIsDrawnToCornersAndEdges() {
        openSheets();
        tools().choose(ToolId::Cut);
        SceneView& view = patternView();
        click(view, at(view, 0, {0, 0, 0}) + QPointF(5, -4));
        QCOMPARE(pathTool().draft().points()[0].on, ClothPoint::On::Corner);
        const QPointF left = at(view, 0, {0, 77, 0});
        const double outward = at(view, 0, {20, 77, 0}).x() > left.x() ? -5 : 5;
        click(view, left + QPointF(outward, 0));  // beside the cloth
        QCOMPARE(pathTool().draft().points()[1].on, ClothPoint::On::Rim);
        click(view, at(view, 0, {100, 77, 0}));
        QCOMPARE(pathTool().draft().points()[2].on, ClothPoint::On::Cloth);
        click(view, at(view, 0, {100, 77, 0}) + QPointF(3, 3));  // the same again: nothing new
        QCOMPARE(pathTool().draft().points().size(), std::size_t{3});
    }

    void ctrlCutsAlongEdges() {
        openSheets();
        tools().choose(ToolId::Cut);
        SceneView& view = garmentView();
        click(view, at(view, 0, {0, 51, 0}), Qt::ControlModifier);
        click(view, at(view, 0, {kWidth, 51, 0}), Qt::ControlModifier);
        QTest::keyClick(&view, Qt::Key_Return);
        QVERIFY(waitForPieces(3));
        QVERIFY(document().loading().seams.cuts.at(0).alongEdges);
        QVERIFY(std::abs(document().garment()->cuts[0].length - kWidth) < 1e-6);
    }

    void aCutThatOpensNothingIsRefused() {
        openSheets();
        const test::Moment start = test::momentOf(document());
        tools().choose(ToolId::Cut);
        SceneView& view = garmentView();
        click(view, at(view, 0, {31, 0, 0}));
        click(view, at(view, 0, {117, 0, 0}));
        QTest::keyClick(&view, Qt::Key_Return);
        QVERIFY(QTest::qWaitFor([this] { return !said().isEmpty(); }, test::kPatience));
        QVERIFY(said().contains("cut 1"));
        QVERIFY(test::momentOf(document()) == start);
        QCOMPARE(document().history().count(), 0);
        QVERIFY(fixture_.workspace().loading().seams.cuts.empty());
        QVERIFY(!fixture_.document().history().canUndo());
        // The next one has the name that was not used up.
        click(view, at(view, 0, {0, 77, 0}));
        doubleClick(view, at(view, 0, {kWidth, 77, 0}));
        QVERIFY(waitForPieces(3));
        QCOMPARE(document().garment()->cuts[0].name, std::string("cut 1"));
        QVERIFY(said().isEmpty());
    }

    void clothOnItsWayIsNotCut() {
        openSheets();
        tools().choose(ToolId::Cut);
        GarmentView& view = fixture_.garmentView();
        view.setMorph(0.5);
        click(view, at(view, 0, {0, 0, 0}));
        QVERIFY(pathTool().draft().isEmpty());
        view.setMorph(1);
        click(view, at(view, 0, {0, 0, 0}));
        QCOMPARE(pathTool().draft().points().size(), std::size_t{1});
    }

    void aRefusedPlaceDoesNotFinishTheCut() {
        openSheets();
        const auto before = document().garment();
        tools().choose(ToolId::Cut);
        click(garmentView(), at(garmentView(), 0, {0, 40, 0}));
        click(garmentView(), at(garmentView(), 0, {kWidth, 40, 0}));
        doubleClick(garmentView(), at(garmentView(), 1, {325, 25, 0}));  // another piece
        doubleClick(patternView(), {3, 3});                              // no cloth at all
        QCOMPARE(pathTool().draft().points().size(), std::size_t{2});
        QVERIFY(!fixture_.workspace().jobs().isBusy());
        doubleClick(garmentView(), at(garmentView(), 0, {kWidth, 40, 0}));  // the last one again
        QVERIFY(waitForPieces(3));
    }

    void enterBeforeTheWayIsKnownCutsAroundAnEarlierCut() {
        openSheets();
        tools().choose(ToolId::Dart);
        drag(garmentView(), at(garmentView(), 0, {103, 0, 0}), at(garmentView(), 0, {103, 62, 0}));
        QVERIFY(QTest::qWaitFor([this] { return document().garment()->cuts.size() == 1; },
                                test::kPatience));
        QVERIFY(waitForPieces(2));
        tools().choose(ToolId::Cut);
        click(garmentView(), at(garmentView(), 0, {31, 33, 0}));
        click(garmentView(), at(garmentView(), 0, {171, 33, 0}));
        QTest::keyClick(&garmentView(), Qt::Key_Return);  // at once
        QVERIFY(QTest::qWaitFor([this] { return pathTool().draft().isEmpty(); }, test::kPatience));
        const auto& cuts = fixture_.workspace().loading().seams.cuts;
        QCOMPARE(cuts.size(), std::size_t{2});
        QVERIFY2(cuts[1].points.size() > 2, "it bends around the dart's tip");
    }
};

TOILE_WINDOW_TEST(CutToolTest)
#include "cut_tool_test.moc"
