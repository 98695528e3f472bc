// SPDX-License-Identifier: GPL-3.0-or-later
// What the tools that work on the garment have in common: how one is chosen, shown and left.
#include <QLabel>
#include <QSignalSpy>
#include <QToolBar>
#include <QToolButton>

#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/tool_bench.h"

using namespace toile;
using namespace toile::app;

using test::click;
using test::doubleClick;
using test::moveTo;

class ToolsTest : public test::ToolBench {
    Q_OBJECT

private slots:
    void keysChooseAToolAndTheBarShowsIt() {
        openSheets();
        const std::pair<Qt::Key, ActionId> keys[] = {
            {Qt::Key_C, ActionId::ToolCut},     {Qt::Key_L, ActionId::ToolLoop},
            {Qt::Key_T, ActionId::ToolDart},    {Qt::Key_J, ActionId::ToolJoin},
            {Qt::Key_M, ActionId::ToolMeasure}, {Qt::Key_V, ActionId::ToolSelect},
        };
        auto& palette = fixture_.find<QToolBar>("toolPalette");
        QString before;
        for (const auto& [key, id] : keys) {
            QTest::keyClick(&garmentView(), key);
            QVERIFY(fixture_.action(id).isChecked());
            QVERIFY(qobject_cast<QToolButton*>(palette.widgetForAction(&fixture_.action(id)))
                        ->isChecked());
            QVERIFY(!fixture_.action(id).icon().isNull());
            QVERIFY(hint() != before);
            before = hint();
        }
        fixture_.action(ActionId::ToolCut).trigger();
        QCOMPARE(tools().current().id(), ToolId::Cut);
        QVERIFY(garmentView().hasFocus() || patternView().hasFocus());
        QTest::keyClick(&garmentView(), Qt::Key_Escape);  // nothing begun
        QCOMPARE(tools().current().id(), ToolId::Select);
        QVERIFY(fixture_.action(ActionId::ToolSelect).isChecked());
    }

    void noLabelLiesOverWhatAToolSays() {
        openSheets();
        const auto& label = *patternView().findChild<QLabel*>("hoverText");
        const QPointF inside = at(patternView(), 0, {50, 40, 0});
        for (const ToolId id :
             {ToolId::Cut, ToolId::Loop, ToolId::Dart, ToolId::Join, ToolId::Measure}) {
            tools().choose(id);
            moveTo(patternView(), inside);
            QVERIFY(document().hover());  // it lights up in both views all the same
            QVERIFY(!label.isVisible());
        }
        tools().choose(ToolId::Select);
        moveTo(patternView(), inside + QPointF(1, 0));
        QVERIFY(label.isVisible());
    }

    void backspaceTooManyResetsNoEase() {
        openCap();
        const int seam = *sewn();
        document().setSeamEase(seam, 0.02);
        document().setSeam(seam);
        const int steps = document().history().count();
        for (const ToolId id : {ToolId::Cut, ToolId::Measure}) {
            tools().choose(id);
            QTest::keyClick(&garmentView(), Qt::Key_Backspace);
            QCOMPARE(document().history().count(), steps);
        }
    }

    void aPointerWithoutADraftPaintsOneView() {
        openSheets();
        tools().choose(ToolId::Cut);
        moveTo(garmentView(), at(garmentView(), 0, {40, 40, 0}));
        const QSignalSpy both(&tools(), &ToolBox::changed);
        moveTo(garmentView(), at(garmentView(), 0, {60, 40, 0}));
        moveTo(garmentView(), at(garmentView(), 0, {80, 40, 0}));
        QCOMPARE(both.count(), 0);
    }

    void toolsLetGoOfAGarmentThatIsClosed() {
        openSheets();
        tools().choose(ToolId::Cut);
        click(garmentView(), at(garmentView(), 0, {50, 33, 0}));
        moveTo(garmentView(), at(garmentView(), 0, {90, 33, 0}));
        QVERIFY(QTest::qWaitFor([this] { return pathTool().draft().length().has_value(); },
                                test::kPatience));
        tools().choose(ToolId::Select);
        auto& cut = dynamic_cast<PathTool&>(tools().tool(ToolId::Cut));
        const std::weak_ptr<const Piece> piece = document().garment()->pieces[0];
        document().open({}, {});
        QVERIFY(cut.draft().isEmpty());
        QVERIFY(QTest::qWaitFor([&] { return piece.expired(); }, test::kPatience));
    }

    void everythingIsTakenBackStepByStep() {
        openCap();
        const test::Moment start = test::momentOf(document());
        tools().choose(ToolId::Join);
        click(garmentView(), onSeam(garmentView(), *sewn()));
        QVERIFY2(waitForPieces(1), qPrintable(said()));
        const MeshArrays& mesh = document().garment()->pieces[0]->mesh;
        const Eigen::Vector3d low = mesh.V.colwise().minCoeff(), high = mesh.V.colwise().maxCoeff();
        tools().choose(ToolId::Cut);
        SceneView& view = patternView();
        const double middle = 0.5 * (low.y() + high.y()) + 3;
        click(view, at(view, 0, {low.x(), middle, low.z()}));
        doubleClick(view, at(view, 0, {high.x(), middle, low.z()}));
        QVERIFY2(waitForPieces(2), qPrintable(said()));
        QCOMPARE(document().history().count(), 2);
        document().history().undo();
        document().history().undo();
        QVERIFY(test::momentOf(document()) == start);
        document().history().redo();
        document().history().redo();
        QVERIFY(waitForPieces(2));
        QCOMPARE(document().garment()->cuts.size(), std::size_t{1});
    }
};

TOILE_WINDOW_TEST(ToolsTest)
#include "tools_test.moc"
