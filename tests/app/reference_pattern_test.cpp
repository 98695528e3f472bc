// SPDX-License-Identifier: GPL-3.0-or-later
// A pattern file that is laid over the flat pieces, to compare with.
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QTreeView>
#include <QUrl>
#include <algorithm>
#include <utility>

#include "app/document/reference.h"
#include "app/panels/pieces_model.h"
#include "app/panels/problems_model.h"
#include "app/views/reference_gaps.h"
#include "app/widgets/banner.h"
#include "core/base/file.h"
#include "core/project/project_file.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/project_bench.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

class ReferencePatternTest : public test::ProjectBench {
    Q_OBJECT

    void exportAs(const QString& name) {
        QVERIFY(waitUntilFlat());
        workspace().exportTo(file(name));
        QVERIFY(fixture_->waitUntilIdle());
        QVERIFY(QFile::exists(path(name)));
    }

    void openByMenu(const QString& name) {
        window().garmentActions().fileDialogs().openPattern =
            [chosen = path(name)](QWidget*, const QString&) { return chosen; };
        fixture_->action(ActionId::OpenReference).trigger();
    }

    bool waitForReference() {
        return QTest::qWaitFor(
            [this] { return !workspace().isBusy() && document().reference() != nullptr; },
            test::kPatience);
    }

    /// @return whether the window takes it
    bool drop(const QString& name) {
        QMimeData dragged;
        dragged.setUrls({QUrl::fromLocalFile(path(name))});
        QDragEnterEvent enter({10, 10}, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window(), &enter);
        QDropEvent dropped({10, 10}, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window(), &dropped);
        return enter.isAccepted() && dropped.isAccepted();
    }

    bool showsColumns() {
        return !fixture_->find<QTreeView>("pieceTable").isColumnHidden(PiecesModel::ReferenceRms);
    }

