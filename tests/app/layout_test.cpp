// SPDX-License-Identifier: GPL-3.0-or-later
// The pattern view as a place to lay out: keys, typed numbers and actions, and what they leave on
// the sheet, in the history and in the files.
#include "app/document/layout.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QRegularExpression>
#include <cmath>
#include <numbers>

#include "tests/app/support/run_test.h"
#include "tests/app/support/sheet_bench.h"

using namespace toile;
using namespace toile::app;

namespace {

constexpr double kQuarterTurn = std::numbers::pi / 2;

}  // namespace

class LayoutTest : public test::SheetBench {
    Q_OBJECT

private slots:
    void arrowKeysNudge() {
        document().setSelection({0, 1});
        const Eigen::Vector2d a = placement(0).offset, b = placement(1).offset;
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_Right);
        QTest::keyClick(&view(), Qt::Key_Up, Qt::ShiftModifier);
        QVERIFY((placement(0).offset - a - Eigen::Vector2d(1, 10)).norm() < 1e-12);
        QVERIFY((placement(1).offset - b - Eigen::Vector2d(1, 10)).norm() < 1e-12);
        QCOMPARE(steps(), 2);
        document().setSelection({});
        QTest::keyClick(&view(), Qt::Key_Right);
        QCOMPARE(steps(), 2);
    }

    void arrowKeysNudgeFromTheGarmentViewToo() {
        document().setSelection({1});
        const Placement was = placement(1);
        auto& garmentView = fixture_.garmentView();
        garmentView.setFocus();
        QTest::keyClick(&garmentView, Qt::Key_Right);
        QVERIFY((placement(1).offset - was.offset - Eigen::Vector2d(1, 0)).norm() < 1e-9);
    }

    void actionsTurnAndMirrorTogether() {
        document().setSelection({0, 1});
        const Eigen::AlignedBox2d before = boxOnSheet(document(), {0, 1});
        const double turn = placement(0).turn;
        QTest::keyClick(&view(), Qt::Key_BracketLeft);
        QVERIFY(std::abs(wrappedAngle(placement(0).turn - turn - kQuarterTurn)) < 1e-12);
        const Eigen::AlignedBox2d turned = boxOnSheet(document(), {0, 1});
        QVERIFY((turned.center() - before.center()).norm() < 1e-9);
        QVERIFY(std::abs(turned.sizes().x() - before.sizes().y()) < 1e-9);
        QTest::keyClick(&view(), Qt::Key_BracketRight);
        QVERIFY((boxOnSheet(document(), {0, 1}).min() - before.min()).norm() < 1e-9);
        action(ActionId::MirrorLeftRight).trigger();
        QVERIFY(placement(0).mirrored && placement(1).mirrored && !placement(2).mirrored);
        QVERIFY((boxOnSheet(document(), {0, 1}).min() - before.min()).norm() < 1e-9);
        action(ActionId::MirrorUpsideDown).trigger();
        QVERIFY(!placement(0).mirrored);
        QVERIFY(std::abs(std::abs(wrappedAngle(placement(0).turn - turn)) - std::numbers::pi) <
                1e-9);
    }

    void numbersCanBeTyped() {
        document().setSelection({1});
        type("positionX", "250");
        type("positionY", "-40.5");
        QVERIFY((box(1).min() - Eigen::Vector2d(250, -40.5)).norm() < 1e-9);
        const Eigen::Vector2d middle = box(1).center();
        type("positionAngle", "30");
        QVERIFY(std::abs(placement(1).turn - std::numbers::pi / 6) < 1e-12);
        QVERIFY((box(1).center() - middle).norm() < 5);
        type("positionGrain", "60");
        QVERIFY(std::abs(directionOnSheet(placement(1), *document().settings()[1].grain) -
                         std::numbers::pi / 3) < 1e-12);
        auto& mirrored = fixture_.find<QCheckBox>("positionMirrored");
        mirrored.click();
        QVERIFY(placement(1).mirrored);
        QCOMPARE(steps(), 5);
        document().setSelection({0, 1});
        QCOMPARE(mirrored.checkState(), Qt::PartiallyChecked);
        QCOMPARE(fixture_.find<QLineEdit>("pieceName").placeholderText(), QString("2 pieces"));
        type("positionAngle", "45");
        QVERIFY(std::abs(placement(0).turn - std::numbers::pi / 4) < 1e-12);
        QVERIFY(std::abs(placement(1).turn - std::numbers::pi / 4) < 1e-12);
        document().setSelection({});
        QVERIFY(!fixture_.find<QDoubleSpinBox>("positionX").isEnabled());
        action(ActionId::GoToPosition).trigger();
        QVERIFY(!fixture_.find<QWidget>("propertiesDock").isHidden());
    }

    void piecesLineUpAndKeepTheirDistance() {
        document().setSelection({0, 1, 2});
        action(ActionId::AlignBottom).trigger();
        QVERIFY(std::abs(box(0).min().y() - box(1).min().y()) < 1e-9);
        QVERIFY(std::abs(box(2).min().y() - box(1).min().y()) < 1e-9);
        action(ActionId::AlignCentre).trigger();
        QVERIFY(std::abs(box(2).center().x() - box(1).center().x()) < 1e-9);
        // What a person has put somewhere stays; what the program lays out may make room.
        QVERIFY(document().settings()[1].placedByHand);
        action(ActionId::LayOutAgain).trigger();
        for (int i = 0; i < 3; ++i) {
            QVERIFY(!document().settings()[static_cast<std::size_t>(i)].placedByHand);
            for (int k = 0; k < i; ++k) {
                QVERIFY(!box(i).intersects(box(k)));
            }
        }
        action(ActionId::DistributeAcross).trigger();
        document().setSelection({0});
        QVERIFY(!action(ActionId::AlignLeft).isEnabled());
        // One piece alone goes beside the others.
        const Placement was = placement(1);
        action(ActionId::LayOutAgain).trigger();
        QVERIFY(box(0).min().x() > std::max(box(1).max().x(), box(2).max().x()));
        QVERIFY(placement(1) == was);
    }

    void piecesLaidOutAgainKeepToTheCloth() {
        double widest = 0, together = 0;
        for (int i = 0; i < 3; ++i) {
            widest = std::max(widest, box(i).sizes().x());
            together += box(i).sizes().x();
        }
        document().setSelection({});
        for (const double width : {widest + 1, together + 100}) {
            type("fabricWidth", QString::number(std::ceil(width)));
            action(ActionId::LayOutAgain).trigger();
            QVERIFY(boxOnSheet(document(), {0, 1, 2}).sizes().x() <= document().fabric().width);
            QCOMPARE(document().fabric().width, std::ceil(width));
        }
    }

    void theExportFollowsTheLayout() {
        document().setSelection({2});
        type("positionX", "500");
        type("positionY", "700");
        type("positionAngle", "30");
        action(ActionId::MirrorLeftRight).trigger();
        type("positionGrain", "90");
        const QString path = fixture_.path("out.svg");
        fixture_.workspace().exportTo(path.toStdString());
        QTRY_VERIFY_WITH_TIMEOUT(!fixture_.workspace().writing().isBusy(), test::kPatience);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString svg = QString::fromUtf8(file.readAll());
        QVERIFY(svg.contains("wrong side of the fabric up"));
        QVERIFY(svg.contains("piece-sheet--grain"));
        const auto boxIn = [&svg](const QString& id) {
            const QRegularExpression outline("id=\"" + id + "\"[^>]* d=\"M ([^\"]+) Z\"");
            Eigen::AlignedBox2d box;
            const QString data = outline.match(svg).captured(1).remove('L');
            for (const QString& pair : data.split(' ', Qt::SkipEmptyParts)) {
                const QStringList xy = pair.split(',');
                box.extend(Eigen::Vector2d(xy[0].toDouble(), -xy[1].toDouble()));
            }
            return box;
        };
        const Eigen::AlignedBox2d one = boxIn("piece-sheet-cut"), two = boxIn("piece-left-cut");
        QVERIFY(!one.isEmpty() && !two.isEmpty());
        const Eigen::Vector2d should = box(2).min() - box(0).min();
        QVERIFY(((one.min() - two.min()) - should).norm() < 3e-4);
        QVERIFY((one.sizes() - box(2).sizes()).norm() < 3e-4);
    }

    void aSecondFlatteningLeavesPiecesWhereTheyAre() {
        drag(on(0), on(0) + QPointF(50, 50));
        const Placement was = placement(0);
        action(ActionId::FlattenAgain).trigger();
        QVERIFY(fixture_.waitForResults());
        QVERIFY((placement(0).offset - was.offset).norm() < 1e-6);
        QCOMPARE(steps(), 1);
    }

    void aStepBackToBeforeTheResultsBringsThemAgain() {
        fixture_.workspace().setMethod(Method::Lscm);
        place(document(), "Test", {{0, Placement{{5, 5}}}});
        QVERIFY(fixture_.waitForResults());
        QVERIFY(document().isFlattened());
        action(ActionId::Undo).trigger();
        QVERIFY(QTest::qWaitFor(
            [this] { return !fixture_.workspace().jobs().isBusy() && document().isFlattened(); },
            test::kPatience));
    }
};

TOILE_WINDOW_TEST(LayoutTest)
#include "layout_test.moc"
