// SPDX-License-Identifier: GPL-3.0-or-later
// Projects in the window: saving, what is unsaved, and the question before it is lost.
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>

#include "app/widgets/banner.h"
#include "core/base/file.h"
#include "core/project/project_file.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/project_bench.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

class ProjectSaveTest : public test::ProjectBench {
    Q_OBJECT

private slots:
    void theTitleTellsWhatIsUnsaved() {
        QVERIFY(!window().isWindowModified());
        edit();
        QVERIFY(window().isWindowModified());
        document().history().undo();
        QVERIFY(!window().isWindowModified());
        document().history().redo();
        saveAs("dress");  // without an ending
        QVERIFY(QFile::exists(path("dress.toile")));
        QVERIFY(!window().isWindowModified());
        document().history().undo();
        QVERIFY(window().isWindowModified());
    }

    void savingAgainAsksForNoName() {
        edit();
        saveAs("dress.toile");
        target_.clear();
        edit();
        QSignalSpy saved(&session(), &ProjectSession::saved);
        QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
        const auto read = readProject(file("dress.toile"));
        QVERIFY(read);
        QCOMPARE(read->project.pieces.at(0).settings.quantity, 3);
    }

    void aSaveThatFailsLosesNothingAndSaysSo() {
        edit();
        saveAs("dress.toile");
        const auto before = *readFile(file("dress.toile"));
        edit();
        target_ = path("missing/dress.toile");
        fixture_->action(ActionId::SaveAs).trigger();
        QVERIFY(waitForBanner());
        QVERIFY(session().isModified());
        QCOMPARE(*readFile(file("dress.toile")), before);
    }

    void aSaveThatEndsAfterAnotherWasOpenedIsOfTheFirst() {
        edit();
        QSignalSpy saved(&session(), &ProjectSession::saved);
        session().save(file("first.toile"));
        test::open(document(), test::momentOf(document()));  // before the writing is heard of
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
        QVERIFY(session().path().empty());
        QSignalSpy failed(&session(), &ProjectSession::failed);
        edit();
        session().save(file("no/such/folder.toile"));
        test::open(document(), test::momentOf(document()));
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, test::kPatience);
        QVERIFY(!session().isModified());
    }

    void closingAsksAndWaitsForTheFile() {
        edit();
        QVERIFY(!window().close());
        QCOMPARE(asked_, 1);
        answer_ = SaveAnswer::Save;
        target_ = path("dress.toile");
        QVERIFY(!window().close());  // not yet
        QTRY_VERIFY_WITH_TIMEOUT(window().isHidden(), test::kPatience);
        QVERIFY(readProject(file("dress.toile")));
    }

    void closingWithNothingUnsavedAsksNothing() {
        QVERIFY(window().close());
        QCOMPARE(asked_, 0);
    }

    void aChangeOnItsWayIsAskedAboutAndSaved() {
        workspace().cuts().change("Cut", [](SeamsFile& seams) {
            seams.cuts.push_back(
                {"waist", UserCut::Kind::Path, {{0, 210, 0}, {300, 210, 0}}, false});
        });
        QVERIFY(!document().isCurrent());  // nobody knows yet what becomes of it
        QVERIFY(session().isModified() && window().isWindowModified());
        QVERIFY(!window().close());
        QCOMPARE(asked_, 1);
        answer_ = SaveAnswer::Save;
        target_ = path("dress.toile");
        QVERIFY(!window().close());
        QTRY_VERIFY_WITH_TIMEOUT(window().isHidden(), test::kPatience);
        QCOMPARE(asked_, 2);
        const auto read = readProject(file("dress.toile"));
        QVERIFY(read);
        QCOMPARE(read->project.loading.seams.cuts.size(), std::size_t(1));
    }

    void closingWaitsForAnExport() {
        workspace().exportTo(file("out.svg"));
        QVERIFY(!window().close());
        QVERIFY(window().isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(window().isHidden(), test::kPatience);
        QVERIFY(QFile::exists(path("out.svg")));
    }

    void anExportThatFailsKeepsTheWindowOpen() {
        workspace().exportTo(file("no/such/folder.svg"));
        QVERIFY(!window().close());
        QTRY_VERIFY_WITH_TIMEOUT(!window().banner().isHidden(), test::kPatience);
        QVERIFY(window().isVisible());
        QVERIFY(window().close());  // it has been said
    }

    void discardingClosesAtOnce() {
        edit();
        answer_ = SaveAnswer::Discard;
        QVERIFY(window().close());
        QCOMPARE(asked_, 1);
    }

    void whatIsEditedWhileTheFileIsWrittenIsAskedAbout() {
        edit();
        answer_ = SaveAnswer::Save;
        target_ = path("dress.toile");
        QSignalSpy saved(&session(), &ProjectSession::saved);
        QVERIFY(!window().close());
        edit();  // the file is on its way
        answer_ = SaveAnswer::Cancel;
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
        QTRY_COMPARE_WITH_TIMEOUT(asked_, 2, test::kPatience);
        QVERIFY(window().isVisible());
        QVERIFY(session().isModified());
    }

    void whatAFileIsCalledIsAskedAboutWithItsEnding_data() {
        QTest::addColumn<QString>("typed");
        QTest::newRow("no ending") << "coat";
        QTest::newRow("another ending") << "coat.v2";
    }

    void whatAFileIsCalledIsAskedAboutWithItsEnding() {
        QFETCH(QString, typed);
        QVERIFY(writeFile(file(typed + ".toile"), "x"));
        int questions = 0;
        QTimer person;
        connect(&person, &QTimer::timeout, this, [&] {
            QWidget* modal = QApplication::activeModalWidget();
            if (auto* box = qobject_cast<QMessageBox*>(modal)) {
                ++questions;
                box->button(QMessageBox::No)->click();
            } else if (auto* dialog = qobject_cast<QFileDialog*>(modal)) {
                if (questions > 0) {
                    static_cast<QDialog*>(dialog)->reject();
                    return;
                }
                dialog->findChild<QLineEdit*>("fileNameEdit")->setText(typed);
                // Queued: what it asks is answered by the timer's next round.
                QMetaObject::invokeMethod(
                    dialog, [dialog] { static_cast<QDialog*>(dialog)->accept(); },
                    Qt::QueuedConnection);
            }
        });
        person.start(50);
        QVERIFY(FileDialogs::native().saveProject(&window(), path("dress.toile")).isEmpty());
        QCOMPARE(questions, 1);
    }
};

TOILE_WINDOW_TEST(ProjectSaveTest)
#include "project_save_test.moc"
