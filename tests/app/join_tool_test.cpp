// SPDX-License-Identifier: GPL-3.0-or-later
// The tool that takes seams and cuts out, and what else does.
#include "app/views/tools/join_tool.h"

#include <QLineF>
#include <QTreeWidget>

#include "tests/app/support/garments.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/tool_bench.h"

using namespace toile;
using namespace toile::app;

using test::click;
using test::doubleClick;
using test::moveTo;

class JoinToolTest : public test::ToolBench {
    Q_OBJECT

private slots:
    void aCutAndItsSeamAreSelectedTogether() {
        openSheets();
        tools().choose(ToolId::Cut);
        click(garmentView(), at(garmentView(), 0, {0, 77, 0}));
        doubleClick(garmentView(), at(garmentView(), 0, {kWidth, 77, 0}));
        QVERIFY(waitForPieces(3));
        auto& cuts = fixture_.find<QTreeWidget>("cutTable");
        document().setSelection({0});
        cuts.setCurrentItem(cuts.topLevelItem(0));
        QCOMPARE(document().seam(), sewn());
        QVERIFY(document().selection().empty());
        document().setSelection({1});
        QVERIFY(cuts.selectedItems().isEmpty());
        document().setSeam(sewn());
        QVERIFY(cuts.topLevelItem(0)->isSelected());
    }

    void aClickTakesACutOutAgain() {
        openSheets();
        const auto start = document().garment();
        tools().choose(ToolId::Cut);
        click(garmentView(), at(garmentView(), 0, {0, 77, 0}));
        doubleClick(garmentView(), at(garmentView(), 0, {kWidth, 77, 0}));
        QVERIFY(waitForPieces(3));
        tools().choose(ToolId::Join);
        const int seam = *sewn();
        for (SceneView* view : {&garmentView(), &patternView()}) {
            moveTo(*view, onSeam(*view, seam));
            const auto& join = dynamic_cast<const JoinTool&>(tools().current());
            QCOMPARE(join.seam(), std::optional(seam));
            moveTo(*view, {2, 2});
            QVERIFY(!join.seam());
        }
        click(patternView(), onSeam(patternView(), seam));
        QVERIFY(waitForPieces(2));
        QCOMPARE(document().garment()->pieces, start->pieces);
        QVERIFY(document().loading().seams.cuts.empty());
        QCOMPARE(document().history().undoText(), QString("Remove cut 1"));
        while (document().history().canUndo()) {
            document().history().undo();
        }
        QCOMPARE(document().garment(), start);
    }

    void aClickMakesTwoPiecesOne_data() {
        QTest::addColumn<bool>("inPattern");
        QTest::newRow("garment view") << false;
        QTest::newRow("pattern view") << true;
    }

    void aClickMakesTwoPiecesOne() {
        QFETCH(bool, inPattern);
        openCap();
        const test::Moment start = test::momentOf(document());
        QCOMPARE(document().pieceCount(), 2);
        tools().choose(ToolId::Join);
        SceneView& view = inPattern ? patternView() : garmentView();
        click(view, onSeam(view, *sewn()));
        QVERIFY2(waitForPieces(1), qPrintable(said()));
        QCOMPARE(document().garment()->pieces[0]->name, std::string("narrow + wide"));
        QCOMPARE(document().garment()->joins.size(), std::size_t{1});
        QVERIFY(!document().garment()->pieces[0]->defect);
        // The list of cuts has it, and takes it back.
        auto& list = fixture_.find<QTreeWidget>("cutTable");
        QCOMPARE(list.topLevelItemCount(), 1);
        list.setCurrentItem(list.topLevelItem(0));
        QTest::keyClick(&list, Qt::Key_Delete);
        QVERIFY(waitForPieces(2));
        QCOMPARE(document().garment()->pieces, start.derived.garment->pieces);
        document().history().undo();
        document().history().undo();
        QVERIFY(test::momentOf(document()) == start);
    }

    void theSeamThatIsSeenIsMeant_data() {
        QTest::addColumn<bool>("orthographic");
        QTest::addColumn<double>("way");
        QTest::newRow("without perspective") << true << 0.0;
        QTest::newRow("flat") << false << 1.0;
    }

    void theSeamThatIsSeenIsMeant() {
        QFETCH(bool, orthographic);
        QFETCH(double, way);
        openCap();
        tools().choose(ToolId::Join);
        const auto& join = dynamic_cast<const JoinTool&>(tools().current());
        GarmentView& view = fixture_.garmentView();
        const int seam = *sewn();
        const QPointF worn = onSeam(view, seam);
        if (orthographic) {
            view.look(ViewKey::Orthographic);
        }
        view.setMorph(way);
        (void)fixture_.garmentPicture();
        moveTo(view, onSeam(view, seam));
        QCOMPARE(join.seam(), std::optional(seam));
        if (way > 0) {
            QVERIFY(QLineF(worn, onSeam(view, seam)).length() > 1);
            // Where it was worn it is not any more; on the way nothing answers.
            view.setMorph(0.5);
            moveTo(view, onSeam(view, seam));
            QVERIFY(!join.seam());
        }
    }

    void anAutomaticCutStays() {
        const QString file = fixture_.path("tetrahedron.obj");
        test::writeObj(file.toStdString(), {{"tetrahedron", test::makeTetrahedron(100)}});
        fixture_.open();
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        fixture_.workspace().setAutoCut(true);
        QVERIFY(fixture_.openAndWait(file));
        QVERIFY(sewn());
        const test::Moment start = test::momentOf(document());
        fixture_.workspace().cuts().joinSeam(*sewn());
        QVERIFY(said().contains("tetrahedron"));
        QVERIFY(test::momentOf(document()) == start);
    }
};

TOILE_WINDOW_TEST(JoinToolTest)
#include "join_tool_test.moc"
