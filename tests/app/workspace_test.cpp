// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/garment_jobs.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/workspace_fixture.h"

using namespace toile;

/// Edits that take a job: how they follow one another, and what is flattened after them.
class WorkspaceTest : public QObject, public test::WorkspaceFixture {
    Q_OBJECT

private slots:
    void init() {
        renew();
        QVERIFY(openPair());
    }

    void cleanup() { close(); }

    void piecesThatNoCutTouchesKeepResultAndPlace() {
        const auto back = document().results()[1];
        const auto place = document().settings()[1];
        const int colour = document().colours()[1];
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        const auto& results = document().results();
        const auto at = std::find(results.begin(), results.end(), back);
        QVERIFY(at != results.end());
        QVERIFY(document().settings()[std::size_t(at - results.begin())] == place);
        QCOMPARE(document().colours()[std::size_t(at - results.begin())], colour);
    }

    void theSelectionStaysWithItsPieces() {
        const auto selectedIds = [this] {
            std::set<PieceId> ids;
            for (const int piece : document().selection()) {
                ids.insert(document().garment()->pieces[std::size_t(piece)]->id);
            }
            return ids;
        };
        document().setSelection({1});
        const auto back = selectedIds();
        cutAcross("waist", 210);  // in the front, which is listed before it
        QVERIFY(waitUntilDone());
        QCOMPARE(document().selection(), Document::Selection{2});
        QVERIFY(selectedIds() == back);
        workspace().reload();
        QVERIFY(waitUntilDone());
        QVERIFY(selectedIds() == back);
        workspace().undo();
        workspace().undo();
        QVERIFY(selectedIds() == back);
        document().setSelection({0});
        workspace().redo();
        QCOMPARE(document().selection(), (Document::Selection{0, 1}));  // both halves
        workspace().undo();
        QCOMPARE(document().selection(), Document::Selection{0});
    }

