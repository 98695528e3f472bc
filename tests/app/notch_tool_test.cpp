// SPDX-License-Identifier: GPL-3.0-or-later
// Notches by hand: real clicks, drags and keys in both views, and what the pattern has then.
#include "app/views/tools/notch_tool.h"

#include <QLineF>
#include <algorithm>
#include <cmath>

#include "app/document/layout.h"
#include "core/pattern/walk.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/tool_bench.h"

using namespace toile;
using namespace toile::app;

using test::click;
using test::drag;
using test::moveTo;

class NotchToolTest : public test::ToolBench {
    Q_OBJECT

private:
    const LineSettings& lines() { return document().state().lines; }
    int steps() { return document().history().index(); }
    const NotchTool& notchTool() { return dynamic_cast<const NotchTool&>(tools().current()); }
    std::vector<SeamNotch> notches() { return notchesOf(*document().derived().pattern); }

    /// Of the sewn seam, on a side: 0 left, 1 right.
    QPointF onSide(SceneView& view, int side, double share) {
        const Seam& seam = document().garment()->seams.seams[static_cast<std::size_t>(*sewn())];
        const SeamSide& on = side == 0 ? seam.left : seam.right;
        const SeamMatch at = placeAtShare(seam, share);
        const double arc = side == 0 ? at.left : at.right;
        return *view.onSeam(*sewn(), side, (arc - on.start) / (on.end - on.start));
    }

    bool isDone() {
        return QTest::qWaitFor([this] { return document().isFlattened(); }, kPatience) &&
               fixture_.waitForResults();
    }

    /// The one whose reason is the person; its share.
    double byHand() {
        const auto all = notches();
        const auto found = std::ranges::find_if(
            all, [](const SeamNotch& notch) { return notch.reason == NotchReason::ByHand; });
        return found == all.end() ? -1 : found->share;
    }

    void begin() {
        openCap();
        fixture_.action(ActionId::ToolNotch).trigger();
        QCOMPARE(tools().current().id(), ToolId::Notch);
    }

    void addAt(SceneView& view, double share) {
        click(view, onSide(view, 0, share));
        QVERIFY(isDone());
    }

    static constexpr int kPatience = test::kPatience;

private slots:
    void aClickAddsANotchOnBothSides_data() {
        QTest::addColumn<bool>("inPattern");
        QTest::newRow("garment view") << false;
        QTest::newRow("pattern view") << true;
    }

    void aClickAddsANotchOnBothSides() {
        QFETCH(bool, inPattern);
        begin();
        SceneView& view = inPattern ? patternView() : garmentView();
        addAt(view, 0.33);
        QCOMPARE(steps(), 1);
        QCOMPARE(document().history().undoText(), QString("Add notch"));
        QVERIFY(std::abs(byHand() - 0.33) < 0.01);
        for (const PatternPiece& piece : document().derived().pattern->pieces) {
            QVERIFY(std::ranges::any_of(piece.notches, [](const PieceNotch& notch) {
                return notch.reason == NotchReason::ByHand;
            }));
        }
        QVERIFY(notchTool().selected());
        // Beside the seams nothing is added.
        click(view, {3, 3});
        QCOMPARE(steps(), 1);
        QVERIFY(!notchTool().selected());
        document().history().undo();
        QVERIFY(isDone());
        QVERIFY(notches().empty() && lines() == LineSettings{});
    }

    void aDragMovesItOnBothSidesInOneStep() {
        begin();
        for (SceneView* view : {&patternView(), &garmentView()}) {
            addAt(*view, 0.33);
            const int before = steps();
            const QPointF from = onSide(*view, 1, byHand()), to = onSide(*view, 1, 0.41);
            drag(*view, from, to);
            QCOMPARE(steps(), before + 1);
            QCOMPARE(document().history().undoText(), QString("Move notch"));
            QVERIFY(isDone());
            QVERIFY2(std::abs(byHand() - 0.41) < 0.01, qPrintable(QString::number(byHand())));
            QCOMPARE(lines().notches->notches.size(), std::size_t(1));
            QTest::keyClick(view, Qt::Key_Delete);
            QVERIFY(isDone());
            QCOMPARE(byHand(), -1.0);
        }
    }

    void escapeTakesADragBack() {
        begin();
        addAt(patternView(), 0.33);
        const QPointF from = onSide(patternView(), 0, byHand());
        const auto send = [this](QEvent::Type type, const QPointF& at, Qt::MouseButton button) {
            test::sendMouse(patternView(), type, at, button, Qt::LeftButton);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton);
        send(QEvent::MouseMove, onSide(patternView(), 0, 0.45), Qt::NoButton);
        const QImage dragged = fixture_.patternPicture();
        QTest::keyClick(&patternView(), Qt::Key_Escape);
        QVERIFY(fixture_.patternPicture() != dragged);  // the preview is gone
        test::sendMouse(patternView(), QEvent::MouseButtonRelease, from, Qt::LeftButton,
                        Qt::NoButton);
        QCOMPARE(steps(), 1);
        QCOMPARE(tools().current().id(), ToolId::Notch);
        QTest::keyClick(&patternView(), Qt::Key_Escape);
        QCOMPARE(tools().current().id(), ToolId::Select);
    }

    void controlAndDeleteTakeNotchesAway() {
        begin();
        addAt(patternView(), 0.33);
        const std::size_t count = notches().size();
        QVERIFY(count > 1);  // and those that come by themselves
        click(patternView(), onSide(patternView(), 0, byHand()), Qt::ControlModifier);
        QVERIFY(isDone());
        QCOMPARE(byHand(), -1.0);
        QVERIFY(lines().notches->notches.empty());
        // One that nobody has placed: under the pointer, by its key.
        const SeamNotch notch = notches().front();
        moveTo(patternView(), onSide(patternView(), 0, notch.share));
        QTest::keyClick(&patternView(), Qt::Key_Delete);
        QVERIFY(isDone());
        QCOMPARE(document().history().undoText(), QString("Delete notch"));
        QCOMPARE(notches().size(), count - 2);
        QVERIFY(!lines().notches->notches.at(0).isThere);
        document().history().undo();
        QVERIFY(isDone());
        QCOMPARE(notches().size(), count - 1);
    }

    void aNotchIsTakenByItsMarkOnTheAllowanceToo() {
        begin();
        LineSettings wide = lines();
        wide.allowance = AllowanceWidths{40, 40};
        document().setLines(wide, "Allowance");
        QVERIFY(isDone());
        patternView().frameAll();
        (void)fixture_.patternPicture();
        addAt(patternView(), 0.33);
        const VertexRun stroke = [this] {
            const auto& scene = *document().scene();
            const QPointF at = onSide(patternView(), 0, byHand());
            return *std::ranges::min_element(
                scene.patternLines.notches, {},
                [&](const VertexRun& run) { return QLineF(at, onScreen(run)).length(); });
        }();
        const QPointF mark = onScreen(stroke);
        QVERIFY(QLineF(mark, onSide(patternView(), 0, byHand())).length() > 12);
        click(patternView(), mark, Qt::ControlModifier);
        QVERIFY(isDone());
        QCOMPARE(byHand(), -1.0);
    }

private:
    /// Where a stroke begins, on the cutting line.
    QPointF onScreen(const VertexRun& stroke) {
        const LineVertex& vertex = document().scene()->lineVertices[stroke.first];
        const Placement placement = placementOf(document(), static_cast<int>(vertex.piece));
        return SheetMap(patternView())(placement.applied(flatPoint(vertex)));
    }
};

TOILE_WINDOW_TEST(NotchToolTest)
#include "notch_tool_test.moc"
