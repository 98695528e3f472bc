// SPDX-License-Identifier: GPL-3.0-or-later
// The arrow of the grain, and what turns with it.
#include <cmath>
#include <numbers>

#include "app/document/document.h"
#include "app/views/grain_arrow.h"
#include "app/widgets/banner.h"
#include "core/formats/drawing/drawing.h"
#include "core/toile/pipeline.h"
#include "core/toile/toile.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/sheet_bench.h"

using namespace toile;
using namespace toile::app;

namespace {

constexpr double kRightAngle = std::numbers::pi / 2;

}  // namespace

class GrainToolTest : public test::SheetBench {
    Q_OBJECT

private slots:
    void theGrainTurnsWithItsArrow() {
        QTest::keyClick(&view(), Qt::Key_G);
        QVERIFY(action(ActionId::ToolGrain).isChecked());
        const auto arrow = grainArrow(document(), 0, view().camera().pixelsPerMillimetre());
        QVERIFY(arrow);
        QVERIFY((arrow->direction - Eigen::Vector2d(0, 1)).norm() < 1e-12);
        const QPointF middle = onScreen(arrow->middle), tip = onScreen(arrow->end(0.45));
        const double reach = middle.y() - tip.y();
        QVERIFY(reach > 10);
        const auto away = [reach](const QPointF& from, double angle) {
            return from + reach * QPointF(std::cos(angle), -std::sin(angle));
        };
        const double angle = 70 * std::numbers::pi / 180;
        // As long as it is held it turns about its middle, on the way too.
        press(tip);
        move(away(middle, 1.0));
        QVERIFY(std::abs(*document().settings()[0].grain - 1.0) < 1e-9);
        move(away(middle, angle));
        release(away(middle, angle));
        QVERIFY(std::abs(*document().settings()[0].grain - angle) < 1e-9);
        QCOMPARE(steps(), 1);
        document().setView(&ViewState::snapping, true);
        const QPointF now =
            onScreen(grainArrow(document(), 0, view().camera().pixelsPerMillimetre())->middle);
        const double nearly = 46.5 * std::numbers::pi / 180;
        drag(away(now, angle), away(now, nearly));
        QVERIFY(std::abs(*document().settings()[0].grain - std::numbers::pi / 4) < 1e-9);
        // The piece turns so that its grain runs upwards.
        action(ActionId::ToolSelect).trigger();
        document().setSelection({0});
        action(ActionId::GrainUpwards).trigger();
        QVERIFY(std::abs(directionOnSheet(placement(0), *document().settings()[0].grain) -
                         kRightAngle) < 1e-9);
        const QString name = pieceName(document(), 0);
        QCOMPARE(document().history().undoText(), "Turn grain of " + name + " upwards");
        action(ActionId::ResetGrain).trigger();
        QVERIFY(!document().settings()[0].grain);
        QVERIFY(document().history().undoText().contains("grain of " + name, Qt::CaseInsensitive));
    }

    void escapeTakesTheGrainBack() {
        action(ActionId::ToolGrain).trigger();
        const QPointF tip =
            onScreen(grainArrow(document(), 1, view().camera().pixelsPerMillimetre())->end(0.45));
        view().setFocus();
        press(tip);
        move(tip + QPointF(60, 30));
        QVERIFY(document().settings()[1].grain);
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(!document().settings()[1].grain);
        release(tip);
        QCOMPARE(steps(), 0);
    }

    void aNarrowPieceHasAnArrowInItsMiddleToo() {
        test::writeObj(fixture_.path("band.obj").toStdString(),
                       {{"band", test::makeSheet(600, 12, 60, 2)},
                        {"sheet", test::makeSheet(600, 500, 6, 5, {0, 100, 0})}});
        QVERIFY(fixture_.openAndWait(fixture_.path("band.obj")));
        frameAll();
        const double scale = view().camera().pixelsPerMillimetre();
        const auto arrow = grainArrow(document(), 0, scale);
        QVERIFY(arrow);
        QVERIFY(arrow->length * scale >= 16 - 1e-9);
        QVERIFY2(arrow->length > 12, "longer than the band is wide");
        // Where there is most room, as that of the files is too short to be seen; names keep off.
        QVERIFY(std::abs(arrow->middle.y() - box(0).center().y()) < 1);
        QVERIFY(box(0).contains(arrow->middle));
        // It is there to be seen: dark strokes on a light halo.
        document().setOverlay(Overlay::None);
        const QImage image = fixture_.patternPicture();
        const double ratio = image.devicePixelRatio();
        const QPoint at = (onScreen(arrow->end(0.5)) * ratio).toPoint();
        int darkest = 255;
        for (int y = 0; y < 8; ++y) {
            darkest = std::min(darkest, qGray(image.pixel(at + QPoint(0, y))));
        }
        QVERIFY2(darkest < 90, qPrintable(QString::number(darkest)));
        // Its end lies beside the cloth and is grabbed all the same.
        QTest::keyClick(&view(), Qt::Key_G);
        const QPointF middle = onScreen(arrow->middle), tip = onScreen(arrow->end(0.45));
        QVERIFY(!box(0).contains(arrow->end(0.45)));
        drag(tip, middle + QPointF(middle.y() - tip.y(), 0));
        QVERIFY(document().settings()[0].grain);
        QVERIFY(std::abs(*document().settings()[0].grain) < 1e-6);
        QVERIFY(box(0).contains(grainArrow(document(), 0, scale)->middle));
    }