    void wishesFollowOneAnother() {
        cutAcross("waist", 210);
        cutAcross("hip", 110);
        QCOMPARE(workspace().loading().seams.cuts.size(), std::size_t(2));
        QCOMPARE(document().loading().seams.cuts.size(), std::size_t(0));
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), 4);
        QCOMPARE(document().history().count(), 2);
        workspace().undo();
        QCOMPARE(document().pieceCount(), 3);
        workspace().undo();
        QCOMPARE(document().pieceCount(), 2);
    }

    void anotherEditMeanwhileLosesNeither() {
        cutAcross("waist", 210);
        workspace().setMethod(Method::Curvature);
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), 3);
        QCOMPARE(document().results()[0]->options.method, Method::Curvature);
        QCOMPARE(document().history().count(), 2);
        workspace().undo();
        workspace().undo();
        QCOMPARE(document().options().method, Method::Isometric);
        QVERIFY(isFlattened(document().state()));
    }

    void withoutFlatteningByItselfOnlyUnchangedPiecesStayFlat() {
        workspace().setAutoFlatten(false);
        cutAcross("waist", 210);
        QVERIFY(waitUntilIdle());
        QCOMPARE(document().pieceCount(), 3);
        QVERIFY(!isFlattened(document().state()));
        QVERIFY(!workspace().canExport());
        int flat = 0;
        for (int i = 0; i < 3; ++i) {
            flat += document().result(i) != nullptr;
        }
        QCOMPARE(flat, 1);
        workspace().setAutoFlatten(true);
        QVERIFY(waitUntilDone());
        QVERIFY(workspace().canExport());
    }

    void unitIsReadAgainAsAStep() {
        const auto start = document().state();
        workspace().setUnit(LengthUnit::Inch);
        QCOMPARE(workspace().loading().unit, std::optional(LengthUnit::Inch));
        QVERIFY(waitUntilDone());
        QCOMPARE(document().garment()->files[0]->unit, LengthUnit::Inch);
        workspace().undo();
        QVERIFY(document().state() == start);
        QCOMPARE(workspace().loading().unit, std::nullopt);
    }

    void flatteningAgainLeavesWhatIsFlatToTheLastBit() {
        const DocumentState start = document().state();
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        workspace().undo();
        workspace().flattenAgain();  // the flattener comes from the garment with the cut
        QVERIFY(waitUntilDone());
        QVERIFY(document().results() == start.results);
        QVERIFY(document().settings() == start.settings);
    }

    void whatAJobKeptFromBeingFlattenedFollows() {
        workspace().setMethod(Method::Natural);  // on its way
        workspace().jobs().cancel();
        QVERIFY(waitUntilIdle());
        QVERIFY(!isFlattened(document().state()));
        workspace().flattenAgain();
        DocumentState moved = document().state();
        moved.settings[0].quantity = 3;
        document().edit("Quantity", moved);
        QVERIFY(waitUntilDone());
        workspace().undo();  // to before the results came, while something else runs
        workspace().exportTo(path("out.json").toStdU16String());
        QVERIFY(waitUntilDone());
    }

    void aWishThatFailsIsForgottenAndTheRestIsFlattened() {
        QVERIFY(QFile::copy(path("pair.obj"), path("gone.obj")));
        workspace().open({path("gone.obj").toStdU16String()});
        QVERIFY(waitUntilDone());
        QVERIFY(QFile::remove(path("gone.obj")));
        QSignalSpy failed(&workspace().jobs(), &JobRunner::failed);
        workspace().setMethod(Method::Curvature);
        workspace().setUnit(LengthUnit::Metre);  // takes the place of the flattening
        QVERIFY(waitUntilDone());
        QCOMPARE(failed.count(), 1);
        QVERIFY(!workspace().loading().unit);
        QCOMPARE(document().options().method, Method::Curvature);
    }

    void aWishThatChangesNothingIsNoStep() {
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        workspace().removeCut(document().garment()->cuts.at(0).id);
        workspace().removeCut(
            document().garment()->cuts.at(0).id);  // a second click, while the first is on its way
        QVERIFY(waitUntilDone());
        QCOMPARE(document().history().count(), 2);
        QVERIFY(!workspace().canRedo());
        QCOMPARE(document().pieceCount(), 2);
    }

    void aSecondCutLeavesWhatTheFirstMade() {
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        const PieceResults before = document().results();
        const auto settings = document().settings();
        workspace().setAutoFlatten(false);
        workspace().changeSeams("Cut", [](SeamsFile& seams) {
            seams.cuts.push_back(
                {"back", UserCut::Kind::Path, {{500, 0, 0}, {500, 100, 0}}, false});
        });
        QVERIFY(waitUntilIdle());
        QCOMPARE(document().pieceCount(), 4);
        for (std::size_t i = 0; i < 2; ++i) {  // "front 1" and "front 2"
            QCOMPARE(document().results()[i], before[i]);
            QVERIFY(document().settings()[i] == settings[i]);
        }
        QVERIFY(!document().results()[2]);
    }

    void theBestGrainOfAnEarlierFlatteningIsNotTaken() {
        workspace().open({file("cap.obj")});
        QVERIFY(waitUntilDone());
        workspace().setMethod(Method::Curvature);
        QVERIFY(waitUntilDone());
        PieceGrains found;
        bool outdated = true;
        const auto done = [&](const PieceGrains& grains, bool old) {
            found = grains;
            outdated = old;
        };
        Progress progress;
        const auto first = grainJob(document(), {0, 1}, done);
        const auto second = grainJob(document(), {0, 1}, done);
        QVERIFY(first->process(progress) && second->process(progress));
        first->finalize();
        QVERIFY(!found.empty());
        QVERIFY(!outdated);
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        second->finalize();
        QVERIFY(found.empty());
        QVERIFY(outdated);
    }

    void whatIsUnderWayIsNotBegunAgain() {
        QSignalSpy started(&workspace().jobs(), &JobRunner::started);
        workspace().setMethod(Method::Natural);
        workspace().setAutoFlatten(true);
        workspace().flattenAgain();
        workspace().setEase(0, 0.01);  // is not seen by the flattening
        QVERIFY(waitUntilDone());
        QCOMPARE(started.count(), 1);
    }

    void flatteningThatIsNotAutomaticAnyMoreIsDoneToItsEnd() {
        workspace().setMethod(Method::Natural);
        workspace().setAutoFlatten(false);
        workspace().setEase(0, 0.01);
        QVERIFY(waitUntilDone());
    }

    void aFlatteningThatIsAskedForOutlivesEdits_data() {
        QTest::addColumn<bool>("cut");
        QTest::newRow("a method") << false;
        QTest::newRow("a cut") << true;
    }

    void aFlatteningThatIsAskedForOutlivesEdits() {
        QFETCH(bool, cut);
        workspace().setAutoFlatten(false);
        workspace().setMethod(Method::Natural);
        QVERIFY(!workspace().jobs().isBusy());
        workspace().flattenAgain();
        cut ? cutAcross("waist", 210) : workspace().setMethod(Method::Curvature);
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), cut ? 3 : 2);
        workspace().setMethod(Method::Lscm);  // nobody has asked for this one
        QVERIFY(!workspace().jobs().isBusy());
    }

    void aWishThatIsCancelledGivesWayToWhatItHadReplaced() {
        workspace().setMethod(Method::Natural);
        cutAcross("waist", 210);
        workspace().cancel();
        QVERIFY(!workspace().hasWishes() && !workspace().canRedo());
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), 2);
        QCOMPARE(document().results()[0]->options.method, Method::Natural);
    }

    void whatIsWishedForAfterCancellingIsNotCancelledWithIt() {
        cutAcross("waist", 210);
        workspace().cancel();
        cutAcross("hip", 110);
        QVERIFY(waitUntilDone());
        QCOMPARE(workspace().loading().seams.cuts.size(), std::size_t(1));
        QCOMPARE(document().loading().seams.cuts[0].name, std::string("hip"));
    }

    void cancelledFlatteningWaitsForAnotherEditOrOrder() {
        workspace().setMethod(Method::Natural);
        workspace().cancel();
        changeFabric("jersey");
        workspace().setEase(0, 0.01);
        QVERIFY(waitUntilIdle());
        QVERIFY(!workspace().jobs().isBusy());
        QVERIFY(!isFlattened(document().state()));
        workspace().setMethod(Method::Curvature);
        QVERIFY(waitUntilDone());
    }

    void aWishThatAStepHasDoneIsDroppedWithItsJob() {
        const DocumentState start = document().state();
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        QSignalSpy cancelled(&workspace().jobs(), &JobRunner::cancelled);
        workspace().removeCut(document().garment()->cuts.at(0).id);
        document().history().undo();  // in the list of steps
        QVERIFY(!workspace().hasWishes());
        QVERIFY(waitUntilIdle());
        QVERIFY(document().state() == start);
        QCOMPARE(cancelled.count(), 1);
        QVERIFY(cancelled[0][1].toBool());  // nobody needs to hear of it
    }
};

TOILE_WINDOW_TEST(WorkspaceTest)
#include "workspace_test.moc"
