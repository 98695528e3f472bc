// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/garment_jobs.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/workspace_fixture.h"

using namespace toile;
using namespace toile::app;

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
        document().history().undo();
        document().history().undo();
        QVERIFY(selectedIds() == back);
        document().setSelection({0});
        document().history().redo();
        QCOMPARE(document().selection(), (Document::Selection{0, 1}));  // both halves
        document().history().undo();
        QCOMPARE(document().selection(), Document::Selection{0});
    }

    void editsFollowOneAnother() {
        cutAcross("waist", 210);
        cutAcross("hip", 110);
        QCOMPARE(workspace().loading().seams.cuts.size(), std::size_t(2));
        QCOMPARE(document().pieceCount(), 2);
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), 4);
        QCOMPARE(document().history().count(), 2);
        document().history().undo();
        QVERIFY(waitUntilDone());  // nobody has worked this one out
        QCOMPARE(document().pieceCount(), 3);
        document().history().undo();
        QCOMPARE(document().pieceCount(), 2);
    }

    void anotherEditMeanwhileLosesNeither() {
        cutAcross("waist", 210);
        workspace().setMethod(Method::Curvature);
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), 3);
        QCOMPARE(document().results()[0]->options.method, Method::Curvature);
        QCOMPARE(document().history().count(), 2);
        document().history().undo();
        document().history().undo();
        QCOMPARE(document().options().method, Method::Isometric);
        QVERIFY(document().isFlattened());
    }

    void withoutFlatteningByItselfOnlyUnchangedPiecesStayFlat() {
        workspace().setAutoFlatten(false);
        cutAcross("waist", 210);
        QVERIFY(waitUntilIdle());
        QCOMPARE(document().pieceCount(), 3);
        QVERIFY(!document().isFlattened());
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

    void whatCannotBeSettledIsAskedForOnce() {
        // Warm, of lines that are no longer asked for, and nobody wants it flattened again.
        Derived old = document().derived();
        for (auto& result : old.results) {
            auto warm = std::make_shared<PieceResult>(*result);
            warm->flat->warm = true;
            result = warm;
        }
        old.lines.reset();
        workspace().setAutoFlatten(false);
        document().show(std::move(old), document().state().settings);
        workspace().cancel();
        QVERIFY(waitUntilIdle());
    }

    void unitIsReadAgainAsAStep() {
        const test::Moment start = test::momentOf(document());
        workspace().setUnit(LengthUnit::Inch);
        QCOMPARE(workspace().loading().unit, std::optional(LengthUnit::Inch));
        QVERIFY(waitUntilDone());
        QCOMPARE(document().garment()->files[0]->unit, LengthUnit::Inch);
        document().history().undo();
        QVERIFY(test::momentOf(document()) == start);
        QCOMPARE(workspace().loading().unit, std::nullopt);
    }

    void flatteningAgainLeavesWhatIsFlatToTheLastBit() {
        const test::Moment start = test::momentOf(document());
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        document().history().undo();
        workspace().flattenAgain();  // the flattener comes from the garment with the cut
        QVERIFY(waitUntilDone());
        QVERIFY(document().results() == start.derived.results);
        QVERIFY(document().state().settings == start.state.settings);
    }

    void whatAJobKeptFromBeingFlattenedFollows() {
        workspace().setMethod(Method::Natural);  // on its way
        workspace().jobs().cancel();
        QVERIFY(waitUntilIdle());
        QVERIFY(!document().isFlattened());
        workspace().flattenAgain();
        DocumentState moved = document().state();
        test::said(moved, document(), 0).quantity = 3;
        document().edit("Quantity", moved);
        QVERIFY(waitUntilDone());
        document().history().undo();  // to before the results came, while something else runs
        workspace().exportTo(path("out.json").toStdU16String());
        QVERIFY(waitUntilDone());
    }

    void aReadingThatFailsIsForgottenAndTheRestIsFlattened() {
        QVERIFY(QFile::copy(path("pair.obj"), path("gone.obj")));
        workspace().open({path("gone.obj").toStdU16String()});
        QVERIFY(waitUntilDone());
        QVERIFY(QFile::remove(path("gone.obj")));
        QSignalSpy failed(&workspace().jobs(), &JobRunner::failed);
        workspace().setMethod(Method::Curvature);
        workspace().reload();  // takes the place of the flattening
        QVERIFY(waitUntilDone());
        QCOMPARE(failed.count(), 1);
        QCOMPARE(document().options().method, Method::Curvature);
        workspace().setUnit(LengthUnit::Metre);  // of what was read once
        QVERIFY(waitUntilDone());
        QCOMPARE(document().garment()->files[0]->unit, LengthUnit::Metre);
        QCOMPARE(failed.count(), 1);
    }

    void anEditThatChangesNothingIsNoStep() {
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        const CutId cut = document().garment()->cuts.at(0).id;
        workspace().cuts().remove(cut);
        workspace().cuts().remove(cut);  // a second click
        QVERIFY(waitUntilDone());
        QCOMPARE(document().history().count(), 2);
        QVERIFY(!document().history().canRedo());
        QCOMPARE(document().pieceCount(), 2);
    }

    void aSecondCutLeavesWhatTheFirstMade() {
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        const PieceResults before = document().results();
        const auto settings = document().settings();
        workspace().setAutoFlatten(false);
        workspace().cuts().change("Cut", [](SeamsFile& seams) {
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

    void theGrainOfAnEarlierFlatteningIsNotTaken() {
        workspace().open({file("cap.obj")});
        QVERIFY(waitUntilDone());
        workspace().setMethod(Method::Curvature);
        QVERIFY(waitUntilDone());
        PieceGrains found;
        bool outdated = true;
        const auto done = [&](const PieceGrains& grains, bool old, const GrainShares&) {
            found = grains;
            outdated = old;
        };
        Progress progress;
        const auto first = grainJob(document(), GrainRule::Vertical, {0, 1}, done);
        const auto second = grainJob(document(), GrainRule::Vertical, {0, 1}, done);
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
        document().setSeamEase(0, 0.01);  // is not seen by the flattening
        QVERIFY(waitUntilDone());
        QCOMPARE(started.count(), 1);
    }

    void flatteningThatIsNotAutomaticAnyMoreIsDoneToItsEnd() {
        workspace().setMethod(Method::Natural);
        workspace().setAutoFlatten(false);
        document().setSeamEase(0, 0.01);
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

    void anEditThatIsCancelledGivesWayToWhatItHadReplaced() {
        workspace().setMethod(Method::Natural);
        cutAcross("waist", 210);
        workspace().cancel();
        QVERIFY(document().isCurrent() && !document().history().canRedo());
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), 2);
        QCOMPARE(document().results()[0]->options.method, Method::Natural);
    }

    void whatIsAskedForAfterCancellingIsNotCancelledWithIt() {
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
        document().setSeamEase(0, 0.01);
        QVERIFY(waitUntilIdle());
        QVERIFY(!workspace().jobs().isBusy());
        QVERIFY(!document().isFlattened());
        workspace().setMethod(Method::Curvature);
        QVERIFY(waitUntilDone());
    }

    void aRemovalThatIsTakenBackBringsTheCutAtOnce() {
        const test::Moment start = test::momentOf(document());
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        const test::Moment cut = test::momentOf(document());
        workspace().cuts().remove(document().garment()->cuts.at(0).id);
        QCOMPARE(document().garment(), start.derived.garment);  // known from before
        QVERIFY(!workspace().jobs().isBusy());
        document().history().undo();
        QVERIFY(!workspace().jobs().isBusy());
        QVERIFY(test::momentOf(document()) == cut);
    }
};

TOILE_WINDOW_TEST(WorkspaceTest)
#include "workspace_test.moc"
