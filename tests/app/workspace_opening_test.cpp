// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/workspace_fixture.h"

using namespace toile;
using namespace toile::app;

/// What is on its way to become the open garment, and what is done meanwhile.
class WorkspaceOpeningTest : public QObject, public test::WorkspaceFixture {
    Q_OBJECT

private slots:
    void init() {
        renew();
        QVERIFY(openPair());
    }

    void cleanup() { close(); }

    void whatIsFlatWhenItIsOpenedIsNotFlattenedAgain() {
        const test::Moment flat = test::momentOf(document());
        QSignalSpy started(&workspace().jobs(), &JobRunner::started);
        test::open(document(), flat);
        QVERIFY(test::momentOf(document()) == flat);
        QVERIFY(!workspace().jobs().isBusy());
        QCOMPARE(started.count(), 0);
    }

    void stepsLeaveTheReadingOfAFileAlone() {
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        workspace().open({file("other.obj")});
        document().history().undo();  // to what is flat already
        QVERIFY(waitUntilDone());
        QCOMPARE(document().title(), QString("other.obj"));
    }

    void whatIsEditedWhileAFileIsReadIsAskedAbout() {
        int asked = 0;
        std::function<void()> leave;
        workspace().askBeforeLeaving([&](std::function<void()> next) {
            ++asked;
            leave = std::move(next);
        });
        workspace().open({file("other.obj")});
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());  // what stays open is flattened after all
        QCOMPARE(asked, 1);
        QCOMPARE(document().title(), QString("pair.obj"));
        QCOMPARE(document().results()[0]->options.method, Method::Natural);
        leave();
        QCOMPARE(document().title(), QString("other.obj"));
        QVERIFY(waitUntilDone());
        leave();  // an answer is good for one opening
        workspace().open({file("pair.obj")});
        QVERIFY(waitUntilDone());
        QCOMPARE(asked, 1);  // nothing was edited
        leave();
        QCOMPARE(document().title(), QString("pair.obj"));
    }

    void whatIsCutWhileAProjectIsReadIsNotCutInThat() {
        test::Moment coming = test::momentOf(document());
        coming.state.inputs.loading.seams.cuts = {
            {"cut 1", UserCut::Kind::Path, {{0, 110, 0}, {300, 110, 0}}, false, {1}}};
        coming.derived.inputs = coming.state.inputs;
        workspace().openBy(std::make_unique<test::ReadingJob>(
            [&] { workspace().arrived([&] { test::open(document(), coming); }); }));
        workspace().cuts().add({"", UserCut::Kind::Path, {{0, 210, 0}, {300, 210, 0}}, false});
        workspace().cuts().joinSeam(0);
        workspace().cuts().remove({1});
        QVERIFY(waitUntilDone());
        QVERIFY(workspace().loading().seams == coming.state.inputs.loading.seams);
        QVERIFY(!document().history().canUndo());
    }

    void readingOptionsWaitForTheProjectThatIsRead() {
        const test::Moment coming = test::momentOf(document());
        workspace().openBy(std::make_unique<test::ReadingJob>(
            [&] { workspace().arrived([&] { test::open(document(), coming); }); }));
        workspace().setUnit(LengthUnit::Inch);
        QVERIFY(waitUntilDone());
        QCOMPARE(document().garment()->files[0]->unit, LengthUnit::Inch);
    }

    void aReadingThatFailsLeavesTheGarmentAsItWas() {
        workspace().setMethod(Method::Natural);
        workspace().open({file("missing.obj")});  // takes the place of the flattening
        QVERIFY(waitUntilDone());
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), 3);
    }

    void aReadingThatIsCancelledGivesWayToWhatItHadReplaced() {
        workspace().setMethod(Method::Natural);
        workspace().open({file("other.obj")});
        workspace().cancel();
        QVERIFY(waitUntilDone());
        QCOMPARE(document().title(), QString("pair.obj"));
        QCOMPARE(document().results()[0]->options.method, Method::Natural);
        QVERIFY(!workspace().loading().unit);
    }

    void whatIsOpenedIsFlattenedWhateverIsEditedMeanwhile_data() {
        QTest::addColumn<bool>("cut");
        QTest::newRow("a method") << false;
        QTest::newRow("a cut") << true;
    }

    void whatIsOpenedIsFlattenedWhateverIsEditedMeanwhile() {
        QFETCH(bool, cut);
        workspace().open({file("other.obj")});
        QVERIFY(waitUntilDone());
        workspace().setAutoFlatten(false);  // as for a heavy garment
        whenOpened(
            [&] { cut ? cutAcross("waist", 210) : workspace().setMethod(Method::Curvature); });
        workspace().open({file("pair.obj")});
        QVERIFY(QTest::qWaitFor([this] { return document().history().count() == 1; }, kPatience));
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), cut ? 3 : 2);
    }

    void whatIsRequestedForAProjectIsNotMeantForFiles() {
        workspace().openBy(std::make_unique<test::ReadingJob>([] {}));
        workspace().setUnit(LengthUnit::Inch);
        workspace().open({file("pair.obj")});
        QVERIFY(!workspace().loading().unit);
        QVERIFY(waitUntilDone());
        QVERIFY(!document().loading().unit);
    }

    void whatCutsWereToldIsNotSaidOfAnotherGarment() {
        LoadOptions told = workspace().loading();
        told.isFrontSwapped = true;
        told.enoughStrain = 0.02;
        workspace().setLoading(told);
        QVERIFY(waitUntilDone());
        workspace().open({file("other.obj")});
        QVERIFY(waitUntilDone());
        QCOMPARE(document().title(), QString("other.obj"));
        QVERIFY(!document().loading().isFrontSwapped);
        QVERIFY(!document().loading().enoughStrain);
    }

    void whatTheOpenGarmentHasMayBeWishedForTheNext() {
        const test::Moment coming = test::momentOf(document());
        workspace().setUnit(LengthUnit::Inch);
        QVERIFY(waitUntilDone());
        workspace().openBy(std::make_unique<test::ReadingJob>(
            [&] { workspace().arrived([&] { test::open(document(), coming); }); }));
        workspace().setUnit(LengthUnit::Inch);
        QVERIFY(waitUntilDone());
        QCOMPARE(document().loading().unit, std::optional(LengthUnit::Inch));
        QCOMPARE(document().history().count(), 1);
    }

    void aCutOnItsWayGoesWithTheGarmentItWasMeantFor() {
        std::function<void()> leave;
        workspace().askBeforeLeaving([&](std::function<void()> next) { leave = std::move(next); });
        test::Moment coming = test::momentOf(document());
        workspace().openBy(std::make_unique<test::ReadingJob>(
            [&] { workspace().arrived([&] { test::open(document(), coming); }); }));
        changeFabric("jersey");
        QVERIFY(QTest::qWaitFor([&] { return bool(leave); }, kPatience));
        QVERIFY(waitUntilIdle());
        cutAcross("waist", 210);  // while the question is open
        QVERIFY(!document().isCurrent());
        leave();  // what comes is flat: no job takes the place of the cut's
        QVERIFY(document().isCurrent());
        QVERIFY(waitUntilIdle());
        QVERIFY(test::momentOf(document()) == coming);
        QVERIFY(!document().history().canUndo());
    }
};

TOILE_WINDOW_TEST(WorkspaceOpeningTest)
#include "workspace_opening_test.moc"
