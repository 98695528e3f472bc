// SPDX-License-Identifier: GPL-3.0-or-later
// The selection tool on the sheet: moving, turning, boxes, and how a gesture ends.
#include <cmath>
#include <numbers>

#include "app/document/document.h"
#include "app/render/pattern_renderer.h"
#include "app/views/tools/tool_paint.h"
#include "core/layout/snapping.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/sheet_bench.h"

using namespace toile;
using namespace toile::app;

namespace {

constexpr double kSquare = std::numbers::pi / 2;

}  // namespace

class SelectToolTest : public test::SheetBench {
    Q_OBJECT

private slots:
    void aDragMovesThePieceAsOneStep() {
        const int uploads = view().renderer().meshUploads();
        const Placement was = placement(0), other = placement(1);
        drag(on(0), on(0) + QPointF(60, -45));
        (void)fixture_.patternPicture();
        QCOMPARE(steps(), 1);
        const Eigen::Vector2d way = placement(0).offset - was.offset;
        const double scale = view().pixelsPerMillimetre();
        QVERIFY((way * scale - Eigen::Vector2d(60, 45)).norm() < 1e-6);
        QCOMPARE(placement(0).turn, was.turn);
        QVERIFY(placement(1) == other);
        QCOMPARE(document().selection(), Document::Selection{0});
        QCOMPARE(view().renderer().meshUploads(), uploads);
        QCOMPARE(document().history().undoText(), "Move " + pieceName(document(), 0));
        action(ActionId::Undo).trigger();
        QVERIFY(placement(0) == was);
        QCOMPARE(steps(), 0);
        action(ActionId::Redo).trigger();
        QVERIFY((placement(0).offset - was.offset - way).norm() < 1e-12);
    }

    void allSelectedMoveTogether() {
        document().setSelection({0, 2});
        const Eigen::Vector2d a = placement(0).offset, b = placement(1).offset,
                              c = placement(2).offset;
        drag(on(2), on(2) + QPointF(30, 10));
        QVERIFY((placement(0).offset - a).norm() > 1);
        QVERIFY((placement(0).offset - a - (placement(2).offset - c)).norm() < 1e-9);
        QCOMPARE((placement(1).offset - b).norm(), 0.0);
        QCOMPARE(document().selection(), (Document::Selection{0, 2}));
        QCOMPARE(steps(), 1);
        QCOMPARE(document().history().undoText(), QString("Move 2 pieces"));
    }

    void escapeTakesADragBackWithoutAStep() {
        const Placement was = placement(1);
        const QPointF from = on(1);
        view().setFocus();
        press(from);
        move(from + QPointF(40, 0));
        QVERIFY(!(placement(1) == was));
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(placement(1) == was);
        release(from + QPointF(40, 0));
        QCOMPARE(steps(), 0);
    }

