// SPDX-License-Identifier: GPL-3.0-or-later
// The window as a person meets it: files come in and go out, jobs run, docks are kept.
#include "app/window/main_window.h"

#include <QDockWidget>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>

#include "app/widgets/banner.h"
#include "tests/app/support/pair_bench.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

class MainWindowTest : public test::PairBench {
    Q_OBJECT

private slots:
    void emptyWindowInvites() {
        QVERIFY(fixture_.find<QWidget>("welcome").isVisible());
        QVERIFY(!window().views().isVisible());
        QVERIFY(!action(ActionId::ExportPattern).isEnabled());
        QVERIFY(!action(ActionId::PrintPattern).isEnabled());
        QVERIFY(!fixture_.find<QWidget>("pieceTable").isVisible());
    }

    void theInvitationStandsClearOfTheIcon() {
        const auto labels = fixture_.find<QWidget>("welcome").findChildren<QLabel*>();
        const auto heading = std::ranges::find_if(
            labels, [](const QLabel* label) { return label->text().contains("3D"); });
        QVERIFY(heading != labels.end());
        const QLabel& mark = *labels.front();
        QVERIFY(!mark.pixmap().isNull());
        QVERIFY((*heading)->geometry().top() - mark.geometry().bottom() >= 16);
        QVERIFY((*heading)->height() >= (*heading)->heightForWidth((*heading)->width()));
    }

    void garmentIsReadFlattenedAndShown() {
        QVERIFY(openPair());
        QCOMPARE(document().pieceCount(), 2);
        for (const auto& result : document().results()) {
            QVERIFY(result->flat);
        }
        QVERIFY(window().windowTitle().startsWith("pair.obj"));
        QVERIFY(window().views().isVisible());
        auto& table = fixture_.find<QTreeView>("pieceTable");
        QCOMPARE(table.model()->rowCount(), 2);
        QCOMPARE(table.model()->index(0, 0).data().toString(), QString("strip"));
        QCOMPARE(table.model()->index(0, 1).data().toString(), QString("Flat"));
    }

    void selectingInTheTableSelectsInTheViews() {
        QVERIFY(openPair());
        auto& table = fixture_.find<QTreeView>("pieceTable");
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                          table.visualRect(table.model()->index(1, 0)).center());
        QCOMPARE(document().selection(), Document::Selection{1});
    }

    void openActionAsksAndOpens() {
        FileDialogs dialogs = FileDialogs::native();
        dialogs.open = [&](QWidget*, const QString&) { return QStringList{path("pair.obj")}; };
        window().garmentActions().setFileDialogs(dialogs);
        QTest::mouseClick(&fixture_.find<QWidget>("welcomeOpen"), Qt::LeftButton);
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(fixture_.preferences().openFolder(), QFileInfo(path("pair.obj")).absolutePath());
    }

    void droppedFilesAreOpened() {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path("pair.obj")), QUrl::fromLocalFile("notes.txt")});
        QDragEnterEvent enter(QPoint(20, 20), Qt::CopyAction, &data, Qt::LeftButton,
                              Qt::NoModifier);
        QApplication::sendEvent(&window(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window(), &drop);
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(document().pieceCount(), 2);
    }

    void failedPieceIsNamedAndTheOthersGoOn() {
        test::writeObj(path("mixed.obj").toStdString(), {{"strip", test::makeBentStrip(-140)},
                                                         {"ball", test::makeTetrahedron(120)}});
        QVERIFY(fixture_.openAndWait(path("mixed.obj")));
        QVERIFY(document().results()[0]->flat);
        QVERIFY(document().results()[1]->error);
        auto& table = fixture_.find<QTreeView>("pieceTable");
        QVERIFY(table.model()->index(1, 1).data().toString() != "Flat");
        document().setSelection({1});
        QVERIFY(fixture_.find<QLabel>("pieceDetails").text().contains("ball"));
    }

    void unreadableFileLeavesTheGarmentAlone() {
        QVERIFY(openPair());
        window().openFiles({path("missing.obj")});
        QTRY_VERIFY_WITH_TIMEOUT(window().banner().isVisible(), test::kPatience);
        QVERIFY(window().banner().sentence().contains("missing.obj"));
        QCOMPARE(document().pieceCount(), 2);
        QVERIFY(!document().results().empty());
        QVERIFY(openPair());
        QVERIFY(!window().banner().isVisible());
    }

    void unitActionReadsTheFileAgain() {
        QVERIFY(openPair());
        const double area = document().results()[0]->quality->area3d;
        action(ActionId::UnitCentimetre).trigger();
        QTRY_VERIFY_WITH_TIMEOUT(
            document().result(0) && document().result(0)->quality->area3d > 50 * area,
            test::kPatience);
    }

    void closedDockStaysClosedNextTime() {
        Preferences kept(path("preferences.ini"));
        {
            MainWindow first(kept);
            first.show();
            first.openFiles({path("pair.obj")});
            auto* dock = first.findChild<QDockWidget*>("problemsDock");
            QTRY_VERIFY_WITH_TIMEOUT(dock->toggleViewAction()->isChecked(), test::kPatience);
            dock->toggleViewAction()->trigger();
            first.close();
        }
        MainWindow second(kept);
        second.show();
        second.openFiles({path("pair.obj")});
        QTRY_VERIFY_WITH_TIMEOUT(second.workspace().document().garment(), test::kPatience);
        QVERIFY(!second.findChild<QDockWidget*>("problemsDock")->toggleViewAction()->isChecked());
        QVERIFY(second.findChild<QDockWidget*>("piecesDock")->toggleViewAction()->isChecked());
    }

    void closingWhileAJobRunsIsSafe() {
        window().openFiles({path("pair.obj")});
        QVERIFY(workspace().jobs().isBusy());
        window().close();
        QVERIFY(!workspace().jobs().isBusy());
    }

    void cancelActionIsThereWhileAJobRuns() {
        QAction& cancel = action(ActionId::Cancel);
        QVERIFY(!cancel.isEnabled());
        window().openFiles({path("pair.obj")});
        QVERIFY(cancel.isEnabled());
        QVERIFY(fixture_.find<QProgressBar>("progress").isVisible());
        QTest::mouseClick(&fixture_.find<QToolButton>("cancelButton"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!workspace().jobs().isBusy(), test::kPatience);
        QVERIFY(!cancel.isEnabled());
        QVERIFY(!fixture_.find<QProgressBar>("progress").isVisible());
    }
};

TOILE_WINDOW_TEST(MainWindowTest)
#include "main_window_test.moc"
