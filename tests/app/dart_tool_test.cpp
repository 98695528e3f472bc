// SPDX-License-Identifier: GPL-3.0-or-later
// The dart tool, with the mouse.
#include <cmath>

#include "core/quality/measures.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/tool_bench.h"

using namespace toile;
using namespace toile::app;

using test::click;
using test::drag;

class DartToolTest : public test::ToolBench {
    Q_OBJECT

private slots:
    void aDartOpensThePieceAndNothingElse_data() {
        QTest::addColumn<bool>("byDrag");
        QTest::newRow("one drag") << true;
        QTest::newRow("two clicks") << false;
    }

    void aDartOpensThePieceAndNothingElse() {
        QFETCH(bool, byDrag);
        openSheets();
        const auto before = document().garment();
        tools().choose(ToolId::Dart);
        SceneView& view = garmentView();
        const QPointF rim = at(view, 0, {103, 0, 0}), tip = at(view, 0, {103, 62, 0});
        click(view, tip);  // begins nowhere but at an edge
        QVERIFY(pathTool().draft().isEmpty());
        if (byDrag) {
            drag(view, rim, tip);
        } else {
            click(view, rim);
            QCOMPARE(pathTool().draft().points().size(), std::size_t{1});
            click(view, tip);
        }
        QVERIFY(QTest::qWaitFor([this] { return document().garment()->cuts.size() == 1; },
                                test::kPatience));
        QVERIFY(waitForPieces(2));
        const Garment& after = *document().garment();
        QCOMPARE(after.cuts[0].kind, UserCut::Kind::Dart);
        QVERIFY(std::abs(after.cuts[0].length - 62) < 1.5);
        QCOMPARE(after.pieces[1], before->pieces[1]);
        const auto outline = [](const Piece& piece) {
            return boundaryLengths3d(piece.mesh.V, piece.boundary).sum();
        };
        QVERIFY(std::abs(outline(*after.pieces[0]) - outline(*before->pieces[0]) -
                         2 * after.cuts[0].length) < 1e-6);
    }
};

TOILE_WINDOW_TEST(DartToolTest)
#include "dart_tool_test.moc"
