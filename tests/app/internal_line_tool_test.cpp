// SPDX-License-Identifier: GPL-3.0-or-later
// Internal lines by hand: real clicks, drags and keys in both views, and what the pattern has then.
#include "app/views/tools/internal_line_tool.h"

#include <cmath>

#include "core/pattern/internal_lines.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/tool_bench.h"

using namespace toile;
using namespace toile::app;

using test::click;
using test::doubleClick;
using test::drag;
using test::moveTo;

class InternalLineToolTest : public test::ToolBench {
    Q_OBJECT

private:
    const std::vector<InternalLine>& lines() { return document().state().lines.internalLines; }
    int steps() { return document().history().index(); }
    const InternalLineTool& tool() {
        return dynamic_cast<const InternalLineTool&>(tools().current());
    }
    const std::vector<PieceInternal>& drawn(std::size_t piece = 0) {
        return document().derived().pattern->pieces[piece].internals;
    }

    bool isDone() {
        return QTest::qWaitFor([this] { return document().isFlattened(); }, test::kPatience) &&
               fixture_.waitForResults();
    }

    void begin() {
        openSheets();
        fixture_.action(ActionId::ToolInternalLine).trigger();
        QCOMPARE(tools().current().id(), ToolId::InternalLine);
    }

    /// From (41, 42) to (161, 102), by Enter.
    void drawLine(SceneView& view) {
        click(view, at(view, 0, {41, 42, 0}));
        click(view, at(view, 0, {161, 102, 0}));
        view.setFocus();
        QTest::keyClick(&view, Qt::Key_Return);
        QVERIFY(isDone());
    }

private slots:
    void aLineIsDrawnInEitherView_data() {
        QTest::addColumn<bool>("inPattern");
        QTest::newRow("garment view") << false;
        QTest::newRow("pattern view") << true;
    }

    void aLineIsDrawnInEitherView() {
        QFETCH(bool, inPattern);
        begin();
        SceneView& view = inPattern ? patternView() : garmentView();
        const QString idle = hint();
        click(view, at(view, 0, {41, 42, 0}));
        QVERIFY(hint() != idle);
        QTest::keyClick(&view, Qt::Key_Escape);
        QCOMPARE(hint(), idle);
        QCOMPARE(steps(), 0);
        drawLine(view);
        QCOMPARE(steps(), 1);
        QCOMPARE(document().history().undoText(), QString("Add internal line"));
        QCOMPARE(lines().size(), std::size_t{1});
        QVERIFY(!lines()[0].closed);
        QCOMPARE(drawn().size(), std::size_t{1});
        QVERIFY(std::abs(drawn()[0].length - std::hypot(120, 60)) < 1.5);
        QCOMPARE(drawn()[0].points.rows(), Eigen::Index{2});
        QVERIFY(!document().scene()->garmentLines.internal.empty());
        QVERIFY(!document().scene()->patternLines.internal.empty());
        QVERIFY(tool().selected().has_value());
        document().history().undo();
        QVERIFY(isDone());
        QVERIFY(lines().empty() && drawn().empty());
        QVERIFY(!tool().selected());
        document().history().redo();
        QVERIFY(isDone());
        QCOMPARE(drawn().size(), std::size_t{1});
    }

    void onePlaceIsADrillPointAndTheFirstPlaceCloses() {
        begin();
        click(patternView(), at(patternView(), 0, {101, 43, 0}));
        QTest::keyClick(&patternView(), Qt::Key_Return);
        QVERIFY(isDone());
        QCOMPARE(lines().at(0).points.size(), std::size_t{1});
        QVERIFY(isDrillPoint(drawn().at(0)));
        for (const Eigen::Vector3d& place :
             {Eigen::Vector3d(41, 62, 0), Eigen::Vector3d(121, 62, 0), Eigen::Vector3d(81, 112, 0),
              Eigen::Vector3d(41, 62, 0)}) {
            click(garmentView(), at(garmentView(), 0, place));
        }
        QVERIFY(isDone());
        QCOMPARE(lines().size(), std::size_t{2});
        QVERIFY(lines()[1].closed);
        QCOMPARE(lines()[1].points.size(), std::size_t{3});
        QVERIFY(drawn().at(1).closed);
        // A place is taken back; another piece is refused; a double click ends.
        click(patternView(), at(patternView(), 0, {21, 22, 0}));
        click(patternView(), at(patternView(), 0, {61, 22, 0}));
        QTest::keyClick(&patternView(), Qt::Key_Backspace);
        click(patternView(), at(patternView(), 1, {326, 27, 0}));
        QCOMPARE(pathTool().draft().points().size(), std::size_t{1});
        doubleClick(patternView(), at(patternView(), 0, {151, 22, 0}));
        QVERIFY(isDone());
        QCOMPARE(lines().at(2).points.size(), std::size_t{2});
        QVERIFY(std::abs(drawn().at(2).length - 130) < 1.5);
    }