    void noShortcutActsInADrag() {
        const Placement was = placement(1);
        view().setFocus();
        press(on(1));
        move(on(1) + QPointF(40, 0));
        QTest::keyClick(&view(), Qt::Key_H);
        QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier);
        QTest::keyClick(&view(), Qt::Key_G);
        QVERIFY(!placement(1).mirrored);
        QVERIFY(!(placement(1) == was));
        release(on(1));
        QCOMPARE(steps(), 1);
        QVERIFY(action(ActionId::ToolSelect).isChecked());
    }

    void aReleaseThatNeverComesEndsTheDrag_data() {
        QTest::addColumn<bool>("byFocus");
        QTest::newRow("the pointer moves without a button") << false;
        QTest::newRow("a dialog takes the keyboard") << true;
    }

    void aReleaseThatNeverComesEndsTheDrag() {
        QFETCH(bool, byFocus);
        const Placement was = placement(1);
        const QPointF from = on(1);
        press(from);
        move(from + QPointF(40, 0));
        QVERIFY(!(placement(1) == was));
        if (byFocus) {
            QFocusEvent out(QEvent::FocusOut, Qt::ActiveWindowFocusReason);
            QApplication::sendEvent(&view(), &out);
        } else {
            test::moveTo(view(), from + QPointF(50, 0));
        }
        QVERIFY(placement(1) == was);
        move(from + QPointF(60, 0));  // the button is still down, say
        QVERIFY(placement(1) == was);
        QCOMPARE(steps(), 0);
        release(from + QPointF(60, 0));
        drag(on(1), on(1) + QPointF(30, 0));  // and the next press is one
        QCOMPARE(steps(), 1);
    }

    void aDragRightAfterAClickMoves() {
        const Placement was = placement(1);
        const QPointF from = on(1);
        press(from);
        release(from);
        const double scale = view().pixelsPerMillimetre();
        test::sendMouse(view(), QEvent::MouseButtonDblClick, from, Qt::LeftButton, Qt::LeftButton);
        move(from + QPointF(25, 0));
        move(from + QPointF(50, 0));
        release(from + QPointF(50, 0));
        (void)fixture_.patternPicture();
        QCOMPARE(view().pixelsPerMillimetre(), scale);  // nothing is framed
        QVERIFY(std::abs((placement(1).offset - was.offset).x() * scale - 50) < 1e-6);
        QCOMPARE(steps(), 1);
    }

    void aClickSelectsAndLeavesNoStep() {
        QTest::mouseClick(&view(), Qt::LeftButton, {}, on(1).toPoint());
        QCOMPARE(document().selection(), Document::Selection{1});
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::ControlModifier, on(0).toPoint());
        QCOMPARE(document().selection(), (Document::Selection{0, 1}));
        QTest::mouseClick(&view(), Qt::LeftButton, {},
                          (onScreen(box(0).min()) + QPointF(-12, 12)).toPoint());
        QVERIFY(document().selection().empty());
        QCOMPARE(steps(), 0);
    }

    void aBoxOnTheSheetSelects() {
        const Eigen::AlignedBox2d one = box(0), two = box(2);
        drag(onScreen(one.min()) + QPointF(-4, 4), onScreen(one.center()));
        QCOMPARE(document().selection(), Document::Selection{0});
        const QPointF corner =
            onScreen(Eigen::Vector2d(two.max().x(), two.min().y())) + QPointF(4, 4);
        drag(corner, onScreen(two.center()), Qt::ShiftModifier);
        QCOMPARE(document().selection(), (Document::Selection{0, 2}));
        drag(corner, onScreen(two.center()));
        QCOMPARE(document().selection(), Document::Selection{2});
        QCOMPARE(steps(), 0);
    }

    void aBoxTakesOnlyWhatItTouches() {
        turnTogether(document(), "Turn", {2}, kSquare / 2);
        frameAll();
        // The corner of the box around a sheet that stands on its corner is empty.
        const QPointF corner = onScreen(box(2).min());
        drag(corner + QPointF(-3, 3), corner + QPointF(8, -8));
        QVERIFY(document().selection().empty());
        drag(corner + QPointF(-3, 3), onScreen(box(2).center()));
        QCOMPARE(document().selection(), Document::Selection{2});
    }

    void spaceAndTheOtherButtonsMoveTheView() {
        const Placement was = placement(0);
        const QPointF from = on(0), to = from + QPointF(35, 20);
        const Eigen::Vector2d under = view().onSheet(from);
        view().setFocus();
        QTest::keyPress(&view(), Qt::Key_Space);
        drag(from, to);
        QTest::keyRelease(&view(), Qt::Key_Space);
        QVERIFY((view().onSheet(to) - under).norm() < 1e-6);
        QVERIFY(placement(0) == was);
        drag(to, to + QPointF(20, 0));
        QVERIFY(!(placement(0) == was));
    }

    void movingCatchesAtOtherPieces() {
        // Piece 2 below piece 0, its left edge a little off.
        PiecePlacements near;
        near[2] = movedBy(placement(2), box(0).min() - box(2).min() + Eigen::Vector2d(1.5, -300));
        place(document(), "Test", near);
        frameAll();
        document().setView(&ViewState::snapping, true);
        const double scale = view().pixelsPerMillimetre();
        const double target = box(0).min().x();
        drag(on(2), on(2) + QPointF(4 - 1.5 * scale, 14));
        QVERIFY(std::abs(box(2).min().x() - target) < 1e-9);
        // Alt turns it off.
        drag(on(2), on(2) + QPointF(5, 14), Qt::AltModifier);
        QVERIFY(std::abs((box(2).min().x() - target) * scale - 5) < 1e-6);
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_S);
        QVERIFY(!document().view().snapping);
    }

    void theHandleTurnsAboutTheMiddle() {
        document().setSelection({2});
        const Eigen::Vector2d middle = box(2).center();
        const auto handle = turnHandle(document(), view());
        QVERIFY(handle);
        QVERIFY(handle->y() < onScreen(box(2).max()).y());
        const QPointF centre = onScreen(middle);
        const double reach = centre.y() - handle->y();
        drag(*handle, centre + QPointF(reach, 0));  // from twelve to three o'clock
        QVERIFY(std::abs(placement(2).turn + kSquare) < 1e-9);
        QVERIFY((box(2).center() - middle).norm() < 1e-9);
        QCOMPARE(steps(), 1);
        action(ActionId::Undo).trigger();
        // 50 degrees become 45 with Shift.
        const double angle = 50 * std::numbers::pi / 180;
        drag(*handle, centre - reach * QPointF(std::sin(angle), std::cos(angle)),
             Qt::ShiftModifier);
        QVERIFY(std::abs(placement(2).turn - std::numbers::pi / 4) < 1e-9);
    }

    void turningCatchesAtRightAngles() {
        document().setView(&ViewState::snapping, true);
        document().setSelection({2});
        const QPointF centre = onScreen(box(2).center());
        const auto handle = turnHandle(document(), view());
        const double reach = centre.y() - handle->y();
        const double angle = 88.5 * std::numbers::pi / 180;
        drag(*handle, centre - reach * QPointF(std::sin(angle), std::cos(angle)));
        // Its straight edges lie along the sheet, or it is turned by a right angle itself.
        const double turned = std::remainder(
            directionOnSheet(placement(2), straightDirections(flatOutline(document(), 2)).front()),
            kSquare);
        const double whole = std::remainder(placement(2).turn, kSquare);
        QVERIFY(std::min(std::abs(turned), std::abs(whole)) < 1e-9);
    }
};

TOILE_WINDOW_TEST(SelectToolTest)
#include "select_tool_test.moc"