    /// What is seen on the sheet is what is cut: names and grain lines lie where files have them.
    void namesAndArrowsLieWhereFilesHaveThem() {
        setGrain(document(), "Grain", {{0, 0.3}, {1, 2.0}, {2, kRightAngle}});
        turnTogether(document(), "Turn", {0}, 0.5);
        mirrorTogether(document(), "Mirror", {1}, Mirroring::LeftRight);
        const LaidOutPattern laid = makePattern(*document().garment(), document().results(),
                                                {.pieces = document().settings()})
                                        .laid;
        const Drawing drawing = draw(laid.pattern, laid.marker);
        int lines = 0;
        for (int i = 0; i < document().pieceCount(); ++i) {
            const auto at = static_cast<std::size_t>(i);
            const Eigen::Vector2d shift = placement(i).offset -
                                          laid.marker.copies[at].placement.offset -
                                          Eigen::Vector2d(10, 10);  // the margin
            const std::string id = "piece-" + laid.pattern.pieces[at].slug;
            for (const DrawnText& text : drawing.texts) {
                const auto& label = document().marks().of(document(), i, {}).label;
                QVERIFY(text.id != id + "-name" ||
                        (text.position + shift - placement(i).offset - label.position).norm() <
                            1e-6);
            }
            for (const DrawnPath& path : drawing.paths) {
                if (path.id == id + "--grain") {
                    const auto arrow = grainArrow(document(), i, 1e6);
                    const auto off = [&](int end, double share) {
                        return (path.points.row(end).transpose() + shift - arrow->end(share))
                            .norm();
                    };
                    QVERIFY2(off(0, -0.5) < 1e-6 && off(1, 0.5) < 1e-6, id.c_str());
                    ++lines;
                }
            }
        }
        QCOMPARE(lines, 3);
    }

    void aPieceThatGoesWhileItsGrainIsTurnedIsLetGo() {
        action(ActionId::ToolGrain).trigger();
        const QPointF tip =
            onScreen(grainArrow(document(), 1, view().camera().pixelsPerMillimetre())->end(0.45));
        press(tip);
        move(tip + QPointF(60, 30));
        auto garment = std::make_shared<Garment>(*document().garment());
        garment->pieces.resize(1);
        garment->seams = {};
        test::editGarment(document(), "Cut", garment);
        const auto settings = document().settings();
        move(tip + QPointF(80, 60));
        QTest::keyClick(&view(), Qt::Key_Escape);
        release(tip + QPointF(80, 60));
        QVERIFY(document().settings() == settings);
        QVERIFY(settings.size() == 1);
    }

    void aGrainThatIsTurnedIsNotPutIntoAnotherGarment() {
        action(ActionId::ToolGrain).trigger();
        setGrain(document(), "Grain", {{1, 0.3}});
        const QPointF tip =
            onScreen(grainArrow(document(), 1, view().camera().pixelsPerMillimetre())->end(0.45));
        press(tip);
        move(tip + QPointF(60, 30));
        QCOMPARE(steps(), 2);
        // A cut is done meanwhile: piece 1 is another one now.
        test::editGarment(document(), "Cut",
                          test::makeGarment({{"a", test::makeSheet(50, 40, 5, 4)},
                                             {"b", test::makeSheet(60, 40, 5, 4, {100, 0, 0})}}));
        move(tip + QPointF(70, 30));
        release(tip + QPointF(70, 30));
        QVERIFY(!document().settings()[1].grain);
        QCOMPARE(steps(), 3);
        // And taken back in the middle of a drag, history and state go together.
        document().history().undo();
        document().history().undo();
        QCOMPARE(*document().settings()[1].grain, 0.3);
        QCOMPARE(steps(), 1);
    }

    void turningTheGrainLeavesEverythingFramed() {
        const double before = view().pixelsPerMillimetre();
        setGrain(document(), "Grain", {{0, 0.3}});
        fixture_.window().resize(1000, 900);
        QVERIFY(QTest::qWaitFor(
            [&] {
                (void)fixture_.patternPicture();
                return view().pixelsPerMillimetre() < before;
            },
            test::kPatience));
    }

    void aSearchForGrainThatAnEditEndsIsSaid() {
        action(ActionId::BestGrain).trigger();
        fixture_.workspace().setMethod(Method::Lscm);  // takes its place
        QTRY_VERIFY_WITH_TIMEOUT(!fixture_.window().banner().isHidden(), test::kPatience);
        QVERIFY(fixture_.window().banner().sentence().contains("again"));
        QVERIFY(fixture_.waitForResults());
        action(ActionId::Undo).trigger();
        QVERIFY(fixture_.waitForResults());
    }

    void theGrainIsFoundOnAWorker() {
        for (const ActionId id :
             {ActionId::VerticalGrain, ActionId::ReferenceGrain, ActionId::BestGrain}) {
            action(id).trigger();
            QVERIFY(fixture_.waitUntilIdle());
            for (const PieceSettings& settings : document().settings()) {
                QVERIFY(settings.grain);
            }
            action(ActionId::Undo).trigger();
        }
    }

    void theGrainShowsOnTheGarmentToo() {
        const QImage before = fixture_.garmentPicture();
        action(ActionId::ToolGrain).trigger();
        QVERIFY(fixture_.garmentPicture() != before);
    }
};

TOILE_WINDOW_TEST(GrainToolTest)
#include "grain_tool_test.moc"
