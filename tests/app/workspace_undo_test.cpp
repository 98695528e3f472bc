// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/run_test.h"
#include "tests/app/support/workspace_fixture.h"

using namespace toile;

/// Steps back and forth: what they bring back at once, and what has to be made again.
class WorkspaceUndoTest : public QObject, public test::WorkspaceFixture {
    Q_OBJECT

private slots:
    void init() {
        renew();
        QVERIFY(openPair());
    }

    void cleanup() { close(); }

    void aCutIsOneStepAndUndoBringsEverythingBackAtOnce() {
        const DocumentState start = document().state();
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), 3);
        const DocumentState cut = document().state();
        workspace().undo();
        QVERIFY(document().state() == start);  // results and scene too: nothing is solved again
        QVERIFY(!workspace().jobs().isBusy());
        workspace().redo();
        QVERIFY(document().state() == cut);
        QVERIFY(!workspace().jobs().isBusy());
    }

    void undoTakesBackWhatIsStillOnItsWay() {
        const DocumentState start = document().state();
        cutAcross("waist", 210);
        QVERIFY(workspace().canUndo());
        workspace().undo();
        QVERIFY(waitUntilDone());
        QVERIFY(document().state() == start);
        QVERIFY(workspace().loading().seams.cuts.empty());
        QVERIFY(!workspace().canUndo());
    }

    void methodsAreUndoneWithTheirResults() {
        const DocumentState start = document().state();
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        workspace().undo();
        QVERIFY(document().state() == start);
    }

    void aStepBackWhileFlatteningDropsTheResult() {
        const DocumentState start = document().state();
        workspace().setMethod(Method::Abf);
        workspace().undo();
        QVERIFY(waitUntilDone());
        QVERIFY(document().state() == start);
    }

    void oldStatesAreMadeAgain_data() {
        QTest::addColumn<int>("bytes");
        QTest::newRow("scenes go") << 12000;  // of the results there is room for all
        QTest::newRow("everything goes") << 0;
    }

    void oldStatesAreMadeAgain() {
        QFETCH(int, bytes);
        renew();
        FlattenOptions options;
        options.method = Method::Curvature;
        document().setOptions(options);
        workspace().open({file("pair.obj")});
        QVERIFY(waitUntilDone());
        workspace().historyBudget().setMostBytes(static_cast<std::size_t>(bytes));
        std::vector<DocumentState> states{document().state()};
        cutAcross("waist", 210);
        QVERIFY(waitUntilDone());
        states.push_back(document().state());
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        states.push_back(document().state());
        const bool allGoes = bytes == 0;
        for (int step = 0; step < 2; ++step) {
            const DocumentState& kept = document().keptState(step);
            QVERIFY(!kept.scene);
            QCOMPARE(kept.results.empty(), allGoes);
            QCOMPARE(kept.letGo, allGoes);
        }
        const auto isAsItWas = [this](const DocumentState& before) {
            return waitUntilDone() && document().scene() && !document().state().letGo &&
                   test::difference(document().state(), before).isEmpty();
        };
        workspace().undo();
        workspace().undo();
        QVERIFY(waitUntilDone());
        QCOMPARE(test::difference(document().state(), states[0]), QString());
        QVERIFY(isAsItWas(states[0]));
        workspace().redo();
        workspace().redo();
        QVERIFY(waitUntilDone());
        if (!allGoes) {  // results found after an edit need not come again to the last bit
            QVERIFY(isAsItWas(states[2]));
        }
        QVERIFY(document().scene());
        QCOMPARE(document().pieceCount(), 3);
        QCOMPARE(document().options().method, Method::Natural);
    }

    void anotherStepBackWhileASceneIsMadeLeavesNoneOut() {
        workspace().historyBudget().setMostBytes(0);
        workspace().setEase(0, 0.01);
        workspace().setEase(1, 0.02);
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        while (workspace().canUndo()) {
            workspace().undo();  // the garment's ease is another each time, not its pieces
        }
        QVERIFY(waitUntilDone());
        QVERIFY(document().scene());
    }

    void cancellingLeavesSomethingToSee() {
        workspace().historyBudget().setMostBytes(0);
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        workspace().undo();
        workspace().jobs().cancel();
        QVERIFY(QTest::qWaitFor(
            [this] { return !workspace().jobs().isBusy() && document().scene(); }, kPatience));
        workspace().flattenAgain();
        QVERIFY(waitUntilDone());
        QVERIFY(!document().state().letGo);
    }

    void withinTheBudgetNothingGoes() {
        const DocumentState start = document().state();
        for (const Method method : {Method::Natural, Method::Curvature, Method::Lscm}) {
            workspace().setMethod(method);
            QVERIFY(waitUntilDone());
        }
        QVERIFY(document().keptState(0) == start);
        QVERIFY(document().keptState(2).scene);
    }

    void aStepBackToBeforeTheFirstResultsBringsThem_data() {
        QTest::addColumn<bool>("autoFlatten");
        QTest::newRow("flattened after every edit") << true;
        QTest::newRow("when asked for") << false;
    }

    void aStepBackToBeforeTheFirstResultsBringsThem() {
        QFETCH(bool, autoFlatten);
        workspace().setAutoFlatten(autoFlatten);
        const auto once =
            connect(&document(), &Document::changed, this, [this](DocumentChanges what) {
                if (what.testFlag(DocumentChange::Opened)) {
                    DocumentState next = document().state();
                    next.fabric = *fabricPreset("jersey");
                    document().edit("Fabric", std::move(next));
                }
            });
        workspace().open({file("other.obj")});
        QVERIFY(waitUntilDone());
        disconnect(once);
        QCOMPARE(document().history().count(), 1);
        workspace().undo();
        QVERIFY(document().results().empty() || isFlattened(document().state()));
        QVERIFY(waitUntilDone());
    }

    void undoTakesTheLastWishBackAlone() {
        cutAcross("waist", 210);
        workspace().changeSeams("Another", [](SeamsFile& seams) {
            seams.cuts.push_back({"hip", UserCut::Kind::Path, {{0, 110, 0}, {300, 110, 0}}, false});
        });
        QCOMPARE(workspace().undoText(), QString("Another"));
        workspace().undo();
        QCOMPARE(workspace().undoText(), QString("Cut"));
        QVERIFY(waitUntilDone());
        QCOMPARE(document().pieceCount(), 3);
        QCOMPARE(document().history().count(), 1);
    }

    void aCancelledFlatteningOfAnOldStateStaysCancelled() {
        workspace().historyBudget().setMostBytes(0);
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        workspace().undo();
        QVERIFY(document().state().letGo && !document().scene());
        workspace().cancel();
        QVERIFY(waitUntilIdle());
        QVERIFY(document().scene());  // something to see, and no more
        QVERIFY(document().state().letGo);
        workspace().redo();
        QVERIFY(waitUntilDone());
        workspace().undo();  // it is wanted anew
        QVERIFY(waitUntilDone());
    }

    void aStepBackAfterCancellingBringsWhatWasFlat() {
        workspace().historyBudget().setMostBytes(0);
        const DocumentState start = document().state();
        changeFabric("jersey");
        workspace().setMethod(Method::Natural);
        QVERIFY(waitUntilDone());
        workspace().undo();
        workspace().jobs().cancel();
        QVERIFY(waitUntilIdle());
        QVERIFY(document().state().letGo);
        workspace().undo();  // pieces and options stay
        QVERIFY(waitUntilDone());
        QCOMPARE(test::difference(document().state(), start), QString());
    }

    void aStepForwardToWhatIsFlatKeepsItToTheLastBit() {
        whenOpened([this] { changeFabric("jersey"); });
        workspace().open({file("other.obj")});
        QVERIFY(waitUntilDone());
        QCOMPARE(document().history().count(), 1);
        const DocumentState flat = document().state();
        workspace().undo();
        QVERIFY(workspace().jobs().isBusy());  // nothing is flat there
        workspace().redo();
        QVERIFY(document().state() == flat);
        QVERIFY(waitUntilIdle());
        QVERIFY(document().state() == flat);
    }

    void aStepBackToAnotherMethodBeforeTheFirstResultsBringsThem() {
        workspace().setAutoFlatten(false);
        whenOpened([this] { workspace().setMethod(Method::Natural); });
        workspace().open({file("other.obj")});
        QVERIFY(waitUntilDone());
        workspace().undo();
        QVERIFY(waitUntilDone());
        QCOMPARE(document().results()[0]->options.method, Method::Isometric);
    }

    void whatUndoTakesBackIsNoCancelling() {
        QSignalSpy cancelled(&workspace().jobs(), &JobRunner::cancelled);
        cutAcross("waist", 210);
        workspace().undo();
        QVERIFY(waitUntilIdle());
        workspace().setMethod(Method::Natural);
        workspace().undo();
        QVERIFY(waitUntilIdle());
        QCOMPARE(cancelled.count(), 2);
        QVERIFY(cancelled[0][1].toBool() && cancelled[1][1].toBool());
        workspace().setMethod(Method::Natural);  // and so nothing has been declined
        QVERIFY(waitUntilDone());
    }
};

TOILE_WINDOW_TEST(WorkspaceUndoTest)
#include "workspace_undo_test.moc"