    QVariant inTable(int piece, int role) {
        const auto* model = fixture_->find<QTreeView>("pieceTable").model();
        return model->index(piece, PiecesModel::ReferenceMax).data(role);
    }

private slots:
    void ourOwnPatternLiesOnEveryPiece() {
        QVERIFY(QFile::copy(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj", path("tshirt.obj")));
        QVERIFY(fixture_->openAndWait(path("tshirt.obj")));
        for (const char* name : {"tshirt.dxf", "tshirt.svg"}) {
            exportAs(name);
            openByMenu(name);
            QVERIFY(waitForReference());
            for (int piece = 0; piece < document().pieceCount(); ++piece) {
                const auto fit = document().referenceFit(piece);
                QVERIFY(fit.has_value());
                QVERIFY(fit->rms <= fit->max);
                QVERIFY2(fit->max < 0.05, qPrintable(QString::number(fit->max)));
            }
        }
    }

    void isDrawnAndTold() {
        exportAs("dress.dxf");
        QAction& panels = fixture_->action(ActionId::ReferencePanels);
        QVERIFY(!panels.isEnabled() && !showsColumns());
        const QSignalSpy noted(&workspace(), &Workspace::noted);
        openByMenu("dress.dxf");
        QVERIFY(waitForReference());
        QVERIFY(panels.isEnabled() && panels.isChecked() && showsColumns());
        QCOMPARE(noted.count(), 1);
        QVERIFY(noted[0][0].toString().contains("3 of 3 pieces matched"));
        QCOMPARE(inTable(0, Qt::DisplayRole).toString(), QString("0.00"));
        QVERIFY(inTable(0, Qt::ToolTipRole).toString().contains("front", Qt::CaseInsensitive));
        const QImage with = fixture_->patternPicture();
        panels.trigger();
        QVERIFY(fixture_->patternPicture() != with);
    }

    void isAStepOfTheHistory() {
        exportAs("dress.dxf");
        const int steps = document().history().count();
        QAction& close = fixture_->action(ActionId::CloseReference);
        QVERIFY(!close.isEnabled());
        openByMenu("dress.dxf");
        QVERIFY(waitForReference());
        QCOMPARE(document().history().count(), steps + 1);
        fixture_->action(ActionId::Undo).trigger();
        QVERIFY(document().state().reference == ReferenceFile{});
        QVERIFY(!document().reference() && !showsColumns() && !close.isEnabled());
        fixture_->action(ActionId::Redo).trigger();
        QVERIFY(waitForReference());
        QVERIFY(showsColumns());
        close.trigger();
        QVERIFY(document().state().reference == ReferenceFile{});
        QVERIFY(!document().referenceFit(0));
        fixture_->action(ActionId::Undo).trigger();
        QVERIFY(waitForReference());
        QVERIFY(document().referenceFit(0));
    }

    void followsThePiecesAndTheirNames() {
        exportAs("dress.dxf");
        openByMenu("dress.dxf");
        QVERIFY(waitForReference());
        workspace().setMethod(Method::Lscm);
        QVERIFY(waitUntilFlat());
        QVERIFY(waitForReference());
        QVERIFY(document().reference()->pattern == document().derived().pattern);
        QVERIFY(document().referenceFit(2)->max > 0.05);  // the cap lies otherwise
        QVERIFY(document().referenceFit(0)->max < 0.05);
    }

    /// Drawn where the distance in the list of pieces comes from.
    void gapsAreAsWideAsTheListSays() {
        exportAs("dress.dxf");
        openByMenu("dress.dxf");
        QVERIFY(waitForReference());
        workspace().setMethod(Method::Lscm);
        QVERIFY(waitUntilFlat());
        QVERIFY(waitForReference());
        ReferenceGaps gaps;
        gaps.follow(document());
        std::vector<double> widest(static_cast<std::size_t>(document().pieceCount()), 0);
        for (const ReferenceGaps::Gap& gap : gaps.gaps()) {
            double& most = widest[static_cast<std::size_t>(gap.piece)];
            most = std::max(most, gap.distance);
            QVERIFY(std::abs((gap.theirs - gap.ours).norm() - gap.distance) < 1e-9);
        }
        for (int piece = 0; piece < document().pieceCount(); ++piece) {
            const double most = document().referenceFit(piece)->max;
            const double drawn = widest[static_cast<std::size_t>(piece)];
            QVERIFY2(drawn > 0.5 * most - 0.05 && drawn < most + 0.05,
                     qPrintable(QString::number(drawn)));
        }
        fixture_->action(ActionId::ReferencePanels).trigger();
        gaps.follow(document());
        QVERIFY(gaps.gaps().empty());
    }

    void isSavedWithTheProject() {
        exportAs("dress.dxf");
        openByMenu("dress.dxf");
        QVERIFY(waitForReference());
        saveAs("dress.toile");
        reopenWindow();
        const QSignalSpy noted(&workspace(), &Workspace::noted);
        QVERIFY(fixture_->openAndWait(path("dress.toile")));
        QVERIFY(waitUntilFlat());
        QVERIFY(waitForReference());
        QCOMPARE(noted.count(), 1);  // once the pieces are flat
        QVERIFY(noted[0][0].toString().contains("3 of 3 pieces matched"));
        QVERIFY(document().state().reference.path == file("dress.dxf"));
        QVERIFY(document().referenceFit(1));
        QVERIFY(document().view().referencePanels);
        QVERIFY(!session().isModified());
    }

    void oneThatIsGoneIsANote() {
        exportAs("dress.dxf");
        openByMenu("dress.dxf");
        QVERIFY(waitForReference());
        saveAs("dress.toile");
        QVERIFY(QFile::remove(path("dress.dxf")));
        reopenWindow();
        QVERIFY(fixture_->openAndWait(path("dress.toile")));
        QVERIFY(waitForBanner());
        QVERIFY(window().banner().sentence().contains("dress.dxf"));
        QCOMPARE(document().pieceCount(), 3);
        QVERIFY(!document().state().reference.file && !showsColumns());
        QVERIFY(!fixture_->action(ActionId::ReferencePanels).isEnabled());
        // It is not forgotten either: it may be back one day.
        saveAs("again.toile");
        const auto saved = readProject(file("again.toile"));
        QVERIFY(saved && saved->project.reference);
        QVERIFY(saved->project.reference->path == file("dress.dxf"));
        fixture_->action(ActionId::CloseReference).trigger();
        QVERIFY(document().state().reference.path.empty());
    }

    void oneThatCannotBeReadChangesNothing() {
        QVERIFY(writeFile(file("broken.dxf"), "no pattern"));
        QVERIFY(waitUntilFlat());
        const test::Moment before = test::momentOf(document());
        for (const char* name : {"broken.dxf", "gone.dxf", "dress.obj"}) {
            window().banner().hide();
            openByMenu(name);
            QVERIFY(waitForBanner());
            QVERIFY(window().banner().sentence().contains(name));
            QVERIFY(fixture_->waitUntilIdle());
            QVERIFY(test::momentOf(document()) == before);
            QVERIFY(!document().view().referencePanels && !document().history().canUndo());
        }
    }

    void whatItsReaderLeavesOutIsListedAmongTheProblems() {
        exportAs("dress.dxf");
        auto dxf = *readFile(file("dress.dxf"));
        const std::size_t end = dxf.rfind("ENDSEC");
        dxf.insert(dxf.rfind('0', end), "0\nIMAGE\n340\n1A\n");
        QVERIFY(writeFile(file("dress.dxf"), dxf));
        const auto listed = [this] {
            const auto* model = fixture_->find<QTreeView>("problemTable").model();
            for (int row = 0; row < model->rowCount(); ++row) {
                if (model->index(row, ProblemsModel::Problem).data().toString().contains("IMAGE")) {
                    return model->index(row, ProblemsModel::Where).data().toString();
                }
            }
            return QString();
        };
        QVERIFY(waitUntilFlat());
        QVERIFY(listed().isEmpty());
        openByMenu("dress.dxf");
        QVERIFY(waitForReference());
        QTRY_COMPARE_WITH_TIMEOUT(listed(), QString("dress.dxf"), test::kPatience);
        fixture_->action(ActionId::CloseReference).trigger();
        QTRY_VERIFY_WITH_TIMEOUT(listed().isEmpty(), test::kPatience);
    }

    void isOpenedByDroppingItOnAnOpenGarment() {
        exportAs("dress.svg");
        QVERIFY(writeFile(file("notes.txt"), "no pattern"));
        QVERIFY(!drop("notes.txt"));
        QVERIFY(drop("dress.svg"));
        QVERIFY(waitForReference());
        QCOMPARE(document().title(), QString("dress.obj"));
        reopenWindow();
        QVERIFY(!drop("dress.svg"));
        QVERIFY(!workspace().isBusy());
    }

    void whatIsNotSureIsSaidAndNotDrawn() {
        test::writeObj(file("twins.obj"),
                       {{"left", test::makeSheet(300, 400, 6, 8)},
                        {"right", test::makeSheet(300, 400, 6, 8, {400, 0, 0})}});
        QVERIFY(fixture_->openAndWait(path("twins.obj")));
        exportAs("twins.dxf");
        QVERIFY(fixture_->openAndWait(path("dress.obj")));
        QVERIFY(waitUntilFlat());
        const QSignalSpy noted(&workspace(), &Workspace::noted);
        openByMenu("twins.dxf");
        QVERIFY(waitForReference());
        QVERIFY(!document().referenceFit(0) && !document().referenceFit(1));
        const QString said = noted.last()[0].toString();
        QVERIFY2(said.contains("0 of 3 pieces matched"), qPrintable(said));
        QVERIFY2(said.contains("several matches: front"), qPrintable(said));
        QVERIFY2(said.contains("no match: back, cap"), qPrintable(said));
        const QString tip = inTable(0, Qt::ToolTipRole).toString();
        QVERIFY2(tip.endsWith(": LEFT, RIGHT"), qPrintable(tip));
        const QImage with = fixture_->patternPicture();
        fixture_->action(ActionId::ReferencePanels).trigger();
        QVERIFY(fixture_->patternPicture() == with);
    }
};

TOILE_WINDOW_TEST(ReferencePatternTest)
#include "reference_pattern_test.moc"
