// SPDX-License-Identifier: GPL-3.0-or-later
// The closed loop, with the mouse.
#include <cmath>
#include <numbers>

#include "core/quality/measures.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/tool_bench.h"

using namespace toile;
using namespace toile::app;

using test::click;

class LoopToolTest : public test::ToolBench {
    Q_OBJECT

private slots:
    void aLoopCutsAPartOut() {
        openSheets();
        tools().choose(ToolId::Loop);
        SceneView& view = patternView();
        const Eigen::Vector3d corners[] = {{62, 42, 0}, {141, 44, 0}, {101, 108, 0}};
        for (const auto& corner : corners) {
            click(view, at(view, 0, corner));
        }
        click(view, at(view, 0, corners[0]));  // the first again closes it
        QVERIFY(waitForPieces(3));
        QCOMPARE(document().garment()->cuts[0].kind, UserCut::Kind::Loop);
        double area = 0;
        for (int piece = 0; piece < 2; ++piece) {
            area +=
                triangleAreas3d(document().garment()->pieces[static_cast<std::size_t>(piece)]->mesh)
                    .sum();
        }
        QVERIFY(std::abs(area - kWidth * kHeight) < 1e-6);
    }

    void altAndAClickCutAroundATube_data() {
        QTest::addColumn<ToolId>("tool");
        QTest::addColumn<int>("around");
        QTest::newRow("cut tool") << ToolId::Cut << 16;
        QTest::newRow("loop tool") << ToolId::Loop << 16;
        QTest::newRow("a fine mesh, on another thread") << ToolId::Cut << 96;
    }

    void altAndAClickCutAroundATube() {
        QFETCH(ToolId, tool);
        QFETCH(int, around);
        constexpr double kRadius = 90, kLength = 700;
        MeshArrays sleeve = test::makeSheet(2 * std::numbers::pi * kRadius, kLength, around, 12);
        for (auto v : sleeve.V.rowwise()) {
            const double angle = v.x() / kRadius;
            v = Eigen::RowVector3d(kRadius * std::cos(angle), v.y(), -kRadius * std::sin(angle));
        }
        const QString file = fixture_.path("sleeve.obj");
        test::writeObj(file.toStdString(), {{"sleeve", sleeve}});
        fixture_.open();
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        fixture_.workspace().setWeld(true);
        QVERIFY(fixture_.openAndWait(file));
        QVERIFY(document().garment()->pieces[0]->defect);
        tools().choose(tool);
        QVERIFY(hint().contains("Alt+click"));
        SceneView& view = garmentView();
        click(view, QPointF(view.width() / 2.0, view.height() / 2.0), Qt::AltModifier);
        QTRY_COMPARE_WITH_TIMEOUT(document().pieceCount(), 2, test::kPatience);
        QCOMPARE(tools().current().id(), tool);
        const AppliedCut& cut = document().garment()->cuts[0];
        QCOMPARE(cut.kind, UserCut::Kind::Loop);
        const double girth = 2 * around * kRadius * std::sin(std::numbers::pi / around);
        QVERIFY(std::abs(cut.length - girth) < 1e-3 * girth);
    }

    void altAndAClickOnASheetSaysThatThereIsNoTube() {
        openSheets();
        tools().choose(ToolId::Loop);
        SceneView& view = garmentView();
        click(view, at(view, 0, {62, 42, 0}), Qt::AltModifier);
        QVERIFY(said().contains("no tube"));
        QVERIFY(document().garment()->cuts.empty());
    }
};

TOILE_WINDOW_TEST(LoopToolTest)
#include "loop_tool_test.moc"
