// SPDX-License-Identifier: GPL-3.0-or-later
// The closed loop, with the mouse.
#include <cmath>

#include "core/quality/measures.h"
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
};

TOILE_WINDOW_TEST(LoopToolTest)
#include "loop_tool_test.moc"
