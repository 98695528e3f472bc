// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of lines: real keys and clicks, what they leave in the document, and what the pattern
// is then.
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QToolButton>
#include <QTreeView>
#include <QTreeWidget>
#include <algorithm>

#include "app/document/line_facts.h"
#include "app/jobs/file_jobs.h"
#include "app/panels/seam_ends_list.h"
#include "app/panels/seams_model.h"
#include "app/render/scene.h"
#include "app/text/figures.h"
#include "app/widgets/number_edits.h"
#include "core/base/units.h"
#include "core/project/project_file.h"
#include "core/seam/seam_measure.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

/// A cap of two parts that are sewn to each other.
class LinesPanelTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    const LineSettings& lines() { return document().state().lines; }
    int steps() { return document().history().index(); }
    void undo() { fixture_.action(ActionId::Undo).trigger(); }
    QCheckBox& box(const char* name) { return fixture_.find<QCheckBox>(name); }
    QToolButton& button(const char* name) { return fixture_.find<QToolButton>(name); }
    QTreeWidget& ends() { return fixture_.find<QTreeWidget>("seamEndList"); }
    QString label(const char* name) { return fixture_.find<QLabel>(name).text(); }

    void type(const char* name, const QString& text) {
        auto& field = fixture_.find<QDoubleSpinBox>(name);
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }

    /// How many pieces have a drawn line.
    int drawn() {
        int count = 0;
        for (const auto& result : document().results()) {
            count += result && result->flat && result->flat->line ? 1 : 0;
        }
        return count;
    }

    bool isFlatAgain() {
        return QTest::qWaitFor([this] { return document().isFlattened(); }, test::kPatience) &&
               fixture_.waitForResults();
    }

    SeamMeasure seamMeasure() { return *measured(*document().garment(), document().results(), 0); }

    /// The list shows the kinks of the drawn lines, as the report has them.
    void expectKinksAsDrawn() {
        const Garment& garment = *document().garment();
        const PieceResults& results = document().results();
        const LineFacts facts = lineFacts(garment, results, lines());
        const auto turnAt = [&](const OutlineCorner& corner) -> double {
            const auto piece = std::size_t(corner.piece);
            return drawnTurn(*results[piece],
                             facts.segments[piece].turnPoints[std::size_t(corner.point)]);
        };
        QCOMPARE(ends().topLevelItemCount(), int(facts.ends.size()));
        for (std::size_t k = 0; k < facts.ends.size(); ++k) {
            const double kink = kinkOf(turnAt(facts.ends[k].left), turnAt(facts.ends[k].right));
            QCOMPARE(ends().topLevelItem(int(k))->text(SeamEndsList::Kept), angleWithUnit(kink));
        }
    }

    /// Clicks the check box of a row.
    void tick(int row) {
        QTreeWidget& list = ends();
        const QRect cell = list.visualItemRect(list.topLevelItem(row));
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {},
                          {cell.left() + 12, cell.center().y()});
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        test::writeObj(fixture_.path("cap.obj").toStdString(), test::sewnCapParts());
    }

    void init() {
        fixture_.open();
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        QVERIFY(fixture_.openAndWait(fixture_.path("cap.obj")));
        fixture_.action(ActionId::GoToLines).trigger();
        QVERIFY(box("fairing").hasFocus());
        QCOMPARE(document().garment()->seams.seams[0].kind, SeamKind::Seam);
    }

    void cleanup() { fixture_.close(); }

    void theTextsOfLabelsAreInSight() {
        // Rows are as high as letters are.
        QMainWindow& window = fixture_.window();
        window.resize(window.width(), std::max(900, 56 * window.fontMetrics().height()));
        for (const char* name : {"labelSize", "labelDate"}) {
            const auto& field = fixture_.find<QLineEdit>(name);
            QTRY_COMPARE(field.visibleRegion().boundingRect(), field.rect());
        }
    }

    void fairLinesAreDrawnAndOneUndoTakesThemBack() {
        const PieceResults before = document().results();
        QCOMPARE(drawn(), 0);
        QTest::keyClick(&box("fairing"), Qt::Key_Space);
        QCOMPARE(steps(), 1);
        QVERIFY(isFlatAgain());
        QCOMPARE(drawn(), 2);
        QVERIFY2(label("lineStraying").contains("from the exact outline"),
                 qPrintable(label("lineStraying")));
        undo();
        QVERIFY(isFlatAgain());
        QCOMPARE(steps(), 0);
        QVERIFY(!box("fairing").isChecked());
        QVERIFY(document().results() == before);
    }

    void aNumberThatIsSpunIsOneStepAndTurnsFairLinesOn() {
        auto& field = fixture_.find<QDoubleSpinBox>("fairingTolerance");
        field.setFocus();
        QTest::keyClick(&field, Qt::Key_Up);
        QTest::keyClick(&field, Qt::Key_Up);
        QCOMPARE(lines().fairing->tolerance, 3.0);
        QCOMPARE(steps(), 1);
        type("fairingSmoothing", "25");
        QCOMPARE(lines().fairing->smoothing, 25.0);
        QCOMPARE(lines().fairing->tolerance, 3.0);
        QCOMPARE(steps(), 2);
        undo();
        undo();
        QVERIFY(lines() == LineSettings{});
    }

    void aTypedLengthHoldsOnBothSidesOfTheSeam() {
        QVERIFY(!fixture_.find<QDoubleSpinBox>("segmentLength").isEnabled());
        document().setSeam(0);
        QVERIFY(fixture_.find<QDoubleSpinBox>("segmentLength").isEnabled());
        const double worn = seamMeasure().length3d[0];
        QVERIFY(std::abs(fixture_.find<QDoubleSpinBox>("segmentLength").value() - worn) < 1e-4);
        type("segmentLength", "215");
        QCOMPARE(steps(), 1);
        QVERIFY(isFlatAgain());
        QVERIFY(std::abs(seamMeasure().length2dLeft - 215) < 1e-6);
        QVERIFY(std::abs(seamMeasure().length2dRight - 215) < 1e-6);
        // The other side shows it too, and can take it back.
        const Seam& seam = document().garment()->seams.seams[0];
        document().setMark(Feature{.kind = Feature::Kind::Run,
                                   .piece = seam.right.piece,
                                   .first = seam.right.first,
                                   .count = seam.right.count});
        QCOMPARE(fixture_.find<QDoubleSpinBox>("segmentLength").value(), 215.0);
        QTest::mouseClick(&button("segmentLengthReset"), Qt::LeftButton);
        QVERIFY(lines() == LineSettings{});
        QVERIFY(isFlatAgain());
        QVERIFY(std::abs(seamMeasure().length2dLeft - worn) < 1e-6);
        undo();
        QCOMPARE(lines().segments.size(), std::size_t(1));
    }

    void lengthsBeyondMeasureAreNotTaken() {
        document().setSeam(0);
        for (const QString text : {"1", "1e9", "", "long"}) {
            type("segmentLength", text);
            QVERIFY2(lines() == LineSettings{}, qPrintable(text));
        }
    }

    void aStraightSegmentIsAsLongAsItsChord() {
        document().setSeam(0);
        box("segmentStraight").click();
        QVERIFY(lines().fairing && lines().segments.at(0).straight);
        QVERIFY(isFlatAgain());
        const SeamSide& side = document().garment()->seams.seams[0].left;
        const Points2 line = flatLine(side, *document().garment()->pieces[std::size_t(side.piece)],
                                      *document().results()[std::size_t(side.piece)]->flat);
        const double chord = (line.row(line.rows() - 1) - line.row(0)).norm();
        QVERIFY(std::abs(chord - side.length()) < 1e-3);
        QVERIFY(box("segmentStraight").isChecked());
        undo();
        QVERIFY(lines() == LineSettings{});
        QVERIFY(!box("segmentStraight").isChecked());
    }

    void aSeamEndIsTruedByItsCheckBox() {
        QVERIFY(ends().topLevelItemCount() > 0);
        QCOMPARE(ends().topLevelItem(0)->checkState(0), Qt::Unchecked);
        tick(0);
        QCOMPARE(steps(), 1);
        QCOMPARE(lines().seamEnds.size(), std::size_t(1));
        QVERIFY(lines().fairing && lines().seamEnds[0].trued);
        QCOMPARE(document().seam(), std::optional(0));
        QCOMPARE(ends().topLevelItem(0)->checkState(0), Qt::Checked);
        QVERIFY(isFlatAgain());
        expectKinksAsDrawn();
        QVERIFY(ends().topLevelItem(0)->text(SeamEndsList::Kept).contains("0.0"));
        tick(0);
        QVERIFY(lines().seamEnds.empty());
        QVERIFY(isFlatAgain());
        expectKinksAsDrawn();
        QVERIFY(!ends().topLevelItem(0)->text(SeamEndsList::Kept).contains("0.0"));
        // By the general rule all are, but for the one that is said to stay.
        QTest::keyClick(&box("trueBelowOn"), Qt::Key_Space);
        QVERIFY(std::abs(lines().trueBelow - 10 * kDegree) < 1e-12);
        type("trueBelow", "20");
        QCOMPARE(ends().topLevelItem(0)->checkState(0), Qt::Checked);
        tick(0);
        QCOMPARE(lines().seamEnds.size(), std::size_t(1));
        QVERIFY(!lines().seamEnds[0].trued);
        QCOMPARE(ends().topLevelItem(0)->checkState(0), Qt::Unchecked);
        QVERIFY(isFlatAgain());
    }

    void aTurnPointComesAndGoesAtAVertex() {
        const Piece& piece = *document().garment()->pieces[1];
        const SeamSide& side = document().garment()->seams.seams[0].right;
        const int middle = (side.first + side.count / 2) % static_cast<int>(piece.boundary.size());
        const int vertex = piece.boundary[static_cast<std::size_t>(middle)];
        int face = 0;
        while ((piece.mesh.F.row(face).array() != vertex).all()) {
            ++face;
        }
        document().setMark(
            Feature{.kind = Feature::Kind::Vertex, .piece = 1, .vertex = vertex, .face = face});
        QVERIFY(button("addTurnPoint").isEnabled() && !button("removeTurnPoint").isEnabled());
        QTest::mouseClick(&button("addTurnPoint"), Qt::LeftButton);
        QCOMPARE(lines().turnPoints.size(), std::size_t(1));
        QVERIFY(!button("addTurnPoint").isEnabled() && button("removeTurnPoint").isEnabled());
        QTest::mouseClick(&button("removeTurnPoint"), Qt::LeftButton);
        QVERIFY(lines().turnPoints.empty());
        QCOMPARE(steps(), 2);
    }

    void anEaseIsDrawnWhereItsBoxIsTicked() {
        fixture_.action(ActionId::GoToSeams).trigger();
        auto& table = fixture_.find<QTreeView>("seamTable");
        const QModelIndex cell = table.model()->index(0, SeamsModel::Drawn);
        QVERIFY(!cell.data(Qt::CheckStateRole).isValid());
        fixture_.document().setSeamEase(0, 0.05);
        QCOMPARE(cell.data(Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
        QVERIFY(std::abs(seamMeasure().errorMm) > 1);
        const QRect box = table.visualRect(cell);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                          {box.left() + 12, box.center().y()});
        QCOMPARE(cell.data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
        QCOMPARE(steps(), 2);
        QVERIFY(isFlatAgain());
        QVERIFY(std::abs(seamMeasure().errorMm) < 1e-6);
        undo();
        QVERIFY(isFlatAgain());
        QVERIFY(std::abs(seamMeasure().errorMm) > 1);
    }

    void aProjectKeepsAllThatWasSaid() {
        QTest::keyClick(&box("trueBelowOn"), Qt::Key_Space);
        document().setSeam(0);
        type("segmentLength", "215");
        type("segmentTolerance", "2");
        box("segmentStraight").click();
        tick(0);
        QVERIFY(isFlatAgain());
        fixture_.action(ActionId::ExactOutline).trigger();
        const LineSettings said = lines();
        const QString file = fixture_.path("lines.toile");
        QVERIFY(writeProject(file.toStdString(), projectOf(document().state(), document().derived(),
                                                           document().view())));
        fixture_.close();
        fixture_.open();
        QVERIFY(fixture_.openAndWait(file));
        QVERIFY(lines() == said);
        QVERIFY(document().view().exactOutline);
        QCOMPARE(drawn(), 2);
        QCOMPARE(steps(), 0);
    }

    void theExactOutlineIsALayerOfItsOwn() {
        QAction& action = fixture_.action(ActionId::ExactOutline);
        QVERIFY(!action.isEnabled());
        QTest::keyClick(&box("fairing"), Qt::Key_Space);
        QVERIFY(isFlatAgain());
        const Scene& scene = *document().scene();
        QCOMPARE(scene.patternLines.exact.size(), std::size_t(2));
        const auto& exact = *document().results()[0]->exact->flat;
        const Piece& piece = *document().garment()->pieces[0];
        const VertexRun run = scene.patternLines.exact[0];
        QCOMPARE(run.count, std::uint32_t(piece.boundary.size() + 1));
        for (std::uint32_t k = 0; k + 1 < run.count; ++k) {
            const Eigen::Vector2d there = exact.Q.row(piece.boundary[k]).transpose();
            QVERIFY((flatPoint(scene.lineVertices[run.first + k]) - there).norm() < 1e-3);
        }
        const QImage without = fixture_.patternPicture();
        QVERIFY(action.isEnabled() && !action.isChecked());
        action.trigger();
        QVERIFY(document().view().exactOutline);
        QVERIFY(fixture_.patternPicture() != without);
    }

    void verticesAreFoundOnDrawnOutlines() {
        QTest::keyClick(&box("fairing"), Qt::Key_Space);
        QVERIFY(isFlatAgain());
        const Scene& scene = *document().scene();
        for (std::size_t p = 0; p < 2; ++p) {
            const Piece& piece = *document().garment()->pieces[p];
            const VertexRun run = scene.patternLines.outlines[p];
            const auto& at = scene.patternLines.boundaryAt[p];
            QCOMPARE(at.size(), piece.boundary.size() + 1);
            QCOMPARE(at.back(), run.count - 1);
            for (std::size_t k = 0; k < piece.boundary.size(); ++k) {
                const Eigen::Vector3d there =
                    piece.mesh.V.row(piece.boundary[k]).transpose() - scene.origin;
                QVERIFY((wornPoint(scene.lineVertices[run.first + at[k]]) - there).norm() < 1e-3);
            }
        }
    }
};

TOILE_WINDOW_TEST(LinesPanelTest)
#include "lines_panel_test.moc"
