// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/file_jobs.h"
#include "core/base/file.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/workspace_fixture.h"

using namespace toile;
using namespace toile::app;

/// Exports beside everything else.
class WorkspaceWritingTest : public QObject, public test::WorkspaceFixture {
    Q_OBJECT

private slots:
    void init() {
        renew();
        QVERIFY(openPair());
    }

    void cleanup() { close(); }

    void anEditLeavesWhatIsBeingWrittenAlone() {
        workspace().exportTo(file("before.svg"));
        QVERIFY(waitUntilWritten());
        test::Hold held;
        const auto first = workspace().writing().start(held.job());
        workspace().exportTo(file("meanwhile.svg"));  // waits for it
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), 3);
        workspace().setMethod(Method::Natural);
        document().history().undo();
        QVERIFY(workspace().writing().isUnderWay(first));
        held.release();
        QVERIFY(waitUntilWritten());
        QVERIFY(waitUntilDone());
        // The pattern as it was when the writing was asked for.
        QCOMPARE(*readFile(file("meanwhile.svg")), *readFile(file("before.svg")));
        workspace().exportTo(file("after.svg"));
        QVERIFY(waitUntilWritten());
        QVERIFY(*readFile(file("after.svg")) != *readFile(file("before.svg")));
    }

    void openingAnotherGarmentLeavesItAloneToo() {
        workspace().exportTo(file("pair.svg"));
        workspace().open({file("other.obj")});
        QVERIFY(waitUntilDone());
        QVERIFY(waitUntilWritten());
        QVERIFY(QFile::exists(path("pair.svg")));
    }

    void filesAreWrittenOneAfterTheOther() {
        QSignalSpy exported(&workspace(), &Workspace::exported);
        workspace().exportTo(file("one.svg"));
        workspace().exportTo(file("two.dxf"));
        workspace().exportTo(file("three.json"));
        QVERIFY(waitUntilWritten());
        QCOMPARE(exported.count(), 3);
        QVERIFY(exported[0][0].toString().endsWith("one.svg"));
        QVERIFY(exported[1][0].toString().endsWith("two.dxf"));
        QVERIFY(exported[2][0].toString().endsWith("three.json"));
    }

    void cancellingStopsWhatIsShown() {
        test::Hold held;
        const auto first = workspace().writing().start(held.job());
        workspace().exportTo(file("cancelled.svg"));
        cutAcross("waist", 210);
        workspace().cancel();  // the cut
        QVERIFY(document().isCurrent());
        QVERIFY(waitUntilDone());
        QVERIFY(workspace().writing().isUnderWay(first));
        workspace().cancel();  // what is written
        QVERIFY(waitUntilWritten());
        QVERIFY(!QFile::exists(path("cancelled.svg")));
    }

    void aCancelledExportLeavesTheFileAsItWas_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"old.svg", "old.dxf", "old.obj", "old.json"}) {
            QTest::newRow(name) << name;
        }
    }

    void aCancelledExportLeavesTheFileAsItWas() {
        QFETCH(QString, name);
        const std::filesystem::path target = file(qPrintable(name));
        QVERIFY(writeFile(target, "as it was"));
        const auto job = exportJob(document(), target, {}, {}, [](const auto&) {});
        Progress progress;
        progress.cancel();
        const auto outcome = job->process(progress);
        QVERIFY(!outcome && outcome.error().code == ErrorCode::Cancelled);
        QCOMPARE(*readFile(target), std::string("as it was"));
        Progress another;
        QVERIFY(job->process(another));
        QVERIFY(*readFile(target) != "as it was");
    }

    void anExportThatFailsTouchesNothingElse() {
        QSignalSpy failed(&workspace().writing(), &JobRunner::failed);
        int after = 0;
        workspace().exportTo(file("no/such/folder.svg"));
        workspace().whenWritten([&] { ++after; });
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), 3);
        QVERIFY(waitUntilWritten());
        QCOMPARE(failed.count(), 1);
        QCOMPARE(after, 0);
        workspace().whenWritten([&] { ++after; });
        QCOMPARE(after, 1);
    }

    void anEndWritesWhatIsToBeWritten() {
        workspace().exportTo(file("last.svg"));
        workspace().exportTo(file("very last.svg"));
        close();
        QVERIFY(QFile::exists(path("last.svg")));
        QVERIFY(QFile::exists(path("very last.svg")));
    }
};

TOILE_WINDOW_TEST(WorkspaceWritingTest)
#include "workspace_writing_test.moc"