    void aLineIsSelectedMovedAndTakenAway() {
        begin();
        for (SceneView* view : {&patternView(), &garmentView()}) {
            drawLine(*view);
            const int before = steps();
            click(*view, at(*view, 0, {191, 12, 0}));  // a place beside it, thrown away
            QVERIFY(!tool().selected());
            QTest::keyClick(view, Qt::Key_Escape);
            const QImage plain = view->grabFramebuffer();
            click(*view, at(*view, 0, {101, 72, 0}));
            QVERIFY(tool().selected().has_value());
            QVERIFY(view->grabFramebuffer() != plain);
            QVERIFY(pathTool().draft().isEmpty());
            drag(*view, at(*view, 0, {161, 102, 0}), at(*view, 0, {161, 42, 0}));
            QVERIFY(isDone());
            QCOMPARE(steps(), before + 1);
            QCOMPARE(document().history().undoText(), QString("Move internal line"));
            QVERIFY(std::abs(drawn().at(0).length - 120) < 1.5);
            QTest::keyClick(view, Qt::Key_Delete);
            QVERIFY(isDone());
            QCOMPARE(document().history().undoText(), QString("Delete internal line"));
            QVERIFY(lines().empty() && drawn().empty());
        }
    }

    void escapeTakesADragBack() {
        begin();
        drawLine(patternView());
        const auto send = [this](QEvent::Type type, const QPointF& at, Qt::MouseButton button) {
            test::sendMouse(patternView(), type, at, button, Qt::LeftButton);
        };
        const QPointF from = at(patternView(), 0, {161, 102, 0});
        send(QEvent::MouseButtonPress, from, Qt::LeftButton);
        send(QEvent::MouseMove, at(patternView(), 0, {161, 42, 0}), Qt::NoButton);
        QTest::keyClick(&patternView(), Qt::Key_Escape);
        test::sendMouse(patternView(), QEvent::MouseButtonRelease, from, Qt::LeftButton,
                        Qt::NoButton);
        QCOMPARE(steps(), 1);
        QCOMPARE(tools().current().id(), ToolId::InternalLine);
        QTest::keyClick(&patternView(), Qt::Key_Escape);
        QCOMPARE(tools().current().id(), ToolId::Select);
    }

    void theLayerHidesThemAndACutPartsThem() {
        begin();
        drawLine(patternView());
        fixture_.action(ActionId::ToolSelect).trigger();
        for (SceneView* view : {&patternView(), &garmentView()}) {
            const QImage shown = view->grabFramebuffer();
            fixture_.action(ActionId::InternalLines).trigger();
            QVERIFY(!document().view().internalLines);
            QVERIFY(view->grabFramebuffer() != shown);
            fixture_.action(ActionId::InternalLines).trigger();
            QVERIFY(view->grabFramebuffer() == shown);
        }
        const double length = drawn().at(0).length;
        tools().choose(ToolId::Cut);
        click(garmentView(), at(garmentView(), 0, {0, 77, 0}));
        click(garmentView(), at(garmentView(), 0, {kWidth, 77, 0}));
        QTest::keyClick(&garmentView(), Qt::Key_Return);
        QVERIFY(waitForPieces(3));
        QVERIFY(isDone());
        QCOMPARE(drawn(0).size(), std::size_t{1});
        QCOMPARE(drawn(1).size(), std::size_t{1});
        QVERIFY(std::abs(drawn(0)[0].length + drawn(1)[0].length - length) < 1e-3);
    }
};

TOILE_WINDOW_TEST(InternalLineToolTest)
#include "internal_line_tool_test.moc"
